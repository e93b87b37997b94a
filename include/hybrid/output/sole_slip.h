// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/restart/archive_forward.h>

#include <vector>

namespace hybrid::output
{
  /**
   * How far the mass has slid on what it stands on.
   *
   * The slip of a sole (dda/model/soles.h) is the displacement of its point relative to the point
   * of the ground that it lay on, since the state at rest, along the sole as it was then; positive
   * downhill of its block (dda/model/downhill.h), along +x where that is level. Nothing is summed
   * up over steps, so it is the same whatever holds the sole: joints, contacts or nothing, as of a
   * block that flies.
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
      Vec2 start = Vec2::Zero(); ///< the point relative to the ground at rest [m]
      Vec2 along = Vec2::Zero(); ///< unit vector at rest, downhill
    };

    const dda::Model *model;
    std::vector<Sole> soles;

    /// Sign of x; 0: level.
    double downhill(const dda::Sole &sole) const;

    /// The point of a sole relative to the ground point it started on [m].
    static Vec2 place(const dda::DdaState &state, const Sole &sole);
  };
} // namespace hybrid::output
