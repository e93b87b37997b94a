// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/water.h>
#include <hybrid/dda/geometry/polygon.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double unit_weight = 9810.;

  /// An irregular quadrilateral, its first area and a finite motion of it.
  struct Moved
  {
    std::vector<Vec2> vertices = {{0., 0.}, {3., -0.5}, {3.5, 2.}, {0.5, 2.5}};
    std::vector<Vec2> displacements;
    PolygonMoments    moments = polygon_moments(vertices.data(), 4);
    BlockMotion       motion;

    explicit Moved(const Vec6 &d)
      : motion(moments.centroid, d)
    {
      for (const Vec2 &v : vertices)
        displacements.push_back(motion.displacement(v));
    }

    WaterLoad load(const Water::Action action, const double level) const
    {
      return water_load({action, level, unit_weight},
                        moments.area,
                        motion,
                        {vertices.data(), displacements.data(), 4});
    }
  };

  Vec6 some_motion()
  {
    Vec6 d;
    d << 0.3, -0.2, 0.4, 0.02, -0.03, 0.05;
    return d;
  }

  const double levels[] = {-3., -0.4, 0., 0.7, 1.5, 2.2, 2.5, 5.};
} // namespace



TEST(Water, pressures_on_the_faces_and_in_the_pores_are_buoyancy)
{
  const Moved block(some_motion());
  for (const double level : levels)
    {
      const WaterLoad faces    = block.load(Water::Action::pressures, level);
      const WaterLoad buoyancy = block.load(Water::Action::buoyancy, level);
      EXPECT_LT((faces.force - buoyancy.force).norm(), 1e-9 * unit_weight) << level;
      EXPECT_NEAR(faces.potential - buoyancy.potential, 0., 1e-9 * unit_weight) << level;
    }
}



TEST(Water, force_is_the_gradient_of_the_potential)
{
  const double h = 1e-6;
  for (const Water::Action action : {Water::Action::buoyancy, Water::Action::pressures})
    for (const double level : levels)
      {
        const Vec6 force = Moved(some_motion()).load(action, level).force;
        for (int i = 0; i < 6; ++i)
          {
            Vec6 up = some_motion(), down = some_motion();
            up[i] += h;
            down[i] -= h;
            const double slope = (Moved(up).load(action, level).potential -
                                  Moved(down).load(action, level).potential) /
                                 (2. * h);
            EXPECT_NEAR(force[i], -slope, 1e-4 * unit_weight) << "level " << level << ", " << i;
          }
      }
}



TEST(Water, archimedes)
{
  const Moved     block((Vec6::Zero()));
  const WaterLoad full = block.load(Water::Action::buoyancy, 10.);
  EXPECT_TRUE(full.full);
  EXPECT_NEAR(full.force[1], unit_weight * block.moments.area, 1e-9 * unit_weight);
  EXPECT_EQ(block.load(Water::Action::buoyancy, -1.).force, Vec6::Zero());

  // a square of 2 m, 0.5 m deep in the water: force and moment of the submerged rectangle
  const Vec2      square[4] = {{4., 4.}, {6., 4.}, {6., 6.}, {4., 6.}};
  const WaterLoad part      = water_load({Water::Action::pressures, 4.5, unit_weight},
                                    4.,
                                    BlockMotion(Vec2(5., 5.), Vec6::Zero()),
                                    {square, nullptr, 4});
  EXPECT_NEAR(part.force[0], 0., 1e-9);
  EXPECT_NEAR(part.force[1], unit_weight, 1e-9);
  EXPECT_NEAR(part.force[2], 0., 1e-8);
  EXPECT_NEAR(part.force[4], -0.75 * unit_weight, 1e-8); // centroid of the water 0.75 m below
  EXPECT_NEAR(part.potential, unit_weight * 0.25, 1e-9);
}



TEST(Water, change_of_potential_of_a_block_that_stays_below)
{
  Vec6 d = Vec6::Zero();
  d[1]   = 1e-9;
  const Moved  before((Vec6::Zero())), after(d);
  const double change = potential_change(before.load(Water::Action::buoyancy, 1e4),
                                         after.load(Water::Action::buoyancy, 1e4),
                                         d[1]);
  EXPECT_NEAR(change / (-unit_weight * before.moments.area * 1e-9), 1., 1e-12);
}



TEST(Water, surface_carries_the_weight_of_the_water_above_it)
{
  // a valley that leaves the water on both sides: 10 m wide at the level, 4 m deep
  const std::vector<Vec2> valley = {{-5., 6.}, {0., 2.}, {3., -2.}, {6., -1.}, {12., 5.}};
  const double            level  = 2.;
  const Eigen::VectorXd   force =
    water_on_surface({Water::Action::pressures, level, unit_weight}, valley);
  Vec2   sum    = Vec2::Zero();
  double moment = 0., area = 0., first = 0.;
  for (std::size_t k = 0; k < valley.size(); ++k)
    {
      sum += force.segment<2>(2 * k);
      moment += valley[k].x() * force[2 * k + 1] - valley[k].y() * force[2 * k];
    }
  const std::vector<Vec2> wet = {{0., 2.}, {3., -2.}, {6., -1.}, {9., 2.}};
  const PolygonMoments    m   = polygon_moments(wet.data(), 4);
  area                        = m.area;
  first                       = m.centroid.x() * m.area;
  EXPECT_NEAR(sum.x(), 0., 1e-8);
  EXPECT_NEAR(sum.y(), -unit_weight * area, 1e-8 * unit_weight);
  EXPECT_NEAR(moment, -unit_weight * first, 1e-8 * unit_weight);
  EXPECT_EQ(water_on_surface({Water::Action::buoyancy, level, unit_weight}, valley).norm(), 0.);
}
