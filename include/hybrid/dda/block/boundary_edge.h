// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /// Where an artificial boundary is.
  enum class BoundaryPart
  {
    base,
    left,
    right
  };


  /**
   * An edge of a block on an artificial boundary of the bedrock.
   *
   * The traction on it is t = t_in + Z (v_ff - v) with the outward normal n
   * and Z = rho (c_p n n^T + c_s (I - n n^T)) (Lysmer & Kuhlemeyer 1969). It is
   * integrated over the edge with two Gauss points, exactly for the block's
   * linear velocity.
   */
  struct BoundaryEdge
  {
    BoundaryPart part;
    int          block;
    int          vertex;                   ///< first end, counter-clockwise
    Vec2         ends[2];                  ///< initial places [m]
    double       density;                  ///< of the block [kg/m3]
    double       lambda;                   ///< of the block [Pa]
    double       shear;                    ///< G of the block [Pa]
    double       p_impedance, s_impedance; ///< rho c_p and rho c_s of the rock beyond [Pa s/m]

    static constexpr int n_points = 2;

    /// Position of Gauss point @p k on the edge [-].
    static double position(const int k)
    {
      constexpr double offset = 0.28867513459481287; // 1 / (2 sqrt(3))
      return k == 0 ? 0.5 - offset : 0.5 + offset;
    }

    /// Length that a Gauss point stands for [m].
    double weight() const
    {
      return 0.5 * (ends[1] - ends[0]).norm();
    }

    /// Outward normal [-].
    Vec2 normal() const
    {
      const Vec2 along = (ends[1] - ends[0]).normalized();
      return {along.y(), -along.x()};
    }

    /// Z [Pa s/m].
    Eigen::Matrix2d impedance() const
    {
      const Vec2            n      = normal();
      const Eigen::Matrix2d across = n * n.transpose();
      return p_impedance * across + s_impedance * (Eigen::Matrix2d::Identity() - across);
    }
  };
} // namespace hybrid::dda
