// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double weight = 2220. * 9.81; // of a block of 1 m2 [N/m]

  scene::SceneParameters strong(const double friction_angle)
  {
    scene::SceneParameters p             = block_parameters(friction_angle);
    p.blocks.bonded                      = true;
    p.blocks.belt_material               = "rock";
    p.materials["rock"].cohesion         = 1e6;
    p.materials["rock"].tensile_strength = 1e6;
    return p;
  }
} // namespace



TEST(StaticStage, bonded_column_carries_its_own_weight)
{
  scene::SectionMesh mesh = square_blocks(1, 8);
  mesh.lines["sliding_surface"].push_back({0, 1});
  const Model        model = build_model(mesh, strong(30.), straight_foundation(0., 0., 1., 1));
  DdaState           state = initial_state(model);
  const StaticResult r     = settle(model, state);
  ASSERT_TRUE(r.equilibrium);
  EXPECT_LE(r.residual, 1e-9);
  // Vertical stress at mid height of each block, to the change of the section by the strain (1e-3).
  for (int b = 0; b < 8; ++b)
    EXPECT_NEAR(state.blocks[b].stress[1], -weight * (8 - b - 0.5), 5e-3 * weight * 8.) << b;
  EXPECT_NEAR(state.foundation_force[1] + state.foundation_force[3],
              -8. * weight,
              1e-7 * weight * 8.);
  EXPECT_TRUE(state.static_force == state.foundation_force);
  EXPECT_EQ(state.time, 0.);
  for (const BlockState &block : state.blocks)
    {
      EXPECT_EQ(block.velocity.norm(), 0.);
      EXPECT_LT(block.acceleration.norm(), 1e-5); // of forces in balance, not zero by order
    }
}



TEST(StaticStage, block_that_yields_on_a_smooth_base_stands_if_its_cohesion_bears_it)
{
  scene::SectionMesh mesh = square_blocks(1, 1);
  mesh.lines["sliding_surface"].push_back({0, 1});
  scene::SceneParameters p             = strong(30.);
  p.blocks.belt_material               = "smooth";
  p.materials["smooth"]                = p.materials["rock"];
  p.materials["smooth"].name           = "smooth";
  p.materials["smooth"].cohesion       = 0.;
  p.materials["smooth"].friction_angle = 0.;
  const double mean                    = 0.5 * weight; // vertical stress [Pa]; it bears 2 c
  for (const double part : {0.8, 1.03})
    {
      Model model              = build_model(mesh, p, straight_foundation(0., 0., 1., 1));
      model.blocks_yield       = true;
      model.blocks[0].strength = {part * 0.5 * mean, 0., 1., 0.};
      DdaState           state = initial_state(model);
      const StaticResult r     = settle(model, state, false, {}, true);
      EXPECT_EQ(r.equilibrium, part > 1.); // 3 % less would bear it once it is 3 % shorter
      EXPECT_EQ(state.blocks[0].plastic_strain > 0.1, part < 1.);
      EXPECT_EQ(state.blocks[0].plastic_strain, state.blocks[0].rest_plastic_strain);

      DdaState held = initial_state(model);
      EXPECT_TRUE(settle(model, held, true).equilibrium);
      EXPECT_EQ(held.blocks[0].plastic_strain, 0.);
    }
}



TEST(StaticStage, whoever_watches_is_told_and_can_end_it)
{
  scene::SectionMesh mesh = square_blocks(1, 8);
  mesh.lines["sliding_surface"].push_back({0, 1});
  const Model model = build_model(mesh, strong(30.), straight_foundation(0., 0., 1., 1));
  DdaState    state = initial_state(model);
  std::vector<StaticProgress> told;
  const StaticResult          whole = settle(model, state, false, [&](const StaticProgress &now) {
    told.push_back(now);
    return true;
  });
  ASSERT_TRUE(whole.equilibrium);
  EXPECT_FALSE(whole.stopped);
  EXPECT_EQ(static_cast<int>(told.size()), whole.iterations);
  EXPECT_EQ(told.front().steps, 0);
  EXPECT_EQ(told.back().iterations, whole.iterations - 1);
  EXPECT_GT(told.back().residual, told.back().target);

  DdaState           other = initial_state(model);
  int                calls = 0;
  const StaticResult stopped =
    settle(model, other, false, [&](const StaticProgress &) { return ++calls < 5; });
  EXPECT_TRUE(stopped.stopped);
  EXPECT_FALSE(stopped.equilibrium);
  EXPECT_EQ(calls, 5);
  EXPECT_LT(stopped.iterations, whole.iterations);
}



