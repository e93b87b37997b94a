// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/baseline.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_reader.h>

#include "temporary_files.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace hybrid::scene::test
{
  namespace
  {
    class MotionReader : public TemporaryFiles
    {
    protected:
      std::string text_error(const std::string &text) const
      {
        return message_of([&]() { read_text_motion(write("record.txt", text), 1.); });
      }

      std::string at2_error(const std::string &text) const
      {
        return message_of([&]() { read_at2_motion(write("record.at2", text)); });
      }

      Motion at2(const std::string &text) const
      {
        return read_at2_motion(write("record.at2", text));
      }
    };


    MotionParameters synthetic(const int seed)
    {
      MotionParameters parameters;
      parameters.type = "synthetic";
      parameters.seed = seed;
      parameters.peak = 2.4;
      return parameters;
    }


    double largest_displacement(const Motion &motion)
    {
      double largest = 0.;
      for (double t = 0.; t <= motion.duration(); t += motion.time_step())
        largest = std::max(largest, std::abs(motion.displacement(t)));
      return largest;
    }


    /// Velocity and displacement at the end and for ever after are zero to round-off.
    void expect_end_at_rest(const Motion &motion)
    {
      const double T        = motion.duration();
      const double velocity = motion.peak_acceleration() * T;
      EXPECT_LT(std::abs(motion.velocity(T)), 1e-13 * velocity);
      EXPECT_LT(std::abs(motion.displacement(T)), 1e-13 * velocity * T);
      EXPECT_LT(std::abs(motion.displacement(10. * T)), 1e-12 * velocity * T);
    }


    /// |integral of a exp(-i 2 pi f t) dt|^2 by the sum over the samples.
    double power(const Motion &motion, const double f)
    {
      double re = 0., im = 0.;
      for (std::size_t i = 0; i < motion.samples().size(); ++i)
        {
          const double phase = 2. * M_PI * f * (i * motion.time_step());
          re += motion.samples()[i] * std::cos(phase) * motion.time_step();
          im += motion.samples()[i] * std::sin(phase) * motion.time_step();
        }
      return re * re + im * im;
    }


    double band_power(const Motion &motion, const double lowest, const double highest)
    {
      const double df  = 0.25 / motion.duration();
      double       sum = 0.;
      for (double f = lowest + 0.5 * df; f < highest; f += df)
        sum += power(motion, f) * df;
      return sum;
    }
  } // namespace


  TEST_F(MotionReader, NoneIsEmpty)
  {
    EXPECT_TRUE(make_motion(MotionParameters(), 1e-3).empty());
  }


  TEST_F(MotionReader, RickerFollowsItsClosedForms)
  {
    MotionParameters parameters;
    parameters.type      = "ricker";
    parameters.frequency = 2.;
    parameters.peak      = 3.;
    for (const double dt : {1e-3, 1e-2, 0.03})
      {
        const Motion motion = make_motion(parameters, dt);
        EXPECT_EQ(motion.peak_acceleration(), 3.);
        const double t0 = 0.5 * motion.duration();
        EXPECT_NEAR(t0, 0.75, 1e-12); // with any time step
        EXPECT_LT(std::abs(motion.samples().front()), 1e-6 * 3.);
        EXPECT_LT(std::abs(motion.samples().back()), 1e-6 * 3.);
        for (double t = 0.; t < 1.6; t += 0.0123)
          {
            const double s = M_PI * 2. * (t - t0), g = std::exp(-s * s);
            EXPECT_NEAR(motion.acceleration(t), 3. * (1. - 2. * s * s) * g, 2e-4 * 3.);
            EXPECT_NEAR(motion.velocity(t), 3. * (t - t0) * g, 1e-4 * 3. * 0.1);
            EXPECT_NEAR(motion.displacement(t), -3. * g / (2. * M_PI * M_PI * 4.), 1e-4 * 3. / 80.);
          }
      }
  }


  TEST_F(MotionReader, TextRecordIsReadInItsUnit)
  {
    MotionParameters parameters;
    parameters.type                = "text";
    parameters.file_unit           = 0.01;
    parameters.baseline_correction = false;
    parameters.file =
      write("record.txt",
            "# time acceleration (cm/s2)\n 0.10 1.5\n0.12, -2e1\n\n0.14\t+3 # peak\n");
    const Motion plain = make_motion(parameters, 1e-3);
    ASSERT_EQ(plain.samples().size(), 3u);
    EXPECT_NEAR(plain.time_step(), 0.02, 1e-15);
    EXPECT_DOUBLE_EQ(plain.samples()[0], 0.015);
    EXPECT_DOUBLE_EQ(plain.samples()[1], -0.2);
    EXPECT_DOUBLE_EQ(plain.samples()[2], 0.03);

    parameters.peak = 0.7;
    EXPECT_EQ(make_motion(parameters, 1e-3).peak_acceleration(), 0.7);
    EXPECT_NEAR(make_motion(parameters, 1e-3).samples()[2], 0.03 * 3.5, 1e-15);
    parameters.peak = 0.;
    EXPECT_EQ(make_motion(parameters, 1e-3).peak_acceleration(), 0.);
  }


  TEST_F(MotionReader, CommasBetweenDigitsAreDecimalMarksBesideSemicolonsOrBlanks)
  {
    const Motion expected = read_text_motion(write("points.csv", "0,0.5\n0.01,-12\n"), 1.);
    for (const char *const text : {"0;0,5\n0,01;-12\n",
                                   "0,00; 0,5\r\n0,01; -1,2e1\r\n",
                                   "0,00\t0,5\n0,01\t-12,0\n",
                                   "0 0,5\n0,01  -12\n",
                                   "0;0.5\n0.01;-12\n"})
      {
        const Motion motion = read_text_motion(write("commas.csv", text), 1.);
        EXPECT_EQ(motion.samples(), expected.samples()) << text;
        EXPECT_DOUBLE_EQ(motion.time_step(), 0.01) << text;
      }
  }


  TEST_F(MotionReader, FortranWritesExponentsWithD)
  {
    const Motion expected = read_text_motion(write("points.csv", "0,0.5\n0.01,-12\n"), 1.);
    for (const char *const text : {"0.0D+00 5.0D-01\n1.0D-02 -1.2D+01\n", "0 0.5d0\n.1d-1 -12\n"})
      EXPECT_EQ(read_text_motion(write("fortran.txt", text), 1.).samples(), expected.samples());
    EXPECT_NE(text_error("0 1\n0.01 1d\n"), "");
    EXPECT_NE(text_error("0 1\n0.01 1d1d1\n"), "");
  }


  TEST_F(MotionReader, RoundedTimesAreEquallySpaced)
  {
    std::ostringstream text;
    text.precision(4);
    for (int i = 0; i < 2000; ++i)
      text << std::fixed << i * 0.00244 << " " << std::sin(0.01 * i) << "\n";
    EXPECT_NEAR(read_text_motion(write("record.txt", text.str()), 1.).time_step(), 0.00244, 1e-7);

    // 128 samples per second in milliseconds: 7 or 8 apart; without a sample, and in 10 ms, 10 or
    // 0.
    const auto record = [&](const int digits, const int missing) {
      std::ostringstream rows;
      for (int i = 0; i < 2000; ++i)
        if (i != missing)
          rows << std::fixed << std::setprecision(digits) << i / 128. << " " << std::sin(0.01 * i)
               << "\n";
      return rows.str();
    };
    EXPECT_NEAR(read_text_motion(write("record.txt", record(3, -1)), 1.).time_step(),
                1. / 128.,
                1e-6);
    expect_part(text_error(record(3, 700)), "record.txt:701: the spacing of 0.016 s differs");
    expect_part(text_error(record(2, -1)), "does not follow");
  }


  TEST_F(MotionReader, BadTextRecordsAreRefusedWithTheirLine)
  {
    expect_part(text_error(""), "record.txt: found 0 samples");
    expect_part(text_error("0 0\n0.1 x\n"),
                "record.txt:2: 'x' is not a number; expected an acceleration");
    expect_part(text_error("0 0\n0.1 nan\n"), "record.txt:2: 'nan' is not a number");
    expect_part(text_error("0 0\n0.1\n"), "record.txt:2: found 1 column; expected time");
    expect_part(text_error("0 0\n0.1 1\n0.2 1\n0.35 1\n0.45 1\n0.55 1\n"),
                "record.txt:4: the spacing of 0.15 s differs");
    expect_part(text_error("0 0\n0.1 1\n0.1 2\n"),
                "record.txt:3: the time 0.1 s does not follow 0.1 s");
    expect_part(message_of([&]() { read_text_motion((directory / "absent.txt").string(), 1.); }),
                "cannot be read");
  }


  TEST_F(MotionReader, At2HeadersInTheUsualForms)
  {
    const std::string title = "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE, 01/02/03\n";
    const std::string units = "ACCELERATION TIME HISTORY IN UNITS OF G\n";
    for (const char *const count : {"NPTS=   6, dt=  .00244\n",
                                    "NPTS=  6, DT= .00244 SEC\r\n",
                                    "  6    0.00244    NPTS, DT\n",
                                    "NPTS=      6, DT=   .2440E-02 SEC,\n"})
      {
        const Motion motion =
          at2(title + units + count + "  .1E+00 -.2344583E-05 .3\n 1.0\n  0.5 0.25\n");
        EXPECT_DOUBLE_EQ(motion.time_step(), 0.00244);
        ASSERT_EQ(motion.samples().size(), 6u);
        EXPECT_DOUBLE_EQ(motion.samples()[0], 0.980665);
        EXPECT_NEAR(motion.samples()[1], -2.344583e-6 * 9.80665, 1e-18);
        EXPECT_DOUBLE_EQ(motion.samples()[5], 0.25 * 9.80665);
      }
    EXPECT_DOUBLE_EQ(at2("ACCELERATION IN CM/S2\nNPTS= 2, DT= .01\n 100 200\n").samples()[0], 1.);
    EXPECT_DOUBLE_EQ(at2("ACCELERATION IN M/S/S\nNPTS= 2, DT= .01\n 100 200\n").samples()[1], 200.);
    EXPECT_DOUBLE_EQ(at2("ACCELERATION IN FT/S/S\nNPTS= 2, DT= .01\n 1 2\n").samples()[1], 0.6096);
  }


  TEST_F(MotionReader, BadAt2RecordsAreRefused)
  {
    expect_part(at2_error(""), "no header line with NPTS and DT");
    for (const char *what :
         {"VELOCITY TIME SERIES IN UNITS OF CM/S", "DISPLACEMENT TIME SERIES IN UNITS OF CM"})
      expect_part(at2_error(std::string("PEER\n") + what + "\nNPTS= 2, DT= .01\n1 2\n"),
                  std::string(
                    "record.at2:2: this is no record of acceleration: its header says '") +
                    what + "'");
    expect_part(at2_error("0 0\n0.01 1\n"), "set Motion/Type = text");
    expect_part(at2_error("1 2 3\n4 5 6\n"), "no header line with NPTS and DT");
    expect_part(at2_error("title\nNPTS= many\n"), "record.at2:2: the header line");
    expect_part(at2_error("NPTS= 4, DT= .01\n1 2 3\n"), "announces 4 points, but the file has 3");
    expect_part(at2_error("NPTS= 2, DT= .01\n1 2 3\n"), "announces 2 points, but the file has 3");
    expect_part(at2_error("NPTS= 2, DT= 0\n1 2\n"), "at least two points and a positive time step");
    expect_part(at2_error("NPTS= 3, DT= .01\n1 2\n***\n"), "record.at2:3: '***' is not a number");
  }


  TEST_F(MotionReader, BaselineCorrectionRemovesOffsetAndDrift)
  {
    const std::size_t   n  = 2001;
    const double        dt = 0.01;
    std::vector<double> pure(n), dirty(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const double t = i * dt, s = t / 20.;
        pure[i]  = std::sin(2. * M_PI * 1.3 * t) * 16. * s * s * (1. - s) * (1. - s);
        dirty[i] = pure[i] + 0.2 - 0.01 * t + 0.001 * t * t;
      }
    const Motion corrected = baseline_corrected(Motion(dt, dirty));
    expect_end_at_rest(corrected);
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(corrected.samples()[i], pure[i], 2e-3);
    EXPECT_LT(largest_displacement(corrected), 0.1); // 40 m without the correction
    EXPECT_GT(largest_displacement(Motion(dt, dirty)), 30.);
  }


  TEST_F(MotionReader, CorrectedRecordEndsAtRestAndKeepsThePeak)
  {
    MotionParameters   parameters;
    std::ostringstream text;
    for (int i = 0; i <= 800; ++i)
      text << i * 0.01 << " " << 0.02 + std::sin(0.11 * i) * std::exp(-0.005 * i) << "\n";
    parameters.type     = "text";
    parameters.file     = write("record.txt", text.str());
    parameters.peak     = 0.24;
    const Motion motion = make_motion(parameters, 1e-3);
    EXPECT_EQ(motion.peak_acceleration(), 0.24);
    expect_end_at_rest(motion);
  }


  TEST_F(MotionReader, SyntheticMotionHasItsPeakAndEndsAtRest)
  {
    for (const int seed : {1, 2, 77})
      {
        const Motion motion = make_motion(synthetic(seed), 1e-3);
        EXPECT_EQ(motion.peak_acceleration(), 2.4);
        EXPECT_NEAR(motion.duration(), 12., 1e-12);
        EXPECT_NEAR(motion.samples().front(), 0., 1e-12);
        EXPECT_NEAR(motion.samples().back(), 0., 1e-12);
        expect_end_at_rest(motion);
      }
  }


  TEST_F(MotionReader, SyntheticSpectrumLiesInItsBand)
  {
    MotionParameters parameters  = synthetic(1);
    parameters.lowest_frequency  = 1.;
    parameters.highest_frequency = 6.;
    parameters.frequency         = 3.;
    const Motion motion          = make_motion(parameters, 1e-3);
    const double inside          = band_power(motion, 0.8, 6.2);
    EXPECT_LT(band_power(motion, 0., 0.8), 0.01 * inside);
    EXPECT_LT(band_power(motion, 6.2, 20.), 0.01 * inside);

    // more power per Hz around the ground frequency than at the top of the band, on average over
    // seeds
    double around = 0., above = 0.;
    for (int seed = 1; seed <= 8; ++seed)
      {
        parameters.seed = seed;
        const Motion m  = make_motion(parameters, 1e-3);
        around += band_power(m, 2.5, 3.5);
        above += band_power(m, 5., 6.);
      }
    EXPECT_GT(around, 1.5 * above);
  }


  TEST_F(MotionReader, SyntheticMotionDependsOnItsSeedOnly)
  {
    const Motion a = make_motion(synthetic(3), 1e-3);
    EXPECT_EQ(a.samples(), make_motion(synthetic(3), 1e-3).samples());
    EXPECT_EQ(a.samples(),
              make_motion(synthetic(3), 2e-2).samples()); // not on the time step of the run
    EXPECT_NE(a.samples(), make_motion(synthetic(4), 1e-3).samples());
  }


  TEST_F(MotionReader, AccelerationsOfAnotherWorldAreRefused)
  {
    const std::string file = write("record.txt", "0 0\n0.1 1e308\n0.2 0\n");
    expect_part(message_of([&]() { read_text_motion(file, 9.80665); }),
                "record.txt:2: the acceleration 1e308 is inf m/s2; at most 10000 m/s2 are allowed");
  }


  TEST_F(MotionReader, ContradictionsAreRefused)
  {
    MotionParameters parameters  = synthetic(1);
    parameters.highest_frequency = 0.2;
    expect_part(message_of([&]() { make_motion(parameters, 1e-3); }),
                "Motion/Highest frequency is 0.2");
    parameters.type = "cosine";
    expect_part(message_of([&]() { make_motion(parameters, 1e-3); }), "Motion/Type is 'cosine'");
    parameters.type = "text";
    parameters.peak = 1.;
    parameters.file = write("record.txt", "0 0\n0.1 0\n0.2 0\n");
    expect_part(message_of([&]() { make_motion(parameters, 1e-3); }),
                "cannot be scaled to the peak of 1 m/s2");
  }


  TEST_F(MotionReader, AHeadingIsLeftOut)
  {
    for (const char *heading :
         {"Time (s);Acc (m/s2)\n", "a record\n\ntime, acceleration\n", "# t a\nt a\n"})
      {
        const Motion motion =
          read_text_motion(write("record.txt", std::string(heading) + "0 0\n0.1 1\n0.2 0\n"), 1.);
        EXPECT_EQ(motion.samples().size(), 3u) << heading;
        EXPECT_EQ(motion.peak_acceleration(), 1.) << heading;
      }
  }


  TEST_F(MotionReader, WhatWouldMakeARecordReadableIsSaid)
  {
    expect_part(text_error("0 0\ntime acc\n0.01 1\n"),
                "record.txt:2: 'time' is not a number; expected a time [s] (a line of words must "
                "start with #)");
    expect_part(text_error("nan inf\n0 0\n"), "record.txt:1: 'nan' is not a number");
    expect_part(text_error("0,00,0,0\n0,01,0,3\n"), "record.txt:1: found 4 columns");
    expect_part(text_error("\"0\",\"0\"\n\"1\",\"0\"\n"), "(leave the quotation marks away)");
    expect_part(text_error("0.1\n0.2\n0.3\n"), "to accelerations alone add the time before each");
    expect_part(text_error("PEER NGA\nACC IN G\nNPTS=  3, DT= .01\n 0.1 0.2 0.3\n"),
                "record.txt:3: this is a record of PEER (NPTS and DT in its header); set "
                "Motion/Type = at2");
    EXPECT_EQ(text_error("0 0\n0.01 x\n").find("("), std::string::npos);
  }
} // namespace hybrid::scene::test
