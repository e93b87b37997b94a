// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/restart/archive_forward.h>

#include <vector>

namespace hybrid::output
{
  /// A point of the ground: between two nodes of the base, or two vertices of a block of the
  /// bedrock.
  struct SoleGround
  {
    bool   base  = false; ///< else vertices
    int    first = -1, second = -1;
    double fraction = 0.; ///< of the path from the first to the second
  };


  /**
   * How far the mass has slid on what it stands on.
   *
   * A sole is an edge of a block of the mass that lies on the base or on the bedrock's blocks
   * before the first step: with its middle, or, where it bridges a dip, with another of its points.
   * Its slip is the displacement of that point relative to the point of the ground that it lay on,
   * since the state at rest, along the sole as it was then; positive downhill (along +x on a level
   * surface). Nothing is summed up over steps, so it is the same whatever holds the sole: joints,
   * contacts or nothing.
   */
  class SoleSlip
  {
  public:
    /// @param blocks may be nullptr.  @param downhill sign of x downhill, 0: level.
    SoleSlip(const dda::Model *blocks, double downhill);

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
    struct Sole
    {
      int        first, second; ///< vertices of the block, counter-clockwise
      double     fraction;      ///< of the path from the first to the second: the point that slides
      SoleGround ground;
      Vec2       position;
      double     length;
      Vec2       start = Vec2::Zero(); ///< the point relative to the ground at rest [m]
      Vec2       along = Vec2::Zero(); ///< unit vector at rest
    };

    const double      sign; ///< of the block's edge, for a slip that is positive downhill
    std::vector<Sole> soles;

    void find_soles(const dda::Model &model);

    /// The point of a sole relative to the ground point it started on [m].
    static Vec2 place(const dda::DdaState &state, const Sole &sole);
  };
} // namespace hybrid::output
