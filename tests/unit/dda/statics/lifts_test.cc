// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/lifts.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double young = 1e9, density = 2000., gravity = 10.; // strains are small

  scene::SceneParameters strong(const double poisson_ratio = 0.)
  {
    scene::SceneParameters p             = block_parameters(80., young, density);
    p.environment.gravity                = gravity;
    p.blocks.bonded                      = true;
    p.blocks.belt_material               = "rock";
    p.blocks.stiffness_correction        = false;
    p.blocks.penalty_ratio               = 1e4; // joints hardly give way
    p.materials["rock"].cohesion         = 1e8;
    p.materials["rock"].tensile_strength = 1e8;
    p.materials["rock"].poisson_ratio    = poisson_ratio;
    return p;
  }

  /// Squares of 1 m that stand on a foundation.
  struct Wall
  {
    scene::SectionMesh mesh;
    Model              model;
    DdaState           state;

    Wall(const int columns, const int rows, const scene::SceneParameters &p = strong())
      : mesh(square_blocks(columns, rows))
    {
      for (int i = 0; i < columns; ++i)
        mesh.lines["sliding_surface"].push_back({i, i + 1});
      model = build_model(mesh, p, straight_foundation(0., 0., columns, columns));
      state = initial_state(model);
    }

    /// Take the block in a column and a row away from the others: its joints go.
    void cut(const int block)
    {
      auto &joints = model.joints;
      joints.erase(std::remove_if(joints.begin(),
                                  joints.end(),
                                  [&](const Joint &j) {
                                    return j.block == block || j.other == block;
                                  }),
                   joints.end());
      state = initial_state(model);
    }
  };

  double difference(const DdaState &a, const DdaState &b)
  {
    double largest = 0.;
    for (std::size_t k = 0; k < a.blocks.size(); ++k)
      largest = std::max(largest, (a.blocks[k].stress - b.blocks[k].stress).norm());
    return largest;
  }
} // namespace



// sigma = rho g (H - z), and a boundary of lifts at z moves by rho g z (H - z) / E under the lifts
// above it.
TEST(Lifts, of_a_column_leave_its_stress_and_move_it_by_what_comes_after)
{
  constexpr int rows = 12;
  for (const int lifts : {1, 3, 4, 12, 30})
    {
      Wall             wall(1, rows);
      const LiftResult result = place_in_lifts(wall.model, lifts, wall.state);
      EXPECT_EQ(result.lifts, std::min(lifts, rows));
      double largest = 0.;
      for (int b = 0; b < rows; ++b)
        {
          const double expected = density * gravity * (rows - b - 0.5);
          EXPECT_NEAR(wall.state.blocks[b].stress[1], -expected, 1e-6 * expected) << b;
          EXPECT_NEAR(wall.state.blocks[b].stress[0], 0., 1e-6 * expected);
          // Shortening below the centroid: its own lift and all above it weigh on what is below.
          const int of_lift = rows / result.lifts, first = b / of_lift * of_lift;
          double    moved = 0.;
          for (int q = 0; q <= b; ++q)
            moved += (q < b ? 1. : 0.5) * (rows - std::max(first, q) - (q >= first ? 0.5 : 0.)) *
                     density * gravity / young;
          largest = std::max(largest, moved);
        }
      EXPECT_NEAR(result.largest_displacement, largest, 3e-4 * largest) << lifts;
    }
}



TEST(Lifts, leave_a_column_at_rest)
{
  Wall wall(1, 8);
  place_in_lifts(wall.model, 4, wall.state);
  const DdaState     placed  = wall.state;
  const StaticResult settled = settle(wall.model, wall.state);
  EXPECT_TRUE(settled.equilibrium);
  const double settlement = density * gravity * 8. * 8. / 2. / young;
  EXPECT_LT(settled.largest_displacement, 1e-3 * settlement); // of second order in the strain
  EXPECT_LT(difference(placed, wall.state), 1e-3 * density * gravity * 8.);
}



TEST(Lifts, one_lift_is_gravity_switched_on)
{
  Wall placed(5, 4, strong(0.3)), settled(5, 4, strong(0.3));
  place_in_lifts(placed.model, 1, placed.state);
  ASSERT_TRUE(settle(settled.model, settled.state).equilibrium);
  EXPECT_LT(difference(placed.state, settled.state), 1e-3 * density * gravity * 4.);
  ASSERT_TRUE(settle(placed.model, placed.state).equilibrium);
  EXPECT_LT(difference(placed.state, settled.state), 1e-3 * density * gravity * 4.);
}



// A wall whose joints give way bulges: its stress depends on how it was placed, and is as
// symmetric as it is.
TEST(Lifts, of_a_mirrored_wall_are_mirrored)
{
  constexpr int          columns = 5, rows = 4;
  scene::SceneParameters soft = strong(0.3);
  soft.blocks.penalty_ratio   = 2.;
  Wall staged(columns, rows, soft), at_once(columns, rows, soft);
  place_in_lifts(staged.model, rows, staged.state);
  place_in_lifts(at_once.model, 1, at_once.state);
  const double scale = density * gravity * rows;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      {
        const auto &left  = staged.state.blocks[j * columns + i].stress;
        const auto &right = staged.state.blocks[j * columns + columns - 1 - i].stress;
        EXPECT_NEAR(left[0], right[0], 1e-7 * scale);
        EXPECT_NEAR(left[1], right[1], 1e-7 * scale);
        EXPECT_NEAR(left[2], -right[2], 1e-7 * scale);
      }
  EXPECT_GT(difference(staged.state, at_once.state), 1e-3 * scale);
}



// The lower blocks of one column are gone: what the upper one hangs on comes with a higher lift.
TEST(Lifts, a_block_waits_for_what_holds_it)
{
  constexpr int columns = 2, rows = 3;
  Wall          wall(columns, rows);
  auto         &joints = wall.model.joints;
  // Blocks 1 and 3 are the lower ones of the right column; 1 stands, 3 hangs on 5, which 4 holds.
  joints.erase(std::remove_if(joints.begin(),
                              joints.end(),
                              [](const Joint &j) {
                                const auto pair = std::minmax(j.block, j.other);
                                return pair == std::minmax(1, 3) || pair == std::minmax(2, 3);
                              }),
               joints.end());
  wall.state = initial_state(wall.model);
  EXPECT_NO_THROW(check_lifts(wall.model));
  EXPECT_EQ(place_in_lifts(wall.model, rows, wall.state).lifts, rows);
  const double weight = density * gravity;
  double       base   = 0.; // vertical stress of a block is the mean of what both its ends bear
  for (int i = 0; i < columns; ++i)
    base -= wall.state.blocks[i].stress[1];
  EXPECT_NEAR(base, 0.5 * weight + (0.5 + 4.) * weight, 1e-3 * weight);     // nothing stands on 1
  EXPECT_NEAR(wall.state.blocks[3].stress[1], 0.5 * weight, 1e-3 * weight); // it hangs
}



TEST(Lifts, a_block_that_nothing_holds_is_refused)
{
  Wall wall(2, 2);
  wall.cut(3);
  try
    {
      check_lifts(wall.model);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("block 3 at (1.5, 1.5) m"), std::string::npos);
    }
}