TEST(StaticStage, loose_column_on_a_slope_below_its_friction_angle_stands)
{
  const double       angle = 20. * M_PI / 180.;
  const Model        model = build_model(square_blocks(1, 2, 1., angle),
                                  block_parameters(21.),
                                  straight_foundation(angle, 5., 5.));
  DdaState           state = initial_state(model);
  const StaticResult r     = settle(model, state);
  EXPECT_TRUE(r.equilibrium);
  EXPECT_LE(r.residual, 1e-9);
  EXPECT_LT(r.largest_displacement, 5e-3);
}



TEST(StaticStage, a_block_slides_out_of_the_thrust_of_water_that_stays_in_place)
{
  // The line falls by 0.8 m over the block, which pushes it by 0.32 rho_w g; friction bears 0.26.
  Model model =
    build_model(square_blocks(1, 1), block_parameters(8.), straight_foundation(0., 5., 5.));
  model.water = {Water::Action::buoyancy, -1e300, 9810.};
  model.water.line =
    std::make_shared<const scene::LinearTable>(scene::LinearTable{{{0., 0.8}, {1., 0.}}});
  for (const bool as_drawn : {false, true})
    {
      model.water.static_as_drawn = as_drawn;
      DdaState           state    = initial_state(model);
      const StaticResult r        = settle(model, state);
      EXPECT_EQ(r.equilibrium && r.fallen_block < 0, !as_drawn);
      EXPECT_EQ(r.slid_block >= 0, !as_drawn);
      EXPECT_GT(r.largest_displacement, 0.05);
    }
}



TEST(StaticStage, water_at_the_drawn_place_bears_as_much_as_limit_equilibrium_says)
{
  const double pushed = 0.32 * 9810., pressed = weight - 0.4 * 9810.;
  for (const double part : {0.998, 1.002})
    {
      const double angle = std::atan(part * pushed / pressed) * 180. / M_PI;
      Model        model =
        build_model(square_blocks(1, 1), block_parameters(angle), straight_foundation(0., 5., 5.));
      for (const Water::Action action : {Water::Action::buoyancy, Water::Action::pressures})
        {
          model.water = {action, -1e300, 9810.};
          model.water.line =
            std::make_shared<const scene::LinearTable>(scene::LinearTable{{{0., 0.8}, {1., 0.}}});
          model.water.static_as_drawn = true;
          DdaState           state    = initial_state(model);
          const StaticResult r        = settle(model, state);
          EXPECT_EQ(r.equilibrium && r.fallen_block<0, part> 1.) << part;
          EXPECT_LT(r.slid_block, 0);
        }
    }
}



TEST(StaticStage, block_that_cannot_stand_is_reported_unless_it_is_held)
{
  const double       angle = 30. * M_PI / 180.;
  const Model        model = build_model(square_blocks(1, 1, 1., angle),
                                  block_parameters(15.),
                                  straight_foundation(angle, 500., 50.));
  DdaState           state = initial_state(model);
  const StaticResult free  = settle(model, state);
  EXPECT_FALSE(free.equilibrium);
  EXPECT_EQ(free.moving_block, 0);

  state                   = initial_state(model);
  const StaticResult held = settle(model, state, true);
  EXPECT_TRUE(held.equilibrium);
  EXPECT_LE(held.residual, 1e-9);
  // force on the foundation: the whole weight, normal and along the slope
  EXPECT_NEAR(state.foundation_force[1] + state.foundation_force[3], -weight, 1e-8 * weight);
  EXPECT_NEAR(state.foundation_force[0] + state.foundation_force[2], 0., 1e-8 * weight);
}



TEST(StaticStage, block_that_topples_before_it_rests_is_named)
{
  // A column twice as high as wide topples above 26.6 degrees, and then lies on its side.
  for (const double degrees : {24., 40.})
    {
      const double           angle = degrees * M_PI / 180.;
      scene::SceneParameters p     = strong(60.);
      p.blocks.belt_material.clear();
      const Model model =
        build_model(square_blocks(1, 2, 1., angle), p, straight_foundation(angle, 5., 5.));
      DdaState           state  = initial_state(model);
      const StaticResult result = settle(model, state);
      EXPECT_TRUE(result.equilibrium);
      EXPECT_EQ(result.fallen_block >= 0, degrees > 26.6) << result.fallen_by;
      EXPECT_NEAR(result.turned_by, degrees > 26.6 ? 0.5 * M_PI : 0., 0.01);
    }
}



