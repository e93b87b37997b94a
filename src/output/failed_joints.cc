// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/failed_joints.h>

#include <cmath>

namespace hybrid::output
{
  void count_failed_joints(const dda::Model &model, const dda::DdaState &state, Summary &summary)
  {
    for (std::size_t j = 0; j < state.joints.size(); ++j)
      {
        const dda::JointState &joint = state.joints[j];
        if (joint.failure == dda::FailureKind::none)
          continue;
        const bool             is_torn = joint.failure == dda::FailureKind::tensile;
        const bool             settled = joint.failure_time < 0.;
        Summary::FailedJoints &count   = settled ? summary.static_joints : summary.joints;
        ++(is_torn ? count.tensile : count.shear);
        if (settled)
          continue;
        summary.first_failure_time = std::fmin(summary.first_failure_time, joint.failure_time);
        if (model.joints[j].law.loses_by_failing(is_torn))
          summary.first_loss_time = std::fmin(summary.first_loss_time, joint.failure_time);
      }
  }
} // namespace hybrid::output
