// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/elastic_settlement.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/initial_state.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double softer = 50.; ///< factor between the moduli of stiff and soft blocks

  /// Loose squares of 1 m and 5 GPa: two stand on each other, the third, softer one is 5 m to the
  /// right of them, all of them @p above level ground [m].
  Model two_and_a_soft_one(const double above)
  {
    scene::SectionMesh mesh = square_blocks(1, 2);
    for (const Vec2 &x : {Vec2(5., 0.), Vec2(6., 0.), Vec2(6., 1.), Vec2(5., 1.)})
      mesh.nodes.push_back(x);
    mesh.blocks.push_back({6, 7, 8, 9});
    mesh.block_region.push_back(mesh.block_region.front());
    for (Vec2 &node : mesh.nodes)
      node.y() += above;
    Model model = build_model(mesh, block_parameters(30., 5e9), straight_foundation(0., 10., 20.));
    model.blocks[2].elasticity /= softer;
    return model;
  }
} // namespace



TEST(ElasticSettlement, a_block_settles_with_what_it_touches)
{
  const Model model = two_and_a_soft_one(0.);
  DdaState    state = initial_state(model);
  ASSERT_TRUE(settle(model, state).equilibrium);
  const std::vector<double> bound  = elastic_settlement(model, state);
  const double              strain = 2220. * 9.81 / model.blocks[0].elasticity(2, 2);
  ASSERT_EQ(bound.size(), 3U);
  EXPECT_NEAR(bound[0], 4. * strain, 1e-9 * strain);
  EXPECT_NEAR(bound[1], 4. * strain, 1e-9 * strain);
  EXPECT_NEAR(bound[2], softer * strain, 1e-9 * strain);
  EXPECT_NEAR(work_of_settlement(model, state),
              2220. * 9.81 * (8. + softer) * strain,
              1e-9 * 2220. * 9.81 * strain);
  for (int b = 0; b < 3; ++b)
    EXPECT_LT((state.blocks[b].centroid - initial_state(model).blocks[b].centroid).norm(),
              bound[b]);
}



TEST(ElasticSettlement, a_soft_block_elsewhere_hides_no_block_that_slid)
{
  // The stiff ones fall by 1 cm onto the ground; the bound of the soft one alone is 0.5 m.
  const double above = 0.01;
  Model        model = two_and_a_soft_one(above);
  model.blocks[2].elasticity /= 1e3;
  DdaState           state  = initial_state(model);
  const StaticResult result = settle(model, state);
  ASSERT_TRUE(result.equilibrium);
  EXPECT_GT(elastic_settlement(model, state)[2], 0.1);
  EXPECT_TRUE(result.slid_block == 0 || result.slid_block == 1) << result.slid_block;
  EXPECT_NEAR(result.slid_by, above, 0.1 * above);
  EXPECT_LT(result.elastic_settlement, 1e-2 * above);
}
