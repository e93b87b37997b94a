// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/monitor_summary.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double omega = 2. * M_PI; // 1 Hz

    /// Pairs (ax sin, ay sin) at 1 Hz.
    std::vector<double> sine(const std::vector<double> &time, const double ax, const double ay)
    {
      std::vector<double> pairs;
      for (const double t : time)
        {
          pairs.push_back(ax * std::sin(omega * t));
          pairs.push_back(ay * std::sin(omega * t));
        }
      return pairs;
    }

    std::vector<double> equal_times(const double dt, const int n)
    {
      std::vector<double> time;
      for (int i = 1; i <= n; ++i)
        time.push_back(i * dt);
      return time;
    }


    TEST(MonitorSummary, PeaksAndAmplificationOfASine)
    {
      MonitorReference reference;
      reference.time                 = equal_times(1e-3, 5000);
      const std::vector<double> time = reference.time;
      reference.outcrop_acceleration = sine(time, 2., 1e-16);
      reference.base_displacement    = sine(time, 0.1, 0.);
      const MonitorSummarizer summarizer(reference);
      const MonitorSummary    summary =
        summarizer.summarize(sine(time, 0.4, 0.2), sine(time, 3., 1.), sine(time, -5., 1.));

      EXPECT_NEAR(std::abs(summarizer.outcrop_peak()[0]), 2., 1e-4);
      EXPECT_NEAR(std::abs(summary.peak_displacement[0]), 0.3, 1e-4);
      EXPECT_NEAR(std::abs(summary.peak_displacement[1]), 0.2, 1e-4);
      EXPECT_NEAR(std::abs(summary.peak_velocity[0]), 3., 1e-3);
      EXPECT_NEAR(std::abs(summary.peak_acceleration[0]), 5., 1e-3);
      EXPECT_NEAR(summary.final_displacement[0], 0., 1e-12);
      EXPECT_NEAR(summary.amplification[0], 2.5, 1e-9);
      EXPECT_TRUE(std::isnan(summary.amplification[1]));
      EXPECT_NEAR(summary.amplification_until_first_failure[0], 2.5, 1e-9);
    }


    TEST(MonitorSummary, SpikesOfContactsAreFilteredOut)
    {
      MonitorReference reference;
      reference.time                   = equal_times(1e-3, 4000);
      std::vector<double> acceleration = sine(reference.time, 1., 1.);
      acceleration[2 * 2000]           = 1000.;
      reference.filter_frequency       = 0.;
      EXPECT_EQ(MonitorSummarizer(reference).filtered_peak(acceleration, 4000)[0], 1000.);

      // one sample of 1000 at 250 Hz above the sine: its peak is 1000 dt times the filter's h(0) =
      // 2 pi f / (2 sqrt 2)
      reference.filter_frequency = 1.;
      const double spike =
        1000. * 1e-3 * 2. * M_PI * reference.filter_frequency / (2. * std::sqrt(2.));
      acceleration           = std::vector<double>(8000, 0.);
      acceleration[2 * 2000] = 1000.;
      EXPECT_NEAR(MonitorSummarizer(reference).filtered_peak(acceleration, 4000)[0],
                  spike,
                  0.01 * spike);
    }


    TEST(MonitorSummary, CutStepsDoNotChangeThePeaks)
    {
      MonitorReference reference;
      double           t = 0.;
      for (int i = 0; t < 5.; ++i)
        reference.time.push_back(t += (i / 100) % 3 == 1 ? 0.25e-3 : 1e-3);
      reference.outcrop_acceleration = sine(reference.time, 2., 0.);
      const MonitorSummarizer summarizer(reference);
      const auto              pairs   = sine(reference.time, 4., 1.);
      const MonitorSummary    summary = summarizer.summarize(pairs, pairs, pairs);
      EXPECT_NEAR(std::abs(summary.peak_acceleration[0]), 4., 1e-3);
      EXPECT_NEAR(summary.amplification[0], 2., 1e-6);
      EXPECT_EQ(summary.final_displacement[0], pairs[pairs.size() - 2]);
    }


    TEST(MonitorSummary, FilteredHistoriesHaveEqualStepsAndThePeaks)
    {
      MonitorReference reference;
      reference.time                = equal_times(1e-3, 3000);
      const auto              equal = sine(reference.time, 4., 1.);
      const MonitorSummarizer as_given(reference);
      EXPECT_EQ(as_given.filtered_time(), reference.time);
      EXPECT_EQ(as_given.filtered(equal).size(), equal.size());

      reference.time.insert(reference.time.begin() + 1000, 1.0005); // a step that was cut
      const auto                pairs = sine(reference.time, 4., 1.);
      const MonitorSummarizer   summarizer(reference);
      const std::vector<double> time     = summarizer.filtered_time(),
                                filtered = summarizer.filtered(pairs);
      ASSERT_EQ(filtered.size(), 2 * time.size());
      EXPECT_NEAR(time.back(), reference.time.back(), 1e-3);
      double largest = 0.;
      for (std::size_t i = 0; i < time.size(); ++i)
        {
          EXPECT_NEAR(time[i] - time[0], i * (time[1] - time[0]), 1e-9);
          EXPECT_NEAR(filtered[2 * i], 4. * std::sin(omega * time[i]), 1e-3);
          largest = std::max(largest, std::abs(filtered[2 * i]));
        }
      EXPECT_EQ(largest, std::abs(summarizer.summarize(pairs, pairs, pairs).peak_velocity[0]));
    }


    TEST(MonitorSummary, AmplificationUntilFailureIgnoresWhatComesLater)
    {
      MonitorReference reference;
      reference.time                   = equal_times(1e-3, 6000);
      reference.outcrop_acceleration   = sine(reference.time, 1., 0.);
      reference.first_failure_time     = 3.;
      std::vector<double> acceleration = sine(reference.time, 1.5, 0.);
      for (std::size_t i = 6002; i < acceleration.size(); ++i)
        acceleration[i] *= 4.;
      const MonitorSummarizer summarizer(reference);
      const MonitorSummary summary = summarizer.summarize(acceleration, acceleration, acceleration);
      EXPECT_NEAR(summary.amplification[0], 6., 0.01);
      EXPECT_NEAR(summary.amplification_until_first_failure[0], 1.5, 1e-3);
    }


    TEST(MonitorSummary, RunsOfNoOrOneStepHaveNoSurprises)
    {
      const MonitorSummary nothing = MonitorSummarizer(MonitorReference()).summarize({}, {}, {});
      EXPECT_TRUE(std::isnan(nothing.peak_velocity[0]));
      MonitorReference reference;
      reference.time = {1e-3};
      const MonitorSummary single =
        MonitorSummarizer(reference).summarize({1., 2.}, {3., 4.}, {5., 6.});
      EXPECT_EQ(single.peak_velocity[1], 4.);
      EXPECT_EQ(single.final_displacement[0], 1.);
      EXPECT_TRUE(std::isnan(single.amplification[0]));
    }
  } // namespace
} // namespace hybrid::output
