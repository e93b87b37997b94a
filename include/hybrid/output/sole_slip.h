// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/surface_line.h>
#include <hybrid/dda/model/ground_lines.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/restart/archive_forward.h>

#include <vector>

namespace hybrid::output
{
  /**
   * How far the mass has slid on what it stands on.
   *
   * The slip of a sole (dda/model/soles.h) is a way along the surface, R angle on a circle of
   * radius R: from the point of the ground that was nearest to the sole's point at rest to the one
   * that is nearest now. It is positive downhill of its block (dda/model/downhill.h), along +x
   * where that is level. What was at that first point goes with the block, as if it were glued to
   * the sole. The surface is that at rest, and the displacement of the first point since then is
   * taken off, so that ground that shakes makes no slip. Dips that soles of mean length do not lie
   * in are crossed straight (dda::without_dips()).
   *
   * Nothing is summed up over steps, so it is the same whatever holds the sole: joints, contacts or
   * nothing. Of a block that flies or rolls it is the way to the place of the surface that is
   * nearest, whether it touches it again or not; it jumps where that is another one, as above a
   * concave bend. Beyond the end of a surface that ends it goes on along the last piece.
   */
  class SoleSlip
  {
  public:
    /// @param blocks may be nullptr.
    explicit SoleSlip(const dda::Model *blocks);

    int n_soles() const
    {
      return static_cast<int>(soles.size());
    }

    /// The point of a sole whose slip it is, as drawn [m].
    const Vec2 &position(const int sole) const
    {
      return soles[sole].position;
    }

    /// The first vertex of a sole: of its block.
    int vertex(const int sole) const
    {
      return soles[sole].first;
    }

    /// Sign of x downhill, 0: level.
    double downhill(const int sole) const
    {
      return downhill(soles[sole]);
    }

    /// Number of the slide that it belongs to.
    int slide(const int sole) const
    {
      return model->downhill.slide[model->initial.block_of[soles[sole].first]];
    }

    /// [m]
    double length(const int sole) const
    {
      return soles[sole].length;
    }

    /// Slip counts from @p state.
    void set_reference(const dda::DdaState &state);

    /// Slip of all soles [m].
    std::vector<double> values(const dda::DdaState &state) const;

    /// Part of the soles' length of which @p slip is larger than @p threshold, either way [-].
    double part_beyond(const std::vector<double> &slip, double threshold) const;

    /// Mean of @p slip, weighted by the soles' lengths [m].
    double mean(const std::vector<double> &slip) const;

    /// Number of the sole that has slid farthest, either way; 0 if nothing has.
    static int farthest(const std::vector<double> &slip);

    /// Reference, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    struct Sole : dda::Sole
    {
      int    line      = 0;            ///< of the ground, that it lies on
      Vec2   glued     = Vec2::Zero(); ///< from its point to the ground, along it and normal [m]
      Vec2   rest      = Vec2::Zero(); ///< ground_of() at rest [m]
      double first_way = 0.;           ///< along the line at rest [m]
    };

    const dda::Model              *model;
    std::vector<Sole>              soles;
    std::vector<dda::GroundLine>   lines;
    std::vector<double>            mean_length; ///< of the soles on each line; 0: none [m]
    std::vector<std::vector<Vec2>> at_rest;     ///< points of each line, without dips [m]
    std::vector<dda::SurfaceLine>  surface;     ///< through these

    /// Sign of x; 0: level.
    double downhill(const dda::Sole &sole) const;

    /// Where the ground is that a sole lay on, up to a constant [m].
    static Vec2 ground_of(const dda::DdaState &state, const Sole &sole);

    /// Way along its line to what is glued to a sole [m].
    double way(const dda::DdaState &state, const Sole &sole) const;

    /// From the points at rest.
    void make_surface();
  };
} // namespace hybrid::output
