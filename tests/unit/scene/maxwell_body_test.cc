// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/maxwell_body.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;

  constexpr double        turn = 2. * M_PI;
  constexpr FrequencyBand decade{1., 10.};
} // namespace



TEST(MaxwellBody, holds_a_ratio_over_its_band)
{
  for (const double ratio : {0.005, 0.02, 0.05, 0.1})
    for (const FrequencyBand band : {decade, FrequencyBand{0.5, 10.}, FrequencyBand{0.02, 0.1}})
      {
        const MaxwellBody body  = maxwell_body(ratio, band, 3);
        const double      limit = band.highest / band.lowest > 10. ? 0.02 : 0.01;
        EXPECT_LT(ratio_error(body, ratio, band), limit) << ratio << ' ' << band.lowest;
        EXPECT_GT(body.relaxed, 0.);
        for (const double weight : body.weight)
          EXPECT_GE(weight, 0.);
        for (double f = band.lowest; f <= band.highest; f *= 1.07)
          EXPECT_NEAR(body.damping_ratio(turn * f), ratio, limit * ratio);
      }
  EXPECT_LT(ratio_error(maxwell_body(0.05, {0.1, 20.}, 5), 0.05, {0.1, 20.}), 0.03);
  EXPECT_LT(ratio_error(maxwell_body(0.05, {3., 3.3}, 3), 0.05, {3., 3.3}), 0.01);
}



TEST(MaxwellBody, waves_of_the_middle_have_the_speed_of_the_material)
{
  for (const double ratio : {0.02, 0.1})
    {
      const MaxwellBody body  = maxwell_body(ratio, decade, 3);
      const auto        speed = [&](const double f) {
        return 1. / (1. / std::sqrt(body.modulus(turn * f))).real();
      };
      EXPECT_NEAR(speed(std::sqrt(10.)), 1., 1e-12);
      // Kjartansson (1979): c ~ w^g, g = atan(1/Q)/pi, where all frequencies have this Q
      const double g = std::atan(2. * ratio) / M_PI;
      EXPECT_NEAR(speed(7.) / speed(1.4), std::pow(5., g), 0.05 * (std::pow(5., g) - 1.));
      // slow strain is softer, fast strain stiffer
      EXPECT_LT(body.relaxed, 1.);
      EXPECT_GT(std::abs(body.modulus(1e9)), 1.);
    }
}



TEST(MaxwellBody, without_damping_it_is_the_spring)
{
  const MaxwellBody body = maxwell_body(0., decade, 3);
  EXPECT_EQ(body.n_branches(), 0u);
  EXPECT_EQ(body.relaxed, 1.);
  EXPECT_EQ(body.step_modulus(1e-3), 0.);
}



// One branch under a harmonic strain: the rule of a step is that of the frequency
// (2/dt) tan(w dt/2), whatever the step.
TEST(MaxwellBody, a_step_has_the_modulus_of_a_shifted_frequency)
{
  const MaxwellBody body = maxwell_body(0.05, decade, 3);
  for (const double dt : {1e-3, 2e-2, 0.2})
    {
      const double               omega = turn * 2., warped = 2. / dt * std::tan(0.5 * omega * dt);
      const std::complex<double> z = std::exp(std::complex<double>(0., omega * dt));
      std::complex<double>       m = body.relaxed;
      for (std::size_t l = 0; l < body.n_branches(); ++l)
        m += body.weight[l] * body.gained(dt, l) * (z - 1.) / (z - body.kept(dt, l));
      EXPECT_NEAR(std::abs(m - body.modulus(warped)), 0., 1e-12);
    }
}



// Work of the mean stress is what the spring stores and the dashpot takes.
TEST(MaxwellBody, energy_of_a_step_is_exact)
{
  const MaxwellBody body = maxwell_body(0.1, decade, 3);
  for (const double dt : {1e-3, 1e-1, 10.})
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        const double s0 = 0.3, strain = -0.7;
        const double s1   = body.kept(dt, l) * s0 + body.gained(dt, l) * strain;
        const double loss = 0.25 * dt / body.time[l] * (s0 + s1) * (s0 + s1);
        EXPECT_NEAR(0.5 * (s0 + s1) * strain, 0.5 * (s1 * s1 - s0 * s0) + loss, 1e-14);
      }
}
