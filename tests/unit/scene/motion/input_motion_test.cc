// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/input_motion.h>

#include "temporary_files.h"

#include <cmath>
#include <sstream>

namespace hybrid::scene::test
{
  namespace
  {
    class InputMotionTest : public TemporaryFiles
    {
    protected:
      /// Ten seconds of 1 Hz that ends at rest, plus @p offset [m/s2].
      MotionParameters record(const double offset) const
      {
        std::ostringstream text;
        text.precision(15);
        for (int i = 0; i <= 1000; ++i)
          text << 0.01 * i << ' '
               << std::cos(2. * M_PI * 0.01 * i) * std::pow(std::sin(M_PI * i / 1000.), 2) + offset
               << '\n';
        MotionParameters p;
        p.type = "text";
        p.file = write("record.txt", text.str());
        return p;
      }

      static InputMotion make(const MotionParameters &p, const double end_time)
      {
        TimeParameters time;
        time.end_time = end_time;
        return make_input_motion(p, time);
      }
    };
  } // namespace


  TEST_F(InputMotionTest, an_offset_is_found_taken_out_and_said)
  {
    const InputMotion with = make(record(0.05), 10.), without = make(record(0.), 10.);
    EXPECT_TRUE(without.notes.empty());
    EXPECT_TRUE(without.warnings.empty());
    ASSERT_EQ(with.notes.size(), 1u);
    expect_part(with.notes[0], "has an offset: its mean acceleration is 0.05 m/s2 (4.76");
    expect_part(with.notes[0], "ends with 0.5 m/s at 2.5 m; the baseline correction took it out");
    for (double t = 0.; t < 10.; t += 0.0137)
      EXPECT_NEAR(with.motion.acceleration(t), without.motion.acceleration(t), 1e-3);
    EXPECT_NEAR(with.motion.displacement(30.), 0., 1e-10);
  }


  TEST_F(InputMotionTest, a_pulse_that_the_correction_takes_for_an_offset_is_warned_of)
  {
    for (const double rate : {2. * M_PI, 80.}) // half a cycle, and a record that stops within one
      {
        std::ostringstream text;
        for (int i = 0; i <= 500; ++i)
          text << 1e-3 * i << ' ' << 8. * std::sin(rate * 1e-3 * i) << '\n';
        MotionParameters p      = record(0.);
        p.file                  = write("pulse.txt", text.str());
        const InputMotion input = make(p, 0.5);
        ASSERT_EQ(input.warnings.size(), 1u) << rate;
        expect_part(input.warnings[0], "more than an instrument's");
        expect_part(input.warnings[0], "the peak acceleration from 8 to ");
      }
  }


  TEST_F(InputMotionTest, a_record_that_ends_at_rest_stays_as_it_is)
  {
    std::ostringstream text;
    text.precision(15);
    const auto ricker = [](const double t) {
      const double x = std::pow(M_PI * (t - 1.5), 2);
      return 6. * (1. - 2. * x) * std::exp(-x);
    };
    for (int i = 0; i <= 300; ++i)
      text << 0.01 * i << ' ' << ricker(0.01 * i) << '\n';
    MotionParameters p;
    p.type                 = "text";
    p.file                 = write("pulse.txt", text.str());
    const InputMotion rest = make(p, 3.);
    EXPECT_TRUE(rest.warnings.empty());
    EXPECT_EQ(rest.motion.samples()[150], 6.);
    EXPECT_NEAR(rest.motion.samples()[0], ricker(0.), 1e-15);
  }


  TEST_F(InputMotionTest, a_correction_that_changes_peaks_is_warned_of)
  {
    std::ostringstream text; // a cycle of a sine: at rest at its end, but far from where it began
    for (int i = 0; i <= 100; ++i)
      text << 0.01 * i << ' ' << 2. * std::sin(2. * M_PI * 0.01 * i) << '\n';
    MotionParameters p      = record(0.);
    p.file                  = write("cycle.txt", text.str());
    const InputMotion input = make(p, 1.);
    ASSERT_EQ(input.warnings.size(), 1u);
    expect_part(input.warnings[0],
                "the baseline correction changes the peak acceleration from 2 to ");
    p.baseline_correction = false;
    for (const std::string &warning : make(p, 0.6).warnings)
      EXPECT_EQ(warning.find("changes the peak"), std::string::npos);
  }


