// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/statics/elastic_settlement.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;
} // namespace



TEST(ElasticSettlement, is_that_of_the_softest_block_in_the_same_column)
{
  constexpr int          columns = 9, rows = 3;
  Model                  model = build_model(square_blocks(columns, rows),
                            block_parameters(30.),
                            straight_foundation(0., 5., 12.));
  const BlockProperties &block = model.blocks[0];
  const double expected = rows * rows * block.weight * model.gravity / block.elasticity(2, 2);
  for (const double s : elastic_settlement(model))
    EXPECT_NEAR(s, expected, 1e-12 * expected);

  model.blocks[2].elasticity *= 1e-3; // in the third column, below
  const std::vector<double> settlement = elastic_settlement(model);
  for (int b = 0; b < model.n_mass(); ++b)
    {
      const double x = model.initial.vertices[model.initial.offset[b]].x(); // of its left side
      if (x > 3. || x < 1.)
        {
          EXPECT_NEAR(settlement[b], expected, 1e-12 * expected) << b;
        }
      else if (x == 2.)
        {
          EXPECT_NEAR(settlement[b], 1e3 * expected, 1e-9 * expected) << b;
        }
    }
}
