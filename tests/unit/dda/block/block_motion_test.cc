// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block_motion.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  const Vec2 centre(3., -2.);

  Vec6 increment()
  {
    Vec6 d;
    d << 0.01, -0.02, 0.3, 1e-3, -2e-3, 3e-3;
    return d;
  }
} // namespace



TEST(BlockMotion, rotation_is_exact)
{
  Vec6 d = Vec6::Zero();
  d[2]   = 2.;
  const BlockMotion motion(centre, d);
  const Vec2        x        = centre + Vec2(1., 0.5), r(1., 0.5);
  const Vec2        expected = centre + Vec2(std::cos(2.) * r.x() - std::sin(2.) * r.y(),
                                      std::sin(2.) * r.x() + std::cos(2.) * r.y());
  EXPECT_LT((x + motion.displacement(x) - expected).norm(), 1e-14);
}



TEST(BlockMotion, small_rotation_keeps_its_digits)
{
  Vec6 d       = Vec6::Zero();
  d[2]         = 1e-9;
  const Vec2 u = BlockMotion(centre, d).displacement(centre + Vec2(1., 0.));
  EXPECT_NEAR(u.x(), -0.5e-18, 1e-24);
  EXPECT_NEAR(u.y(), 1e-9, 1e-24);
}



TEST(BlockMotion, stretch_comes_before_rotation)
{
  Vec6 d       = Vec6::Zero();
  d[2]         = 0.5 * M_PI;
  d[3]         = 0.1;
  const Vec2 x = centre + Vec2(1., 0.);
  EXPECT_LT((x + BlockMotion(centre, d).displacement(x) - (centre + Vec2(0., 1.1))).norm(), 1e-14);
}



TEST(BlockMotion, gradient_is_the_derivative_of_the_displacement)
{
  for (const Vec2 &a : {Vec2(1., 0.), Vec2(0., 1.), Vec2(0.6, -0.8)})
    for (const double strain : {0., 1., 50.}) // times (1, -2, 3) 1e-3
      {
        const Vec2 x = centre + Vec2(0.7, -0.4);
        Vec6       d = increment();
        d.tail<3>() *= strain;
        const BlockMotion motion(centre, d);
        const Vec6        gradient = motion.gradient(x + motion.displacement(x), a);
        for (int i = 0; i < 6; ++i)
          {
            const double h    = 1e-6;
            Vec6         plus = d, minus = d;
            plus[i] += h;
            minus[i] -= h;
            const double difference = a.dot(BlockMotion(centre, plus).displacement(x) -
                                            BlockMotion(centre, minus).displacement(x)) /
                                      (2. * h);
            EXPECT_NEAR(gradient[i], difference, 1e-9) << i;
          }
      }
}
