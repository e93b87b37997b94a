// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/probable_error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double step_size = 4e-3;


    /// A smooth pulse of displacement about t = 1 s with the period of 0.5 s.
    double pulse(const double t)
    {
      const double x = 2. * M_PI * (t - 1.);
      return std::exp(-x * x);
    }


    /// Ground that moves with the source, and a point that does @p late seconds later.
    struct Section
    {
      explicit Section(const double late)
      {
        record.corner = 0.;
        record.source = pulse;
        for (int i = 1; i <= 1000; ++i)
          {
            record.time.push_back(i * step_size);
            ground.insert(ground.end(), {pulse(i * step_size), 0.});
            top.insert(top.end(), {2. * pulse(i * step_size - late), 0.});
            still.insert(still.end(), {1e-9 * pulse(i * step_size), 0.});
          }
        record.monitors = {{"ground", &ground}, {"top", &top}, {"still", &still}};
      }

      std::vector<double> ground, top, still;
      ErrorRecord         record;
    };



    TEST(ProbableError, IsTheDelayOfTheWaveOverItsPeak)
    {
      const Section            section(0.8);
      const Summary::ErrorPart error =
        ProbableError(section.record).of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.});
      // Delays by step_size^2/12 w^2 of the way: step_size^2/12 0.8 u''' of u; largest values of
      // derivatives of exp(-x^2): 1, 0.858, 2, 3.90, 12.
      const double k = 2. * M_PI, way = step_size * step_size / 12. * 0.8 * k * k * k;
      EXPECT_NEAR(error.part[0], way * 3.90, 0.1 * way * 3.90);
      EXPECT_NEAR(error.part[1], way * 12. / 0.858, 0.1 * way * 12. / 0.858);
      EXPECT_EQ(error.where[0], "top");
      EXPECT_EQ(error.where[2], "top");
    }


    TEST(ProbableError, LeavesOutAccelerationsThatAreLed)
    {
      Section section(0.8);
      section.record.monitors[1].is_led = true;
      const Summary::ErrorPart error =
        ProbableError(section.record).of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.});
      EXPECT_EQ(error.where[1], "top");
      EXPECT_EQ(error.where[2], "ground");
      section.record.monitors[0].is_led = section.record.monitors[2].is_led = true;
      EXPECT_TRUE(std::isnan(ProbableError(section.record)
                               .of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.})
                               .part[2]));
    }


    TEST(ProbableError, LateDampingThatCancelsTheSchemeLeavesWhatIsLeftOut)
    {
      const Section section(0.8);
      const auto    error = [&](const double beta) {
        return ProbableError(section.record)
          .of_steps({Newmark::preset("trapezoidal"), step_size, beta, 0.})
          .part[1];
      };
      const double alone = error(0.); // (w step_size)^2/12; the damping has -beta w^2 step_size/4
      EXPECT_NEAR(error(step_size / 3.), 0.6 * alone, 0.05 * alone);
      EXPECT_NEAR(error(step_size / 30.), 0.9 * alone, 0.05 * alone);
      EXPECT_NEAR(error(3. * step_size), 8. * alone, 0.8 * alone);
    }



    TEST(ProbableError, DisplacementsAreRelativeToTheBase)
    {
      Section section(0.);
      section.record.base = 1; // top: all that moves does so with it
      const Summary::ErrorPart no =
        ProbableError(section.record).of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.});
      EXPECT_NE(no.where[0], "top");
      EXPECT_LT(no.part[0], 1e-4);
    }


    TEST(ProbableError, LeavesOutWhatComesLater)
    {
      Section section(1.5);
      section.record.until = 1.5; // before the wave is there
      const Summary::ErrorPart error =
        ProbableError(section.record).of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.});
      EXPECT_EQ(error.where[1], "ground");
      EXPECT_LT(error.part[1], 1e-3);
    }


    TEST(ProbableError, ARecordThatEndsWithinTheMotionHasAnErrorOfItsOwn)
    {
      const auto error = [](const double end) {
        Section section(0.3);
        while (section.record.time.back() > end)
          section.record.time.pop_back();
        return ProbableError(section.record)
          .of_steps({Newmark::preset("trapezoidal"), step_size, 0., 0.});
      };
      const Summary::ErrorPart whole = error(4.), cut = error(1.4); // the peak comes at 1.3 s
      for (int q = 0; q < 2; ++q)
        EXPECT_NEAR(cut.part[q], whole.part[q], 0.1 * whole.part[q]);
    }


    TEST(ProbableError, SaysWhereTheMotionHasHardlyBegun)
    {
      const auto where = [](const double end) {
        Section section(0.4); // the pulse passes from 0.75 to 1.25 s, at the top from 1.15 s on
        while (section.record.time.back() > end)
          section.record.time.pop_back();
        return ProbableError(section.record).hardly_begun();
      };
      EXPECT_EQ(where(0.9), "ground");
      EXPECT_EQ(where(1.3), "top");
      EXPECT_EQ(where(1.7), "");
    }


    TEST(ProbableError, SaysWhereALaterWaveHasJustCome)
    {
      const auto where = [](const double end) {
        Section section(0.4); // the pulse passes the top from 1.15 to 1.65 s
        for (std::size_t i = 0; i < section.record.time.size(); ++i)
          section.top[2 * i] += 2. * pulse(section.record.time[i] - 1.8); // and from 2.45 s on
        while (section.record.time.back() > end)
          section.record.time.pop_back();
        return ProbableError(section.record).reached_at_end();
      };
      EXPECT_EQ(where(2.4), "");
      EXPECT_EQ(where(2.49), "top");
      EXPECT_EQ(where(2.6), "");
      EXPECT_EQ(where(3.2), "");
    }


    TEST(ProbableError, MonitorsThatHardlyMoveMayBeginLate)
    {
      Section section(0.);
      for (double &u : section.still)
        u *= 0.;
      section.still[2 * 999] = 1e-6;
      EXPECT_EQ(ProbableError(section.record).hardly_begun(), "");
    }


    TEST(ProbableError, CountsAmplitudesOfTheCorrectedInertia)
    {
      const Section section(0.);
      Newmark       newmark  = Newmark::preset("fourth order");
      newmark.corrected_step = step_size;
      const Summary::ErrorPart error =
        ProbableError(section.record).of_steps({newmark, step_size, 0., 1.});
      const double k = 2. * M_PI;
      EXPECT_NEAR(error.part[0],
                  step_size * step_size / 8. * k * k * 2.,
                  0.05 * step_size * step_size / 8. * k * k * 2.);
    }
  } // namespace
} // namespace hybrid::output
