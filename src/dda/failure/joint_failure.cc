// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/failure/joint_failure.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Part of a joint's length: neighbours that do not look at each other before overlap by about
    /// twice this at most, and elastic joints do not reach it.
    constexpr double yield_fraction = 0.0025;

    /// Part of a joint's length: ends that are farther apart no longer stand for the contact.
    constexpr double release_fraction = 0.1;



    /// Slip or opening of a joint of the body from which its blocks look at all their neighbours
    /// [m]. In the static stage blocks that yield fail through small slips on many edges, and
    /// corners that catch would make them stronger; where they flow, corners must not pass.
    double waking_slip(const Joint &joint, const double time, const bool blocks_yield)
    {
      return (blocks_yield && time < 0. ? release_fraction : yield_fraction) * joint.length;
    }



    /// Slip that friction has taken, or opening [m].
    double yielding(const SpringState &point)
    {
      return std::max(std::abs(point.history.plastic_slip), point.gap);
    }



    /// How deep the joint has slid into an edge that rises beyond its end [m].
    double sunk(const Joint &joint, const JointState &state)
    {
      double deepest = 0.;
      for (const SpringState &point : state.points)
        {
          const double slip = point.history.plastic_slip;
          deepest           = std::max(deepest, std::abs(slip) * joint.valley[slip > 0. ? 0 : 1]);
        }
      return deepest;
    }



    /// True if an end is torn and so wide open that the two edges have turned apart: between the
    /// ends the bond is open everywhere but at the tip.
    bool gapes(const Joint &joint, const JointState &state)
    {
      const auto wide = [&](const SpringState &point) {
        return joint.law.broken_in_tension(point.history) &&
               point.gap > release_fraction * joint.length;
      };
      return wide(state.points[0]) || wide(state.points[1]);
    }
  } // namespace



  void
  update_failure(const Joint &joint, const double time, JointState &state, const bool blocks_yield)
  {
    if (joint.kind == JointKind::bedding)
      return; // its own record says what it does (run.h5)
    const auto broken = [&](const SpringState &point) {
      return joint.law.broken_in_tension(point.history) || joint.law.broken_in_shear(point.history);
    };
    const bool ended = (broken(state.points[0]) && broken(state.points[1])) || gapes(joint, state);
    if (state.failure == FailureKind::none && ended)
      {
        const bool tensile = joint.law.broken_in_tension(state.points[0].history) ||
                             joint.law.broken_in_tension(state.points[1].history);
        state.failure      = tensile ? FailureKind::tensile : FailureKind::shear;
        state.failure_time = time;
      }
    const double has_yielded = std::max(yielding(state.points[0]), yielding(state.points[1]));
    const bool   has_sunk    = sunk(joint, state) > yield_fraction * joint.length;
    if (has_sunk && joint.kind == JointKind::body)
      {
        if (state.failure == FailureKind::none)
          {
            state.failure      = FailureKind::shear;
            state.failure_time = time;
          }
        state.released = true;
      }
    if (state.failure != FailureKind::none || has_sunk ||
        (joint.kind == JointKind::body && has_yielded > waking_slip(joint, time, blocks_yield)))
      state.has_yielded = true;
    const double reach = release_fraction * joint.length;
    if (state.failure != FailureKind::none && !joint.within_bedrock() &&
        (std::max(state.points[0].jump.norm(), state.points[1].jump.norm()) > reach))
      state.released = true;
  }
} // namespace hybrid::dda