  TEST_F(InputMotionTest, an_offset_that_stays_is_warned_of)
  {
    MotionParameters p      = record(0.05);
    p.baseline_correction   = false;
    const InputMotion input = make(p, 10.);
    ASSERT_EQ(input.warnings.size(), 1u);
    expect_part(input.warnings[0], "set Motion/Baseline correction = true");
    EXPECT_NEAR(input.motion.velocity(10.), 0.5, 1e-4);
  }


  TEST_F(InputMotionTest, the_vertical_component_is_scaled_like_the_other_or_by_itself)
  {
    MotionParameters p    = record(0.);
    p.vertical_file       = write("up.txt", "0 0\n0.5 0.4\n1 -0.5\n1.5 0.1\n2 0\n");
    p.baseline_correction = false;
    EXPECT_EQ(make(p, 10.).vertical.peak_acceleration(), 0.5);
    expect_part(make(p, 10.).notes.at(0),
                "vertical component: peak 0.5 m/s2 (0.05099 g), scale factor 1 on 0.5 m/s2");
    p.peak                  = 3.;
    const InputMotion input = make(p, 10.);
    EXPECT_NEAR(input.vertical.peak_acceleration(), 3. * 0.5, 1e-12);
    EXPECT_NEAR(input.vertical.duration(), 2., 1e-12);
    p.vertical_peak = 0.7;
    EXPECT_EQ(make(p, 10.).vertical.peak_acceleration(), 0.7);
    p.vertical_peak = 0.;
    EXPECT_EQ(make(p, 10.).vertical.peak_acceleration(), 0.);
    p.vertical_file = write("zero.txt", "0 0\n0.5 0\n1 0\n");
    EXPECT_EQ(make(p, 10.).vertical.peak_acceleration(), 0.);
    p.vertical_peak = 1.;
    EXPECT_THROW(make(p, 10.), InputError);
    p.vertical_file = write("up.txt", "0 0\n0.5\n");
    expect_part(message_of([&]() { make(p, 10.); }), "up.txt");
  }


  TEST_F(InputMotionTest, components_begin_at_the_same_time)
  {
    MotionParameters p = record(0.);
    p.vertical_file    = write("late.txt", "3 0\n3.5 0.4\n4 -0.5\n4.5 0.1\n5 0\n");
    expect_part(message_of([&]() { make(p, 10.); }), "its times begin at 3 s");
    p.file                  = p.vertical_file;
    const InputMotion input = make(p, 10.);
    expect_part(input.notes.at(0), "late.txt begins at 3 s; here it begins with the run");
  }


  TEST_F(InputMotionTest, a_record_shorter_than_the_run_is_zero_afterwards)
  {
    const InputMotion input = make(record(0.), 25.);
    ASSERT_EQ(input.notes.size(), 1u);
    expect_part(input.notes[0], "the motion ends at t = 10 s, the run at 25 s");
    for (const double t : {10.001, 12., 25.})
      {
        EXPECT_EQ(input.motion.acceleration(t), 0.);
        EXPECT_NEAR(input.motion.velocity(t), 0., 1e-12);
        EXPECT_NEAR(input.motion.displacement(t), 0., 1e-10);
      }
  }


  TEST_F(InputMotionTest, a_record_longer_than_the_run_is_said_and_its_lost_peak_warned_of)
  {
    expect_part(make(record(0.), 8.).notes.at(0), "the rest of it is not used");
    expect_part(make(record(0.), 3.).warnings.at(0), "with its peak at t = 5 s");
  }


  TEST_F(InputMotionTest, the_start_counts)
  {
    MotionParameters p = record(0.);
    p.start            = 2.;
    expect_part(make(p, 25.).notes.at(0), "the motion ends at t = 12 s");
  }