TEST(StaticStage, slab_that_its_belt_cannot_hold_finds_no_rest_further_down)
{
  // 30 degrees, friction of 20 and 0.9 of the cohesion that would hold it; strengths do not soften
  // while it settles. Joints that had slipped by metres would pull askew and hold it.
  const double           angle = 30. * M_PI / 180.;
  scene::SceneParameters p     = strong(20.);
  p.blocks.belt_material       = "belt";
  p.materials["belt"]          = p.materials["rock"];
  const double critical =
    weight * (std::sin(angle) - std::cos(angle) * std::tan(20. * M_PI / 180.));
  for (const double part : {0.9, 1.1})
    {
      p.materials["belt"].cohesion = part * critical;
      scene::SectionMesh mesh      = square_blocks(6, 1, 1., angle);
      for (int k = 0; k < 6; ++k)
        mesh.lines["sliding_surface"].push_back({k, k + 1});
      const Model        model  = build_model(mesh, p, straight_foundation(angle, 0., 6., 6));
      DdaState           state  = initial_state(model);
      const StaticResult result = settle(model, state, false, {}, true);
      EXPECT_EQ(result.equilibrium, part > 1.);
      EXPECT_LT(result.largest_displacement, 0.2) << "gives up before joints pull askew";
    }
}



TEST(StaticStage, what_moves_is_named_in_a_mass_that_partly_stands)
{
  // Two loose blocks on the level; a third with nothing below.
  scene::SectionMesh mesh = square_blocks(3, 1);
  for (const int node : {3, 7}) // the third block: 5 m to the right
    mesh.nodes[node].x() += 5.;
  mesh.nodes.push_back({7., 0.});
  mesh.nodes.push_back({7., 1.});
  mesh.blocks[2]       = {8, 3, 7, 9};
  const Model model    = build_model(mesh, block_parameters(30.), straight_foundation(0., 1., 4.));
  DdaState    state    = initial_state(model);
  const StaticResult r = settle(model, state);
  EXPECT_FALSE(r.equilibrium);
  EXPECT_EQ(r.moving_block, 2);
}



TEST(StaticStage, failures_of_the_static_stage_have_negative_times_and_are_counted_once)
{
  // A cantilever of two squares: the second hangs on its bond, too weak in tension.
  scene::SectionMesh mesh = square_blocks(2, 1);
  mesh.lines["sliding_surface"].push_back({0, 1});
  scene::SceneParameters p             = strong(30.);
  p.materials["belt"]                  = p.materials["rock"];
  p.materials["belt"].name             = "belt";
  p.blocks.belt_material               = "belt";
  p.materials["rock"].tensile_strength = 1e3;
  std::vector<Vec2> foundation{{0., 0.}, {1., 0.}, {1.5, -1.2}, {4., -1.2}};
  const Model       model = build_model(mesh, p, foundation);
  DdaState          state = initial_state(model);
  settle(model, state);
  int failed = 0;
  for (const JointState &joint : state.joints)
    if (joint.failure != FailureKind::none)
      {
        ++failed;
        EXPECT_EQ(joint.failure, FailureKind::tensile);
        EXPECT_LT(joint.failure_time, 0.);
      }
  EXPECT_EQ(failed, 1);
}



TEST(StaticStage, motion_starts_with_the_acceleration_of_the_real_strengths)
{
  // Held on 30 degrees; with 15 degrees of friction it starts with g (sin - cos tan 15).
  const double angle = 30. * M_PI / 180.;
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p = block_parameters(15.);
      p.time.newmark           = Newmark::preset(preset);
      const Model model =
        build_model(square_blocks(1, 1, 1., angle), p, straight_foundation(angle, 5., 5.));
      DdaState state = initial_state(model);
      EXPECT_NEAR(state.blocks[0].acceleration[1], -9.81, 1e-12);
      ASSERT_TRUE(settle(model, state, true).equilibrium);
      const double expected =
        9.81 * (std::sin(angle) - std::cos(angle) * std::tan(15. * M_PI / 180.));
      const Vec2 down = -Vec2(std::cos(angle), std::sin(angle));
      EXPECT_NEAR(state.blocks[0].acceleration.head<2>().dot(down), expected, 1e-6 * expected);
      // without its contacts it would fall
      const Vec6 rest = state.blocks[0].acceleration - state.blocks[0].contact_acceleration;
      EXPECT_NEAR(rest[1], -9.81, 1e-9);
    }
}



