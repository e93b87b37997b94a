// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/memory_estimate.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid::dda;

  /// A square of n x n blocks, each with a joint to its neighbours.
  Model square(const int n)
  {
    Model model;
    model.blocks.resize(n * n);
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
  Model one;
  one.blocks.resize(1);
  const double bytes = estimated_memory(one).bonded;
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
