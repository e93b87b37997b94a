// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/block/boundary_edge.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /**
   * Forces of the artificial boundaries on one block's edge.
   *
   * The force on Gauss point k is F_k - w Z v_k with its weight w, velocity v_k
   * and the incoming force F_k = w (t_in + Z v_ff), which whoever knows the
   * motion beyond the boundary provides: (x, y) per point, two points per edge
   * of Model::boundary [N/m].
   */
  class ViscousBoundary
  {
  public:
    /// @param first, second ends of the edge now [m].  @param motion of the block since the start
    /// of the step.
    ViscousBoundary(const BoundaryEdge &edge,
                    const Vec2         &first,
                    const Vec2         &second,
                    const BlockMotion  &motion);

    /// Generalised incoming force; @p incoming of this edge.
    Vec6 incoming(const double *force) const;

    /// Generalised force of the dashpots at the block's @p rate.
    Vec6 dashpots(const Vec6 &rate) const;

    /// D with dashpots() = -D rate.
    Mat6 damping() const;

  private:
    Eigen::Matrix2d             impedance; ///< w Z [N s/m per m]
    Eigen::Matrix<double, 2, 6> gradient[BoundaryEdge::n_points];
  };
} // namespace hybrid::dda
