// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/step/memory_estimate.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  /// Loose squares side by side, so many high.
  Model wall(const int columns, const int rows)
  {
    return build_model(square_blocks(columns, rows),
                       block_parameters(30.),
                       straight_foundation(0., 1., columns + 1.));
  }

  /// A square of n x n blocks, each with a joint to its neighbours.
  Model square(const int n)
  {
    Model model;
    model.blocks.resize(n * n);
    model.bonded.assign(n * n, true);
    model.initial.vertices.assign(3 * n * n, Vec2::Zero());
    model.initial.offset.assign(1, 0);
    for (int b = 0; b < n * n; ++b)
      model.initial.offset.push_back(3 * b + 3);
    const JointLaw law({}, 1., 1.);
    const auto     add = [&](const int block, const int other) {
      model.joints.push_back({block, 0, other, 1., {{0., 0}, {1., 0}}, law});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        {
          if (i + 1 < n)
            add(n * i + j, n * i + j + n);
          if (j + 1 < n)
            add(n * i + j, n * i + j + 1);
          if (i == 0)
            add(j, foundation_body);
        }
    return model;
  }
} // namespace



TEST(MemoryEstimate, a_single_block_takes_little)
{
  const double bytes = estimated_memory(wall(1, 1)).bonded;
  EXPECT_GT(bytes, 3. * sizeof(Mat6));
  EXPECT_LT(bytes, 1e4);
}



// Fill of nested dissection: n log n entries (George 1973), more than proportional, less than
// n^1.5.
TEST(MemoryEstimate, fill_grows_a_little_faster_than_the_blocks)
{
  const double small = estimated_memory(square(20)).bonded,
               large = estimated_memory(square(80)).bonded;
  EXPECT_GT(large, 16. * small);
  EXPECT_LT(large, 40. * small);
}



// The factor of what is no longer symmetric has twice the entries off the diagonal.
TEST(MemoryEstimate, sliding_takes_more)
{
  const SolverMemory memory = estimated_memory(square(80));
  EXPECT_GT(memory.sliding, 0.1 * memory.bonded);
  EXPECT_LT(memory.sliding, 2. * memory.bonded);
}



// Blocks that touch fill the factor as joints do: a row of columns apart takes less.
TEST(MemoryEstimate, loose_blocks_that_touch_count)
{
  Model        apart   = wall(20, 20);
  const double touches = estimated_memory(apart).bonded;
  for (int b = 0; b < apart.n_blocks(); ++b)
    for (int v = apart.initial.offset[b]; v < apart.initial.offset[b + 1]; ++v)
      apart.initial.vertices[v].x() += 0.5 * (b % 20);
  const double columns = estimated_memory(apart).bonded;
  EXPECT_GT(touches, 1.5 * columns);
}