  TEST_F(InputMotionTest, events_that_overlap_are_warned_of)
  {
    MotionParameters p    = record(0.);
    p.repetitions         = 3;
    p.repetition_interval = 10.;
    EXPECT_TRUE(make(p, 30.).warnings.empty());
    p.repetition_interval = 9.;
    expect_part(make(p, 30.).warnings.at(0), "lasts 10 s and comes again every 9 s");
  }


  TEST_F(InputMotionTest, a_peak_of_zero_is_said)
  {
    MotionParameters p = record(0.);
    p.peak             = 0.;
    expect_part(make(p, 10.).notes.at(0), "Motion/Peak = 0: nothing shakes");
  }


  TEST_F(InputMotionTest, units_of_text_records)
  {
    MotionParameters p = record(0.);
    const double     a = make(p, 10.).motion.acceleration(5.);
    p.file_unit        = 9.80665;
    EXPECT_NEAR(make(p, 10.).motion.acceleration(5.), 9.80665 * a, 1e-9);
    p.file_unit = 0.01;
    EXPECT_NEAR(make(p, 10.).motion.acceleration(5.), 0.01 * a, 1e-12);
  }


  TEST_F(InputMotionTest, correction_is_switched_for_every_type)
  {
    for (const std::string type : {"sine", "synthetic", "spectrum"})
      {
        MotionParameters p;
        p.type          = type;
        p.cycles        = 3.;
        p.taper         = 0.;
        p.spectrum_file = write("target.txt", "0.1 1\n4 1\n");
        EXPECT_NEAR(make(p, 100.).motion.displacement(100.), 0., 1e-9) << type;
        p.baseline_correction = false;
        EXPECT_GT(std::abs(make(p, 100.).motion.displacement(100.)), 1e-4) << type;
      }
  }


  TEST_F(InputMotionTest, a_ricker_wavelet_of_too_many_samples_is_refused)
  {
    MotionParameters p;
    p.type      = "ricker";
    p.frequency = 1e-2;
    TimeParameters time;
    time.end_time  = 10.;
    time.time_step = 1e-3;
    EXPECT_NEAR(make_input_motion(p, time).motion.duration(), 300., 1e-9);
    for (const double frequency : {1e-6, 1e-12, 1e-300}) // the last ones overflowed the count
      {
        p.frequency = frequency;
        try
          {
            make_input_motion(p, time);
            FAIL() << frequency;
          }
        catch (const InputError &error)
          {
            expect_part(error.what(),
                        "; a Ricker wavelet in steps of 0.001 s has at least 0.003 Hz");
          }
      }
  }


  TEST_F(InputMotionTest, a_peak_scales_the_spectrum_with_the_motion)
  {
    MotionParameters p;
    p.type                = "spectrum";
    p.spectrum_file       = write("target.txt", "0.1 1\n4 1\n");
    const InputMotion one = make(p, 12.);
    expect_part(one.notes.at(0), "from 0.3 to 8 Hz with a mean misfit of ");
    p.peak                = 2. * one.motion.peak_acceleration();
    const InputMotion two = make(p, 12.);
    expect_part(two.notes.at(0), "; scaled to Motion/Peak it has 2 times that spectrum");
    EXPECT_NEAR(two.fit.target[10], 2., 1e-9);
    EXPECT_NEAR(two.fit.reached[10],
                spectral_acceleration(two.motion, two.fit.frequency[10], 0.05),
                1e-9);
  }


  TEST_F(InputMotionTest, the_scale_factor_is_told_of_records_and_spectra)
  {
    MotionParameters p;
    p.type                = "text";
    p.file                = write("record.txt", "0 0\n0.01 1.75\n0.02 -1.75\n0.03 0\n");
    p.baseline_correction = false;
    EXPECT_EQ(make(p, 0.03).scaling, "peak 1.75 m/s2 (0.1785 g) as recorded, scale factor 1");
    p.peak = 0.35;
    EXPECT_EQ(make(p, 0.03).scaling,
              "peak 0.35 m/s2 (0.03569 g), scale factor 0.2 on 1.75 m/s2 (0.1785 g) as recorded");
    p.type = "sine";
    EXPECT_EQ(make(p, 12.).scaling, "");
  }
} // namespace hybrid::scene::test