TEST(StaticStage, energy_of_a_held_mass_closes_from_the_first_step_on)
{
  // Bonded to a belt that cannot hold it: the shear traction falls to its friction in the first
  // step.
  const double angle = 30. * M_PI / 180.;
  for (const char *preset : {"dissipative", "filtered", "trapezoidal", "shi"})
    {
      scene::SceneParameters p           = strong(30.);
      p.time.newmark                     = Newmark::preset(preset);
      p.blocks.belt_material             = "belt";
      p.materials["belt"]                = p.materials["rock"];
      p.materials["belt"].friction_angle = 15.;
      p.materials["belt"].cohesion       = 0.;
      scene::SectionMesh mesh            = square_blocks(1, 1, 1., angle);
      mesh.lines["sliding_surface"].push_back({0, 1});
      FixedBaseRun run(mesh, p, straight_foundation(angle, 0., 1., 1));
      ASSERT_TRUE(settle(run.model, run.state, true).equilibrium);
      const double before = run.state.energy.balance(), friction = run.state.energy.friction_loss;
      ASSERT_TRUE(run.advance(1e-3, 0));
      const double slid = run.state.energy.friction_loss - friction;
      EXPECT_GT(slid, 0.05);
      EXPECT_NEAR(run.state.energy.balance(), before, 1e-4 * slid) << preset;
    }
}



TEST(StaticStage, buoyancy_and_pressures_give_the_same_effective_forces)
{
  // bonded squares on an incline of 20 degrees, the water line cuts through some of them
  const double       angle = 20. * M_PI / 180., level = 2.;
  scene::SectionMesh mesh = square_blocks(6, 2, 1., angle);
  std::vector<Vec2>  surface(mesh.nodes.begin(), mesh.nodes.begin() + 7);
  for (int k = 0; k < 6; ++k)
    mesh.lines["sliding_surface"].push_back({k, k + 1});
  scene::SceneParameters p            = strong(30.);
  p.environment.water_level           = level;
  const auto settled_foundation_force = [&](const scene::WaterMethod method, double &submerged) {
    p.environment.water_method = method;
    const Model        model   = build_model(mesh, p, surface);
    DdaState           state   = initial_state(model);
    const StaticResult r       = settle(model, state);
    EXPECT_TRUE(r.equilibrium);
    submerged = 0.; // area
    for (int b = 0; b < model.n_blocks(); ++b)
      submerged += water_load({Water::Action::buoyancy, level, 1.},
                              model.blocks[b].area,
                              BlockMotion(state.blocks[b].centroid, Vec6::Zero()),
                              {&state.geometry.vertices[4 * b], nullptr, 4})
                     .force[1];
    return state.static_force;
  };
  double                area = 0., same_area = 0., dry_area = 0.;
  const Eigen::VectorXd buoyancy = settled_foundation_force(scene::WaterMethod::submerged, area);
  const Eigen::VectorXd pressures =
    settled_foundation_force(scene::WaterMethod::pressures, same_area);
  const Eigen::VectorXd dry = settled_foundation_force(scene::WaterMethod::paper, dry_area);
  EXPECT_GT(area, 3.);
  EXPECT_LT(area, 9.);
  EXPECT_LT((buoyancy - pressures).norm(), 1e-8 * buoyancy.norm());
  const auto sum_of_y = [](const Eigen::VectorXd &f) {
    double sum = 0.;
    for (Eigen::Index k = 1; k < f.size(); k += 2)
      sum += f[k];
    return sum;
  };
  EXPECT_NEAR(sum_of_y(buoyancy), -12. * weight + 9810. * area, 1e-7 * 12. * weight);
  EXPECT_NEAR(sum_of_y(dry), -12. * weight, 1e-7 * 12. * weight);
}



namespace
{
  /// Two bonded squares on 20 degrees: the belt of the upper one slips and leans on the lower one.
  struct LeaningBlock
  {
    Model        model;
    DdaState     state;
    StaticResult result;

