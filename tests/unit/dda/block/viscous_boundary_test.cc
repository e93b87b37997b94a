// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/viscous_boundary.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// The side x = 2 from y = 1 to y = 4 of a block with its centroid at (1, 2), rock on the left.
  const BoundaryEdge
    side{BoundaryPart::right, 0, 0, {Vec2(2., 1.), Vec2(2., 4.)}, 2000., 1e9, 1e9, 5e6, 2e6};

  ViscousBoundary at_rest()
  {
    return {side, side.ends[0], side.ends[1], BlockMotion(Vec2(1., 2.), Vec6::Zero())};
  }
} // namespace



TEST(ViscousBoundary, normal_is_outward_and_impedance_acts_along_it)
{
  EXPECT_LT((side.normal() - Vec2(1., 0.)).norm(), 1e-15);
  Vec6 rate    = Vec6::Zero();
  rate[0]      = 0.1;
  rate[1]      = -0.2;
  const Vec6 f = at_rest().dashpots(rate);
  EXPECT_NEAR(f[0], -3. * 5e6 * 0.1, 1e-8);
  EXPECT_NEAR(f[1], 3. * 2e6 * 0.2, 1e-8);
}



/// A rotation rate w gives v = w (-(y - 2), x - 1): integrals over y from 1 to 4.
TEST(ViscousBoundary, a_linear_velocity_is_integrated_exactly)
{
  Vec6 rate    = Vec6::Zero();
  rate[2]      = 0.1;
  const Vec6 f = at_rest().dashpots(rate);
  EXPECT_NEAR(f[0], 5e6 * 0.1 * 1.5, 1e-8);              // integral of (y - 2)
  EXPECT_NEAR(f[2], -0.1 * (5e6 * 3. + 2e6 * 3.), 1e-8); // of (y - 2)^2 and of 1
  EXPECT_LT((at_rest().damping() * rate + f).norm(), 1e-8 * f.norm());
}



TEST(ViscousBoundary, an_even_traction_has_its_force_and_moment)
{
  const double force[4] = {1.5, 3., 1.5, 3.}; // 1 Pa and 2 Pa over 3 m
  const Vec6   f        = at_rest().incoming(force);
  EXPECT_NEAR(f[0], 3., 1e-14);
  EXPECT_NEAR(f[1], 6., 1e-14);
  EXPECT_NEAR(f[2], 6. * 1. - 3. * 0.5, 1e-14);
}
