// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/viscous_boundary.h>

namespace hybrid::dda
{
  ViscousBoundary::ViscousBoundary(const BoundaryEdge &edge,
                                   const Vec2         &first,
                                   const Vec2         &second,
                                   const BlockMotion  &motion)
    : impedance(edge.weight() * edge.impedance())
  {
    for (int k = 0; k < BoundaryEdge::n_points; ++k)
      {
        const double p     = BoundaryEdge::position(k);
        const Vec2   x     = (1. - p) * first + p * second;
        gradient[k].row(0) = motion.gradient(x, Vec2::UnitX());
        gradient[k].row(1) = motion.gradient(x, Vec2::UnitY());
      }
  }



  Vec6 ViscousBoundary::incoming(const double *force) const
  {
    Vec6 sum = Vec6::Zero();
    for (int k = 0; k < BoundaryEdge::n_points; ++k)
      sum += gradient[k].transpose() * Eigen::Map<const Eigen::Vector2d>(force + 2 * k);
    return sum;
  }



  Mat6 ViscousBoundary::damping() const
  {
    Mat6 sum = Mat6::Zero();
    for (int k = 0; k < BoundaryEdge::n_points; ++k)
      sum += gradient[k].transpose() * impedance * gradient[k];
    return sum;
  }



  Vec6 ViscousBoundary::dashpots(const Vec6 &rate) const
  {
    Vec6 sum = Vec6::Zero();
    for (int k = 0; k < BoundaryEdge::n_points; ++k)
      {
        const Eigen::Vector2d velocity = gradient[k] * rate;
        sum -= gradient[k].transpose() * (impedance * velocity);
      }
    return sum;
  }
} // namespace hybrid::dda
