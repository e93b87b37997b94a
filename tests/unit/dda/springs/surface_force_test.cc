// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;

  const double slope = 0.4; ///< of both flanks [rad]

  /// A square of 2 m on the flank right (1) or left (-1) of the origin.
  void add_square(scene::SectionMesh &mesh, const double side)
  {
    const Vec2 along(side * std::cos(slope), std::sin(slope)),
      across(-side * along.y(), side * along.x());
    const std::vector<Vec2> outline{5. * along,
                                    7. * along,
                                    7. * along + 2. * across,
                                    5. * along + 2. * across};
    std::vector<int>        corners;
    for (const Vec2 &x : outline)
      {
        corners.push_back(static_cast<int>(mesh.nodes.size()));
        mesh.nodes.push_back(x);
      }
    if (side < 0.)
      std::reverse(corners.begin(), corners.end());
    mesh.blocks.push_back(corners);
    mesh.block_region.push_back(0);
    mesh.block_region_names = {"sliding_mass"};
  }



  /// Force of squares on the flanks of a valley after a while, with gravity.
  dda::SurfaceForce force_of(const std::vector<double> &sides)
  {
    scene::SectionMesh mesh;
    for (const double side : sides)
      add_square(mesh, side);
    const Vec2         right(40. * std::cos(slope), 40. * std::sin(slope));
    test::FixedBaseRun run(mesh,
                           test::block_parameters(40.),
                           {{-right.x(), right.y()}, {0., 0.}, right});
    EXPECT_TRUE(run.run(0.1, 1e-3));
    return run.state.surface_force;
  }
} // namespace



TEST(SurfaceForce, shear_is_positive_downhill_of_each_slide)
{
  const dda::SurfaceForce right = force_of({1.}), left = force_of({-1.}),
                          both = force_of({1., -1.});
  EXPECT_GT(right.shear, 0.);
  EXPECT_LT(right.force.x(), 0.5 * right.shear); // the resultant has its own sign
  EXPECT_NEAR(left.shear, right.shear, 1e-6 * right.shear);
  EXPECT_NEAR(both.shear, 2. * right.shear, 1e-6 * right.shear);
  EXPECT_NEAR(both.strength, 2. * right.strength, 1e-6 * right.strength);
}
