// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/weibull.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene::test
{
  namespace
  {
    constexpr int n = 40000;

    /// Factors of n places on a grid.
    std::vector<double> sample(const double shape, const std::uint64_t seed)
    {
      const Weibull       weibull(shape);
      std::vector<double> x;
      for (int i = 0; i < n; ++i)
        x.push_back(
          weibull.quantile(number_of_place(seed, {Vec2(0.5 * (i % 200), 0.5 * (i / 200))})));
      return x;
    }


    /// P(X <= x) of mean 1.
    double distribution(const double shape, const double x)
    {
      return -std::expm1(-std::pow(x * std::tgamma(1. + 1. / shape), shape));
    }
  } // namespace


  TEST(Weibull, mean_is_one_and_variance_is_that_of_the_gamma_function)
  {
    for (const double m : {1., 2., 5., 20.})
      {
        const std::vector<double> x    = sample(m, 1);
        double                    mean = 0., square = 0.;
        for (const double value : x)
          {
            mean += value / n;
            square += value * value / n;
          }
        const double variance =
          std::tgamma(1. + 2. / m) / std::pow(std::tgamma(1. + 1. / m), 2) - 1.;
        EXPECT_NEAR(mean, 1., 4. * std::sqrt(variance / n)) << m;
        EXPECT_NEAR((square - mean * mean) / variance, 1., m == 1. ? 0.06 : 0.03) << m;
      }
  }


  TEST(Weibull, sample_has_the_distribution_by_kolmogorov)
  {
    for (const double m : {1., 3., 10.})
      for (const std::uint64_t seed : {1u, 2u, 77u})
        {
          std::vector<double> x = sample(m, seed);
          std::sort(x.begin(), x.end());
          double distance = 0.;
          for (int i = 0; i < n; ++i)
            {
              const double p = distribution(m, x[i]);
              distance       = std::max({distance, p - double(i) / n, (i + 1.) / n - p});
            }
          EXPECT_LT(distance, 1.63 / std::sqrt(n)) << m << ", seed " << seed; // 1 % level
        }
  }


  TEST(Weibull, quantile_is_the_inverse_of_the_distribution)
  {
    for (double u = 0.001; u < 1.; u += 0.01)
      EXPECT_NEAR(distribution(2.5, Weibull(2.5).quantile(u)), u, 1e-13);
    EXPECT_EQ(Weibull(2.5).quantile(0.), 0.);
  }


  TEST(NumberOfPlace, depends_on_places_and_seed_and_not_on_order)
  {
    const Vec2 a(1., 2.), b(3., 4.), c(5., -0.);
    EXPECT_EQ(number_of_place(1, {a, b, c}), number_of_place(1, {c, a, b}));
    EXPECT_EQ(number_of_place(1, {Vec2(5., 0.)}), number_of_place(1, {c}));
    EXPECT_NE(number_of_place(1, {a, b}), number_of_place(2, {a, b}));
    EXPECT_NE(number_of_place(1, {a, b}), number_of_place(1, {a, c}));
    EXPECT_NE(number_of_place(1, {Vec2(1., 2.)}), number_of_place(1, {Vec2(2., 1.)}));
  }


  TEST(NumberOfPlace, neighbours_and_seeds_are_not_correlated)
  {
    double neighbours = 0., seeds = 0.;
    for (int i = 0; i < n; ++i)
      {
        const double u = number_of_place(1, {Vec2(i, 0.)}) - 0.5;
        neighbours += 12. * u * (number_of_place(1, {Vec2(i + 1, 0.)}) - 0.5) / n;
        seeds += 12. * u * (number_of_place(2, {Vec2(i, 0.)}) - 0.5) / n;
      }
    EXPECT_LT(std::abs(neighbours), 4. / std::sqrt(n));
    EXPECT_LT(std::abs(seeds), 4. / std::sqrt(n));
  }
} // namespace hybrid::scene::test
