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

    WaterLoad load(const Water &water) const
    {
      return water_load(water, moments.area, motion, {vertices.data(), displacements.data(), 4});
    }

    WaterLoad load(const Water::Action action, const double level) const
    {
      return load(Water{action, level, unit_weight});
    }
  };

  Vec6 some_motion()
  {
    Vec6 d;
    d << 0.3, -0.2, 0.4, 0.02, -0.03, 0.05;
    return d;
  }

  Water with_line(const Water::Action action, const std::vector<Vec2> &points)
  {
    Water water{action, -1e300, unit_weight};
    water.line = std::make_shared<const scene::LinearTable>(scene::LinearTable{points});
    return water;
  }

  /// Surfaces that bend, rise and fall within the block of Moved, or lie above or below it; some
  /// of them with a level that meets the line there.
  std::vector<Water> below_lines(const Water::Action action)
  {
    std::vector<Water> all;
    for (const std::vector<Vec2> &points :
         {std::vector<Vec2>{{-1., 1.}, {5., 2.}},
          {{0.9, 0.4}, {2.1, 2.4}},
          {{0.5, 1.}, {1.1, 0.2}, {1.6, 1.9}, {2.4, 1.2}, {3.1, 3.}},
          {{-9., 5.}, {1.5, 6.}, {9., 5.}},
          {{1.2, -9.}}})
      for (const double level : {-1e300, 0.9, 1.4})
        {
          all.push_back(with_line(action, points));
          all.back().level = level;
        }
    return all;
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



TEST(Water, pore_pressure_grows_below_the_higher_one_of_level_and_line)
{
  Water water{Water::Action::buoyancy, 2., unit_weight};
  EXPECT_EQ(pore_pressure(water, Vec2(5., 2.5)), 0.);
  EXPECT_DOUBLE_EQ(pore_pressure(water, Vec2(5., -1.)), 3. * unit_weight);
  const auto line = std::make_shared<scene::LinearTable>();
  line->points    = {{0., 1.}, {10., 5.}};
  water.line      = line;
  EXPECT_DOUBLE_EQ(pore_pressure(water, Vec2(5., -1.)), 4. * unit_weight);
  EXPECT_DOUBLE_EQ(pore_pressure(water, Vec2(0., -1.)), 3. * unit_weight);
  EXPECT_EQ(water.as_pressures().action, Water::Action::pressures);
  EXPECT_DOUBLE_EQ(pore_pressure(water.as_pressures(), Vec2(5., -1.)), 4. * unit_weight);
  water.action = Water::Action::none;
  EXPECT_EQ(pore_pressure(water, Vec2(5., -1.)), 0.);
  EXPECT_EQ(water.as_pressures().action, Water::Action::none);
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
                                         d.head<2>());
  EXPECT_NEAR(change / (-unit_weight * before.moments.area * 1e-9), 1., 1e-12);
}



TEST(Water, below_a_line_pressures_on_faces_and_in_pores_are_buoyancy_and_seepage)
{
  const Moved block(some_motion());
  for (const Water &water : below_lines(Water::Action::pressures))
    {
      Water other         = water;
      other.action        = Water::Action::buoyancy;
      const WaterLoad one = block.load(water), two = block.load(other);
      EXPECT_LT((one.force - two.force).norm(), 1e-9 * unit_weight);
      EXPECT_NEAR(one.potential - two.potential, 0., 1e-9 * unit_weight);
    }
}



TEST(Water, vertical_faces_below_bends_of_a_line_count_once)
{
  const std::vector<Vec2> step    = {{0., 0.}, {2., 0.}, {2., 1.}, {1., 1.}, {1., 2.}, {0., 2.}};
  const PolygonMoments    moments = polygon_moments(step.data(), 6);
  const BlockMotion       rest(moments.centroid, Vec6::Zero());
  for (const std::vector<Vec2> &points : {std::vector<Vec2>{{0., 1.5}, {1., 1.8}, {2., 0.7}},
                                          {{1., 1.2}, {3., 1.9}},
                                          {{0., 9.}, {1., 8.}}})
    {
      const auto load = [&](const Water::Action action) {
        return water_load(with_line(action, points), moments.area, rest, {step.data(), nullptr, 6});
      };
      const WaterLoad one = load(Water::Action::pressures), two = load(Water::Action::buoyancy);
      EXPECT_LT((one.force - two.force).norm(), 1e-9 * unit_weight);
      EXPECT_GT(two.force[1], 0.9 * unit_weight);
    }
}



TEST(Water, below_a_line_force_is_the_gradient_of_the_potential)
{
  const double h = 1e-6;
  for (const Water &water : below_lines(Water::Action::buoyancy))
    {
      const Vec6 force = Moved(some_motion()).load(water).force;
      for (int i = 0; i < 6; ++i)
        {
          Vec6 up = some_motion(), down = some_motion();
          up[i] += h;
          down[i] -= h;
          const double slope =
            (Moved(up).load(water).potential - Moved(down).load(water).potential) / (2. * h);
          EXPECT_NEAR(force[i], -slope, 1e-4 * unit_weight) << i;
        }
    }
}



TEST(Water, seepage_pushes_along_the_fall_of_the_line)
{
  const Moved     block((Vec6::Zero()));
  const double    area = block.moments.area, slope = -0.2;
  const WaterLoad full =
    block.load(with_line(Water::Action::buoyancy, {{-10., 9.}, {90., 9. + 100. * slope}}));
  EXPECT_TRUE(full.full);
  EXPECT_NEAR(full.force[0], -slope * unit_weight * area, 1e-9 * unit_weight);
  EXPECT_NEAR(full.force[1], unit_weight * area, 1e-9 * unit_weight);
  EXPECT_EQ(full.force.tail<4>(), Eigen::Vector4d::Zero());
}



