// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/edge_loads.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include "block_scenes.h"

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  const Vec2 pull(2e3, 5e3); // [Pa]

  /// 2 x 1 squares of 2 m that touch nothing, loose, no gravity; a traction on the top edge of the
  /// left one.
  struct Scene
  {
    scene::SectionMesh     mesh       = test::square_blocks(2, 1, 2.);
    scene::SceneParameters parameters = test::block_parameters(30.);

    Scene()
    {
      parameters.environment.gravity  = 0.;
      parameters.edge_loads.tractions = {{"top", Vec2(-0.1, 1.9), Vec2(2.1, 2.1), pull}};
      parameters.edge_loads.start     = 0.1;
      parameters.edge_loads.rise_time = 0.2;
    }

    Model model() const
    {
      return build_model(mesh, parameters, {});
    }
  };
} // namespace



TEST(EdgeLoads, rise_linearly_and_stay)
{
  const EdgeLoads loads{{}, 0.1, 0.2};
  EXPECT_EQ(loads.factor(0.), 0.);
  EXPECT_EQ(loads.factor(0.1), 0.);
  EXPECT_NEAR(loads.factor(0.15), 0.25, 1e-15);
  EXPECT_NEAR(loads.factor(0.3), 1., 1e-15);
  EXPECT_EQ(loads.factor(10.), 1.);
  const EdgeLoads at_once{{}, 0., 0.};
  EXPECT_EQ(at_once.factor(0.), 0.);
  EXPECT_EQ(at_once.factor(1e-9), 1.);
}



TEST(EdgeLoads, act_on_free_edges_in_the_box)
{
  Scene       scene;
  const Model model = scene.model();
  ASSERT_EQ(model.edge_loads.edges.size(), 1u);
  const EdgeLoads::Edge &edge = model.edge_loads.edges[0];
  EXPECT_EQ(edge.block, 0);
  EXPECT_LT((edge.force - 2. * pull).norm(), 1e-9);

  // The box of the middle holds the edge that both blocks share, and no free one.
  scene.parameters.edge_loads.tractions[0].lower = Vec2(1.9, -0.1);
  EXPECT_THROW(scene.model(), InputError);
  // Nor does the sliding surface count.
  scene.parameters.edge_loads.tractions[0].lower = Vec2(-0.1, -0.1);
  EXPECT_EQ(scene.model().edge_loads.edges.size(), 3u);
  scene.mesh.lines["sliding_surface"] = {{0, 1}, {1, 2}};
  EXPECT_EQ(scene.model().edge_loads.edges.size(), 2u);
}



/// The generalised force is the derivative of F . u of the edge's middle.
TEST(EdgeLoads, force_is_the_gradient_of_the_work)
{
  const Scene scene;
  const Model model = scene.model();
  const auto &edge  = model.edge_loads.edges[0];
  const Vec2  centre(1., 1.);
  const auto  work = [&](const Vec6 &d) {
    return edge.force.dot(BlockMotion(centre, d).displacement(Vec2(1., 2.)));
  };
  Vec6 d;
  d << 0.3, -0.2, 0.4, 0.02, -0.03, 0.05;
  const BlockMotion motion(centre, d);
  std::vector<Vec2> moved;
  for (const Vec2 &x : model.initial.vertices)
    moved.push_back(motion.displacement(x));
  const Vec6 force = edge_force(edge, model.initial, moved.data(), motion);
  for (int k = 0; k < 6; ++k)
    {
      Vec6 step = Vec6::Zero();
      step[k]   = 1e-6;
      EXPECT_NEAR(force[k], (work(d + step) - work(d - step)) / 2e-6, 1e-4) << k;
    }
}



/// A free block under a lasting load: impulse F (t - t_0 - rise / 2), of which Newmark's weights
/// make (gamma - 1/2) dt F more; energy equal to the work.
TEST(EdgeLoads, a_free_block_takes_their_impulse_and_work)
{
  Scene scene;
  scene.parameters.edge_loads.tractions[0].traction = Vec2(0., 5e3);
  const Model        model                          = scene.model();
  DdaState           state                          = initial_state(model);
  BlockSolver        solver(model);
  FoundationResponse foundation;
  foundation.displacement = state.foundation_displacement;
  for (int step = 0; step < 500; ++step)
    {
      ASSERT_TRUE(solver.solve(state, foundation, 1e-3).converged);
      solver.accept(state);
    }
  const double impulse = 1e4 * (0.5 - 0.1 - 0.1 + (model.newmark.gamma - 0.5) * 1e-3);
  EXPECT_NEAR(model.blocks[0].mass * state.blocks[0].velocity[1], impulse, 1e-9 * impulse);
  EXPECT_GT(state.energy.edge_load_work, 0.);
  EXPECT_NEAR(state.energy.balance(), 0., 1e-9 * state.energy.edge_load_work);
  // The two touch: round-off, as they were taken for closed until the first solve.
  EXPECT_LT(state.blocks[1].velocity.norm(), 1e-16 * state.blocks[0].velocity.norm());
}
