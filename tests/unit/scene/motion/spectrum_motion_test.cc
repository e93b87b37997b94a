// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/spectrum_motion.h>

#include "temporary_files.h"

#include <cmath>

namespace hybrid::scene::test
{
  namespace
  {
    /// A design spectrum of the usual shape (Eurocode 8, type 1, ground B) for 1 m/s2, times 3.
    double design_spectrum(const double period)
    {
      const double s = 1.2, tb = 0.15, tc = 0.5, td = 2., a = 3. * s;
      if (period < tb)
        return a * (1. + 1.5 * period / tb);
      if (period < tc)
        return 2.5 * a;
      return period < td ? 2.5 * a * tc / period : 2.5 * a * tc * td / (period * period);
    }


    class SpectrumMotionTest : public TemporaryFiles
    {
    protected:
      MotionParameters parameters(const int seed) const
      {
        std::string text = "# period [s], acceleration [cm/s2]\n0, 360\n";
        for (double period = 0.03; period < 4.; period *= 1.05)
          text +=
            std::to_string(period) + ", " + std::to_string(100. * design_spectrum(period)) + "\n";
        MotionParameters p;
        p.type              = "spectrum";
        p.spectrum_file     = write("target.csv", text);
        p.file_unit         = 0.01;
        p.lowest_frequency  = 0.4;
        p.highest_frequency = 20.;
        p.duration          = 20.;
        p.seed              = seed;
        return p;
      }
    };
  } // namespace


  TEST_F(SpectrumMotionTest, meets_the_spectrum_within_five_per_cent_on_average)
  {
    for (const int seed : {1, 2})
      {
        const SpectrumMotion made = make_spectrum_motion(parameters(seed));
        EXPECT_LT(made.fit.mean_misfit(), 0.05);
        EXPECT_LT(made.fit.largest_misfit(), 0.25);
        std::printf("seed %d: mean misfit %.3g %%, largest %.3g %%\n",
                    seed,
                    100. * made.fit.mean_misfit(),
                    100. * made.fit.largest_misfit());

        // measured anew, against the formula, between the points of the iteration
        double    sum = 0.;
        const int n   = 157;
        for (int i = 0; i < n; ++i)
          {
            const double f = 0.4 * std::pow(50., (i + 0.5) / n);
            sum +=
              std::abs(spectral_acceleration(made.motion, f, 0.05) / design_spectrum(1. / f) - 1.);
          }
        EXPECT_LT(sum / n, 0.05);
      }
  }


  TEST_F(SpectrumMotionTest, ends_at_rest_and_depends_on_the_seed_only)
  {
    MotionParameters p       = parameters(1);
    p.highest_frequency      = 5.;
    p.duration               = 8.;
    const SpectrumMotion one = make_spectrum_motion(p);
    EXPECT_NEAR(one.motion.duration(), 8., 1e-9);
    EXPECT_LT(std::abs(one.motion.velocity(25.)), 1e-10);
    EXPECT_LT(std::abs(one.motion.displacement(25.)), 1e-9);
    EXPECT_EQ(one.motion.samples(), make_spectrum_motion(p).motion.samples());
    p.seed = 4;
    EXPECT_NE(one.motion.samples(), make_spectrum_motion(p).motion.samples());
  }


  TEST_F(SpectrumMotionTest, bands_that_cannot_be_met_are_refused)
  {
    MotionParameters p  = parameters(1);
    p.lowest_frequency  = 50.;
    p.highest_frequency = 80.;
    expect_part(message_of([&]() { make_spectrum_motion(p); }), "Motion/Highest frequency is 80");
    p          = parameters(1);
    p.duration = 2.;
    expect_part(message_of([&]() { make_spectrum_motion(p); }), "Motion/Duration is 2");
    p.duration = 1e9;
    expect_part(message_of([&]() { make_spectrum_motion(p); }), "at most 10000 periods");
  }
} // namespace hybrid::scene::test
