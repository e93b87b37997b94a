// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint_failure.h>

#include <algorithm>

namespace hybrid::dda
{
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
    // Far apart, the ends of the edge no longer stand for the contact: vertices and edges take
    // over.
    constexpr double released_part = 0.1;
    const double     reach         = released_part * joint.length;
    if (state.failure != FailureKind::none && !joint.within_bedrock() &&
        (std::max(state.points[0].jump.norm(), state.points[1].jump.norm()) > reach))
      state.released = true;
  }
} // namespace hybrid::dda
