// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/earthquake_source.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::scene::test
{
  namespace
  {
    /// Boore's example units: bars, dyne cm, km.
    double corner_in_cgs(const double magnitude, const double bars, const double km_per_s)
    {
      const double moment = std::pow(10., 1.5 * magnitude + 16.05);
      return 4.9e6 * km_per_s * std::cbrt(bars / moment);
    }
  } // namespace



  TEST(EarthquakeSource, CornerFrequencyIsBrunes)
  {
    for (const double magnitude : {2., 5., 7.5})
      {
        EarthquakeSource source;
        source.magnitude = magnitude;
        EXPECT_NEAR(corner_frequency(source) / corner_in_cgs(magnitude, 50., 3.5), 1., 1e-12);
      }
  }



  TEST(EarthquakeSource, LongPeriodsShowTheMoment)
  {
    EarthquakeSource source;
    const double     f = 1e-4, w = 2. * M_PI * f;
    const double     displacement = fourier_amplitude(source, f, 2.) / (w * w);
    const double     moment =
      displacement * 4. * M_PI * 2800. * std::pow(3500., 3.) * 20e3 / (2. * 0.55 * std::sqrt(0.5));
    EXPECT_NEAR(moment / std::pow(10., 16.55), 1., 1e-3);
    source.magnitude += 2. / 3.;
    EXPECT_NEAR(fourier_amplitude(source, f, 2.) / (w * w) / displacement, 10., 0.05);
  }



  TEST(EarthquakeSource, ShortPeriodsAreFlatButForAttenuation)
  {
    EarthquakeSource source;
    source.kappa   = 0.;
    source.quality = 1e12;
    const double f = 1e4 * corner_frequency(source);
    EXPECT_NEAR(fourier_amplitude(source, 2. * f, 1.) / fourier_amplitude(source, f, 1.), 1., 1e-6);
    const double flat = fourier_amplitude(source, 10., 1.);
    source.kappa      = 0.04;
    EXPECT_NEAR(fourier_amplitude(source, 10., 1.) / flat, std::exp(-M_PI * 0.4), 1e-9);
    source.quality          = 200.;
    source.quality_exponent = 0.;
    EXPECT_NEAR(fourier_amplitude(source, 10., 1.) / flat,
                std::exp(-M_PI * 0.4 - M_PI * 10. * 20e3 / (200. * 3500.)),
                1e-9);
    EXPECT_NEAR(fourier_amplitude(source, 10., 2.) / fourier_amplitude(source, 10., 1.), 2., 1e-12);
  }



  TEST(EarthquakeSource, ShakingLastsAtTheSourceAndOnTheWay)
  {
    EarthquakeSource source;
    source.distance = 40e3;
    EXPECT_NEAR(shaking_duration(source), 1. / corner_frequency(source) + 2., 1e-12);
  }
} // namespace hybrid::scene::test
