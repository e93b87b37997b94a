// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_inverse.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid::dda;

  double error(const Mat6 &a, const Mat6 &inverse)
  {
    return (a * inverse - Mat6::Identity()).norm();
  }
} // namespace



TEST(BlockInverse, of_random_blocks)
{
  std::srand(1);
  for (int i = 0; i < 100; ++i)
    {
      const Mat6   a     = Mat6::Random();
      const double exact = a.inverse().norm() * a.norm();
      EXPECT_LT(error(a, pivoted_inverse(a)), 1e-14 * exact);
      EXPECT_LT(error(a, block_inverse(a)), 1e-10 * exact);
    }
}



TEST(BlockInverse, a_singular_half_is_no_harm)
{
  Mat6 a = Mat6::Zero();
  a.topRightCorner<3, 3>().setIdentity();
  a.bottomLeftCorner<3, 3>().setIdentity();
  EXPECT_EQ(error(a, block_inverse(a)), 0.);
  a(0, 0) = 1e-12;
  EXPECT_LT(error(a, block_inverse(a)), 1e-14);
}



TEST(BlockInverse, a_singular_block_has_none)
{
  EXPECT_FALSE(block_inverse(Mat6::Zero()).allFinite());
  Mat6 a  = Mat6::Identity();
  a(4, 4) = 0.;
  EXPECT_FALSE(block_inverse(a).allFinite());
}