    LeaningBlock(const bool resets, const double tensile_strength, const double rate_effect = 0.)
      : model(make(tensile_strength, rate_effect))
      , state(initial_state(model))
      , result(settle(model, state, false, {}, resets))
    {}

    const JointState &weak() const
    {
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        if (model.joints[j].kind == JointKind::belt && model.joints[j].block == 1)
          return state.joints[j];
      return state.joints[0];
    }

  private:
    static Model make(const double tensile_strength, const double rate_effect)
    {
      const double           angle     = 20. * M_PI / 180.;
      scene::SceneParameters p         = strong(30.);
      Material               weak      = p.materials["rock"];
      weak.name                        = "weak";
      weak.friction_angle              = 5.;
      weak.cohesion                    = 0.;
      weak.tensile_strength            = tensile_strength;
      weak.rate_coefficient            = rate_effect;
      weak.reference_rate              = 1e-6;
      p.materials["weak"]              = weak;
      p.blocks.saturated_belt_material = "rock";
      p.blocks.belt_material           = "weak";
      p.environment.water_level        = 0.99 * std::sin(angle);
      p.blocks.softening_slip          = 1e-6;
      scene::SectionMesh mesh          = square_blocks(2, 1, 1., angle);
      mesh.lines["sliding_surface"]    = {{0, 1}, {1, 2}};
      return build_model(mesh, p, {mesh.nodes[0], mesh.nodes[1], mesh.nodes[2]});
    }
  };
} // namespace



TEST(StaticStage, its_steps_are_no_rates_of_slip)
{
  const LeaningBlock slow(false, 1e6);
  for (const double effect : {-0.5, 0.5})
    {
      const LeaningBlock rated(false, 1e6, effect);
      EXPECT_TRUE(rated.result.equilibrium);
      for (std::size_t b = 0; b < slow.state.blocks.size(); ++b)
        EXPECT_EQ(rated.state.blocks[b].centroid, slow.state.blocks[b].centroid);
    }
}



TEST(StaticStage, slip_at_rest_takes_nothing_of_strengths_measured_today)
{
  const LeaningBlock then(false, 1e6), now(true, 1e6);
  ASSERT_TRUE(then.result.equilibrium);
  ASSERT_TRUE(now.result.equilibrium);
  for (const LeaningBlock *run : {&then, &now}) // the same equilibrium: residual = peak
    EXPECT_GT(std::abs(run->weak().points[0].history.plastic_slip), 1e-6);
  EXPECT_EQ(then.weak().failure, FailureKind::shear);
  EXPECT_GT(then.weak().points[0].history.softening, 1e-6);
  EXPECT_EQ(then.weak().rest_slip[0], 0.);

  EXPECT_EQ(now.weak().failure, FailureKind::none);
  for (const int end : {0, 1})
    {
      EXPECT_EQ(now.weak().points[end].history.softening, 0.);
      EXPECT_EQ(now.weak().rest_slip[end], now.weak().points[end].slip);
      EXPECT_NEAR(now.weak().points[end].slip, then.weak().points[end].slip, 1e-6);
    }
}



TEST(StaticStage, what_opened_at_rest_stays_failed)
{
  // The cantilever of failures_of_the_static_stage_have_negative_times: its bond is torn.
  scene::SectionMesh mesh = square_blocks(2, 1);
  mesh.lines["sliding_surface"].push_back({0, 1});
  scene::SceneParameters p             = strong(30.);
  p.materials["belt"]                  = p.materials["rock"];
  p.materials["belt"].name             = "belt";
  p.blocks.belt_material               = "belt";
  p.materials["rock"].tensile_strength = 1e3;
  const Model model = build_model(mesh, p, {{0., 0.}, {1., 0.}, {1.5, -1.2}, {4., -1.2}});
  DdaState    state = initial_state(model);
  settle(model, state, false, {}, true);
  int failed = 0;
  for (const JointState &joint : state.joints)
    if (joint.failure != FailureKind::none)
      {
        ++failed;
        EXPECT_EQ(joint.failure, FailureKind::tensile);
        EXPECT_LT(joint.failure_time, 0.);
        EXPECT_EQ(std::max(joint.points[0].history.damage, joint.points[1].history.damage), 1.);
      }
  EXPECT_EQ(failed, 1);
}
