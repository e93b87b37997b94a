// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/response_spectrum.h>

#include "temporary_files.h"

#include <cmath>
#include <complex>

namespace hybrid::scene::test
{
  namespace
  {
    /// Largest pseudo-acceleration under sin(W t), 0 <= t <= T, from rest: the transient solution
    /// u = Im(X exp(i W t)) + Re(c exp(p t)), evaluated densely.
    double harmonic_response(const double W, const double T, const double w, const double z)
    {
      using Complex    = std::complex<double>;
      const Complex i  = {0., 1.};
      const Complex X  = -1. / (w * w - W * W + 2. * i * z * w * W);
      const double  wd = w * std::sqrt(1. - z * z);
      const double  u0 = -X.imag(), v0 = -W * X.real(); // the free part cancels these at t = 0
      double        largest = 0.;
      for (double t = 0.; t <= T; t += T / 100000.)
        {
          const double steady = (X * std::exp(i * W * t)).imag();
          const double free   = std::exp(-z * w * t) *
                              (u0 * std::cos(wd * t) + (v0 + z * w * u0) / wd * std::sin(wd * t));
          largest = std::max(largest, std::abs(steady + free));
        }
      return w * w * largest;
    }


    Motion harmonic(const double W, const double T, const double dt)
    {
      std::vector<double> a;
      for (int i = 0; i * dt <= T + 1e-9; ++i)
        a.push_back(std::sin(W * i * dt));
      return Motion(dt, a);
    }


    class SpectrumFile : public TemporaryFiles
    {
    protected:
      std::string error(const std::string &text, const bool by_frequency = false) const
      {
        return message_of(
          [&]() { read_response_spectrum(write("spectrum.txt", text), by_frequency, 1.); });
      }
    };
  } // namespace


  TEST(ResponseSpectrum, harmonic_motion_gives_the_transient_solution)
  {
    const double W = 2. * M_PI, T = 6.25; // ends off a zero crossing
    for (const double ratio : {0.2, 0.7, 1., 1.3, 4.})
      for (const double damping : {0.02, 0.05, 0.2})
        {
          // at low frequencies the largest response may follow after the motion
          const double found =
            spectral_acceleration(harmonic(W, 3. * T, 2e-3), ratio * 1., damping);
          EXPECT_NEAR(found / harmonic_response(W, 3. * T, ratio * W, damping), 1., 2e-3)
            << "ratio " << ratio << ", damping " << damping;
        }
  }


  TEST(ResponseSpectrum, resonance_grows_towards_one_over_twice_the_damping)
  {
    const double z = 0.05, cycles = 5.;
    const double grown = (1. - std::exp(-2. * M_PI * z * cycles)) / (2. * z);
    EXPECT_NEAR(spectral_acceleration(harmonic(2. * M_PI, cycles, 1e-3), 1., z),
                grown,
                0.03 * grown);
  }


  TEST(ResponseSpectrum, constant_acceleration_is_doubled_and_a_short_pulse_rings_on)
  {
    const Motion constant(0.01, std::vector<double>(301, 3.));
    EXPECT_NEAR(spectral_acceleration(constant, 1., 0.), 6., 0.01);

    // impulse J: u_max = J/w, reached after the end of the motion
    const Motion pulse(0.001, {0., 100., 0.});
    EXPECT_NEAR(spectral_acceleration(pulse, 1., 0.), 2. * M_PI * 0.1, 2e-3);
  }


  TEST(ResponseSpectrum, stiff_oscillators_follow_the_ground)
  {
    EXPECT_NEAR(spectral_acceleration(harmonic(2. * M_PI, 3.25, 1e-3), 100., 0.05), 1., 1e-3);
  }


  TEST(ResponseSpectrum, interpolates_in_logarithms)
  {
    const ResponseSpectrum spectrum({1., 4., 10.}, {2., 8., 8.});
    EXPECT_NEAR(spectrum.at(2.), 4., 1e-12);
    EXPECT_EQ(spectrum.at(0.5), 2.);
    EXPECT_EQ(spectrum.at(20.), 8.);
    EXPECT_NEAR(spectrum.at(7.), 8., 1e-12);
  }


  TEST_F(SpectrumFile, periods_and_frequencies_in_either_direction)
  {
    const ResponseSpectrum by_period =
      read_response_spectrum(write("p.txt", "0, 0.1\n0.1, 0.25\n0.5, 0.25\n2, 0.0625\n"),
                             false,
                             10.);
    EXPECT_NEAR(by_period.lowest_frequency(), 0.5, 1e-12);
    EXPECT_NEAR(by_period.highest_frequency(), 10., 1e-12);
    EXPECT_NEAR(by_period.at(1.), 1.25, 1e-12);
    const ResponseSpectrum by_frequency =
      read_response_spectrum(write("f.txt", "0.5 0.625\n2 2.5\n10 2.5\n"), true, 1.);
    for (const double f : {0.6, 1., 3., 9.})
      EXPECT_NEAR(by_period.at(f), by_frequency.at(f), 1e-12);
  }


  TEST_F(SpectrumFile, broken_files_are_refused_with_their_line)
  {
    expect_part(error("0.1 1\n0.2 1 3\n"),
                "spectrum.txt:2: found 3 columns; expected a period [s]");
    expect_part(error("0.1 1\n-0.2 1\n"), "spectrum.txt:2: '-0.2, 1' must be a period [s]");
    expect_part(error("0.1 1\n0.2 0\n"), "both above zero");
    expect_part(error("0.1 1\n0.3 1\n0.2 1\n"), "spectrum.txt:3: 0.2 is out of order");
    expect_part(error("0.1 1\n0.1 1\n"), "spectrum.txt:2: 0.1 stands in the row before too");
    expect_part(error("0.1 1\n"), "at least two rows");
    expect_part(error("1 1\nx 1\n", true), "a frequency [Hz]");
  }
} // namespace hybrid::scene::test
