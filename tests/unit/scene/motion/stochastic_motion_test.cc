// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/earthquake_source.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/stochastic_motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace hybrid::scene::test
{
  namespace
  {
    constexpr int n_seeds = 60;


    MotionParameters earthquake()
    {
      MotionParameters p;
      p.type                = "stochastic";
      p.lowest_frequency    = 0.2;
      p.highest_frequency   = 20.;
      p.baseline_correction = false;
      return p;
    }


    /// |integral of a(t) exp(-i w t) dt| [m/s].
    double fourier_of(const Motion &motion, const double f)
    {
      std::complex<double> sum = 0.;
      for (std::size_t i = 0; i < motion.samples().size(); ++i)
        sum += motion.samples()[i] * std::polar(1., -2. * M_PI * f * i * motion.time_step());
      return std::abs(sum) * motion.time_step();
    }


    /// integral of a^2 dt.
    double energy_of(const Motion &motion)
    {
      double sum = 0.;
      for (const double a : motion.samples())
        sum += a * a;
      return sum * motion.time_step();
    }


    /// Spectral moment 2 int (2 pi f)^k A^2 df in the band [.].
    double moment(const MotionParameters &p, const int k)
    {
      double       sum = 0.;
      const double df  = 1e-3;
      for (double f = p.lowest_frequency; f < p.highest_frequency; f += df)
        sum += std::pow(2. * M_PI * f, k) * std::pow(fourier_amplitude(p.earthquake, f, 2.), 2);
      return 2. * sum * df;
    }


    /// Mean peak of a stationary motion with these moments that lasts for @p duration
    /// (Cartwright & Longuet-Higgins 1956).
    double expected_peak(const double m0, const double m2, const double m4, const double duration)
    {
      const double regular = m2 / std::sqrt(m0 * m4), n = duration / M_PI * std::sqrt(m4 / m2);
      double       sum = 0.;
      const double dz  = 1e-3;
      for (double z = 0.; z < 10.; z += dz)
        sum += 1. - std::pow(1. - regular * std::exp(-z * z), n);
      return std::sqrt(m0 / duration) * std::sqrt(2.) * sum * dz;
    }
  } // namespace



  TEST(StochasticMotion, HasTheSpectrumOfTheSource)
  {
    MotionParameters p = earthquake();
    for (const double f : {0.5, 1., 2., 5., 10.})
      {
        double    sum = 0.;
        const int n   = 300;
        for (p.seed = 1; p.seed <= n; ++p.seed)
          sum += std::pow(fourier_of(make_stochastic_motion(p), f) /
                            fourier_amplitude(p.earthquake, f, 2.),
                          2);
        // Squares of exponential distribution: their mean scatters by 1/sqrt(n) = 6 %.
        EXPECT_NEAR(sum / n, 1., 0.2) << f;
      }
  }



  TEST(StochasticMotion, HasTheIntensityAndThePeakOfTheSource)
  {
    MotionParameters p  = earthquake();
    const double     m0 = moment(p, 0), m2 = moment(p, 2), m4 = moment(p, 4);
    double           energy = 0., peak = 0.;
    for (p.seed = 1; p.seed <= n_seeds; ++p.seed)
      {
        const Motion motion = make_stochastic_motion(p);
        energy += energy_of(motion) / n_seeds;
        peak += motion.peak_acceleration() / n_seeds;
      }
    EXPECT_NEAR(energy / m0, 1., 0.1);
    const double expected = expected_peak(m0, m2, m4, shaking_duration(p.earthquake));
    EXPECT_NEAR(peak / expected, 1., 0.15); // Boore (2003): the two methods agree to some 10 %
    std::printf("peak %.3g m/s2, by random vibrations %.3g m/s2; intensity %.3f of the source's\n",
                peak,
                expected,
                energy / m0);
  }



  TEST(StochasticMotion, TheUpgoingWaveIsHalfOfTheOutcrop)
  {
    MotionParameters p       = earthquake();
    const Motion     outcrop = make_stochastic_motion(p);
    p.outcrop                = false;
    const Motion upgoing     = make_stochastic_motion(p);
    ASSERT_EQ(upgoing.samples().size(), outcrop.samples().size());
    for (std::size_t i = 0; i < outcrop.samples().size(); i += 7)
      EXPECT_NEAR(2. * upgoing.samples()[i], outcrop.samples()[i], 1e-12);
  }



  TEST(StochasticMotion, DependsOnTheSeedAndEndsAtRest)
  {
    MotionParameters p    = earthquake();
    p.baseline_correction = true;
    const Motion one = make_stochastic_motion(p), again = make_stochastic_motion(p);
    EXPECT_EQ(one.samples(), again.samples());
    EXPECT_LT(std::abs(one.velocity(1e3)), 1e-10 * largest_velocity(one));
    EXPECT_LT(std::abs(one.samples().front()), 0.02 * one.peak_acceleration());
    EXPECT_LT(std::abs(one.samples().back()), 0.02 * one.peak_acceleration());
    p.seed = 2;
    EXPECT_NE(make_stochastic_motion(p).samples(), one.samples());
  }



  TEST(StochasticMotion, SaysWhatTheBandLeavesOut)
  {
    MotionParameters p = earthquake();
    EXPECT_LT(intensity_outside(p), 0.02);
    p.highest_frequency  = 3.;
    const double outside = intensity_outside(p);
    EXPECT_GT(outside, 0.5);
    EXPECT_LT(outside, 1.);
    const InputMotion input = make_input_motion(p, TimeParameters());
    ASSERT_FALSE(input.notes.empty());
    EXPECT_NE(input.notes[0].find("magnitude 5 at 20 km"), std::string::npos) << input.notes[0];
    EXPECT_NE(input.notes[0].find("outside 0.2 to 3 Hz"), std::string::npos) << input.notes[0];
  }



  TEST(StochasticMotion, TheWindowHasItsPeakAndItsEnd)
  {
    EXPECT_NEAR(saragoni_hart_window(0.2), 1., 1e-12);
    EXPECT_NEAR(saragoni_hart_window(1.), 0.05, 1e-12);
    EXPECT_LT(saragoni_hart_window(0.19), 1.);
    EXPECT_LT(saragoni_hart_window(0.21), 1.);
    EXPECT_EQ(saragoni_hart_window(0.), 0.);
  }
} // namespace hybrid::scene::test