TEST(Water, line_that_lies_level_is_a_level)
{
  const Moved block(some_motion());
  for (const double level : levels)
    {
      const Water     line = with_line(Water::Action::pressures, {{0.2, level}, {1.7, level}});
      const WaterLoad one = block.load(line), two = block.load(Water::Action::pressures, level);
      EXPECT_LT((one.force - two.force).norm(), 1e-9 * unit_weight) << level;
      EXPECT_NEAR(one.potential - two.potential, 0., 1e-9 * unit_weight) << level;
    }
}



TEST(Water, change_of_potential_below_a_line_is_that_of_the_force)
{
  Vec6 d             = Vec6::Zero();
  d[0]               = 2e-9;
  d[1]               = 1e-9;
  const Water  water = with_line(Water::Action::buoyancy, {{-100., 1e4}, {100., 1.001e4}});
  const double slope = 10. / 200.;
  const Moved  before((Vec6::Zero())), after(d);
  const double change = potential_change(before.load(water), after.load(water), d.head<2>());
  EXPECT_NEAR(change / (-unit_weight * before.moments.area * (d[1] - slope * d[0])), 1., 1e-12);
}



TEST(Water, level_follows_its_history)
{
  Water water{Water::Action::buoyancy, 3., unit_weight};
  EXPECT_FALSE(water.changes());
  EXPECT_EQ(water.at(7.).level, 3.);
  water.history =
    std::make_shared<const scene::LinearTable>(scene::LinearTable{{{-2., 1.}, {2., 5.}, {4., 0.}}});
  EXPECT_TRUE(water.changes());
  EXPECT_EQ(water.at(-1.).level, 3.); // as at the start
  EXPECT_EQ(water.at(1.).level, 4.);
  EXPECT_EQ(water.at(3.).level, 2.5);
  EXPECT_EQ(water.at(9.).level, 0.);
}



TEST(Water, surface_carries_the_pressure_below_a_line)
{
  // level ground below a line that falls from 3 m over it to 1 m
  const std::vector<Vec2> ground = {{0., 0.}, {3., 0.}, {10., 0.}};
  const Eigen::VectorXd   force =
    water_on_surface(with_line(Water::Action::pressures, {{2., 3.}, {6., 1.}}), ground);
  const double area = 2. * 3. + 4. * 2. + 4. * 1.;
  const double left = 2. * 3. * 1. + 4. * 2. * (2. + 5. / 3.) + 4. * 1. * 8.; // about x = 0
  EXPECT_NEAR(force[1] + force[3] + force[5], -unit_weight * area, 1e-9 * unit_weight);
  EXPECT_NEAR(3. * force[3] + 10. * force[5], -unit_weight * left, 1e-8 * unit_weight);
  EXPECT_EQ(force[0], 0.);
}



TEST(Water, surface_of_elements_bears_what_their_shapes_do)
{
  // A slope of one face with nodes at 0, 1/2, 1 and another beyond a crack: pressures p0 at its
  // foot, p1 at its head.
  const Vec2              foot(0., 0.), head(4., 3.), end(8., 3.);
  const std::vector<Vec2> nodes = {foot, 0.5 * (foot + head), head, head, 0.5 * (head + end), end};
  const Eigen::VectorXd   force =
    water_on_surface({Water::Action::pressures, 5., unit_weight}, nodes, 2);
  const double p0 = 5. * unit_weight, p1 = 2. * unit_weight;
  const Vec2   into_rock(3., -4.); // times the length
  // int N p ds: (p0 / 6, (p0 + p1) / 3, p1 / 6)
  EXPECT_NEAR((force.segment<2>(0) - p0 / 6. * into_rock).norm(), 0., 1e-9 * p0);
  EXPECT_NEAR((force.segment<2>(2) - (p0 + p1) / 3. * into_rock).norm(), 0., 1e-9 * p0);
  EXPECT_NEAR((force.segment<2>(4) - p1 / 6. * into_rock).norm(), 0., 1e-9 * p0);
  EXPECT_NEAR(force[2 * 4 + 1], -4. * 2. / 3. * p1, 1e-9 * p0);
  for (int degree = 1; degree <= 8;
       ++degree) // total and moment about the foot, half of the slope below water
    {
      std::vector<Vec2> slope;
      for (int i = 0; i <= degree; ++i)
        slope.push_back(0.5 * (1. - std::cos(M_PI * i / degree)) * head);
      const Eigen::VectorXd f =
        water_on_surface({Water::Action::pressures, 1.5, unit_weight}, slope, degree);
      Vec2   sum    = Vec2::Zero();
      double moment = 0.;
      for (int i = 0; i <= degree; ++i)
        {
          sum += f.segment<2>(2 * i);
          moment += cross(slope[i], f.segment<2>(2 * i));
        }
      const double total = 0.5 * 1.5 * unit_weight * 2.5; // over 2.5 m of the slope, a third up
      EXPECT_NEAR((sum - total / 5. * into_rock).norm(), 0., 1e-9 * total) << degree;
      EXPECT_NEAR(moment, -total * 2.5 / 3., 1e-9 * total) << degree;
    }
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
