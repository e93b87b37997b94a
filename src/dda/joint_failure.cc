// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint_failure.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Part of a joint's length: neighbours that do not look at each other before overlap by about
    /// twice this at most, and elastic joints do not reach it.
    constexpr double loosened_part = 0.0025;



    /// Slip that friction has taken, or opening [m].
    double way_given(const SpringState &point)
    {
      return std::max(std::abs(point.history.plastic_slip), point.gap);
    }
  } // namespace



  void update_failure(const Joint &joint, const double time, JointState &state)
  {
    if (joint.kind == JointKind::bedding)
      return; // its own record says what it does (run.h5)
    const auto broken = [&](const SpringState &point) {
      return joint.law.broken_in_tension(point.history) || joint.law.broken_in_shear(point.history);
    };
    if (state.failure == FailureKind::none && broken(state.points[0]) && broken(state.points[1]))
      {
        const bool tensile = joint.law.broken_in_tension(state.points[0].history) ||
                             joint.law.broken_in_tension(state.points[1].history);
        state.failure      = tensile ? FailureKind::tensile : FailureKind::shear;
        state.failure_time = time;
      }
    const double given_way = std::max(way_given(state.points[0]), way_given(state.points[1]));
    const bool   may_wake  = joint.kind == JointKind::body && time >= 0.;
    if (state.failure != FailureKind::none ||
        (may_wake && given_way > loosened_part * joint.length))
      state.loosened = true;
    // Far apart, the ends of the edge no longer stand for the contact: vertices and edges take
    // over.
    constexpr double released_part = 0.1;
    const double     reach         = released_part * joint.length;
    if (state.failure != FailureKind::none && !joint.within_bedrock() &&
        (std::max(state.points[0].jump.norm(), state.points[1].jump.norm()) > reach))
      state.released = true;
  }
} // namespace hybrid::dda
