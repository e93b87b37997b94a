// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/foundation_stiffness.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /**
   * What the blocks stand on, as seen from one time step.
   *
   * Either the motion of the foundation nodes is prescribed, or the foundation is one more
   * body with dynamic stiffness S and load g: S w = g + (f - f_static), where
   * w is the displacement of the nodes at the end of the step and f the forces
   * of the blocks on them.
   */
  struct FoundationResponse
  {
    bool                prescribed = true;
    Eigen::VectorXd     displacement; ///< prescribed w, or the first guess of it [m]
    FoundationStiffness stiffness;    ///< S
    Eigen::VectorXd     load;         ///< g [N/m]
    Eigen::VectorXd boundary_force; ///< incoming, see ViscousBoundary [N/m]; empty: no dashpots act
  };
} // namespace hybrid::dda
