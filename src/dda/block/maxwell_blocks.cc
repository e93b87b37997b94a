// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/maxwell_blocks.h>
#include <hybrid/scene/input_error.h>

#include <Eigen/LU>

namespace hybrid::dda
{
  Eigen::Matrix3d branch_stiffness(const Eigen::Matrix3d &corrected,
                                   const Eigen::Matrix3d &material,
                                   const MaxwellBody     &body)
  {
    const Eigen::Matrix3d v       = corrected * material.inverse() * corrected;
    const Eigen::Matrix3d relaxed = corrected + (body.relaxed - 1.) * v;
    if (relaxed(0, 0) + relaxed(0, 1) <= 0. || relaxed(2, 2) <= 0.)
      throw InputError("Maxwell damping/Block ratio: elastic joints bear so much of the compliance "
                       "that blocks which make up for them would have no stiffness in the long "
                       "term; a larger Blocks/Penalty ratio or a smaller ratio would do");
    return v;
  }
} // namespace hybrid::dda
