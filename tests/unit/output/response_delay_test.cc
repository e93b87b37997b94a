// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/response_delay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace hybrid::output
{
  namespace
  {
    constexpr double spacing = 5e-3, stretch = 1e-3;


    /// A wavelet of 2 Hz about t = 1 s, and its rate.
    double wavelet(const double t)
    {
      const double x = 2. * M_PI * (t - 1.);
      return (1. - 2. * x * x) * std::exp(-x * x);
    }


    double wavelet_rate(const double t)
    {
      const double x = 2. * M_PI * (t - 1.);
      return 2. * M_PI * (4. * x * x * x - 6. * x) * std::exp(-x * x);
    }


    template <typename Function>
    std::vector<double> sampled(const Function &f, const std::size_t rows = 1000)
    {
      std::vector<double> result;
      for (std::size_t i = 0; i < rows; ++i)
        result.push_back(f(i * spacing));
      return result;
    }


    /// In a record of so many rows, and for as long after it.
    template <typename Function>
    std::vector<double> source_of(const Function &f, const std::size_t rows = 1000)
    {
      return sampled(f, 2 * rows);
    }


    /// All frequencies larger by the same part.
    std::vector<double> stretched(const ResponseDelay       &response,
                                  const std::vector<double> &velocity)
    {
      ResponseDelay::Spectrum larger;
      for (const std::complex<double> &s : response.frequencies())
        larger.push_back(stretch * s);
      return response.change(response.delay(velocity).spectrum, larger);
    }


    double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      double result = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        result = std::max(result, std::abs(a[i] - b[i]));
      return result;
    }



    TEST(ResponseDelay, AnEchoIsOffByTheTimeThatItTook)
    {
      const ResponseDelay response(spacing, source_of(wavelet));
      const auto echo  = [](const double t) { return wavelet(t - 0.7) - 0.4 * wavelet(t - 2.1); };
      const auto error = [](const double t) { // s H' F of exp(-s tau)
        return -stretch * (0.7 * wavelet_rate(t - 0.7) - 0.4 * 2.1 * wavelet_rate(t - 2.1));
      };
      const double peak = largest_difference(sampled(error), std::vector<double>(1000, 0.));
      EXPECT_LT(largest_difference(stretched(response, sampled(echo)), sampled(error)), 0.1 * peak);
    }


    TEST(ResponseDelay, WhatMovesWithTheSourceHasNoError)
    {
      const ResponseDelay response(spacing, source_of(wavelet));
      const double        one_second = stretch * 2. * M_PI * 2.; // of a wave that took a second
      EXPECT_LT(largest_difference(stretched(response, sampled(wavelet)),
                                   std::vector<double>(1000, 0.)),
                0.01 * one_second);
    }


    /// Noise about zero with a deviation of one, smoothed over eight rows.
    std::vector<double> noise(const unsigned seed, const std::size_t rows = 4000)
    {
      std::mt19937        random(seed);
      std::vector<double> white(rows + 7), result(rows, 0.);
      for (double &x : white)
        x = (random() / 4294967296. - 0.5) * std::sqrt(12.);
      for (std::size_t i = 0; i < rows; ++i)
        for (int k = 0; k < 8; ++k)
          result[i] += white[i + k] / std::sqrt(8.);
      return result;
    }


    std::vector<double> delayed(const std::vector<double> &x, const std::size_t by)
    {
      std::vector<double> result(x.size(), 0.);
      for (std::size_t i = by; i < x.size(); ++i)
        result[i] = x[i - by];
      return result;
    }


    double rms(const std::vector<double> &x)
    {
      double sum = 0.;
      for (const double value : x)
        sum += value * value;
      return std::sqrt(sum / x.size());
    }


    /// A pulse with little of high frequencies: (1 + (w/20)^2)^-1.5.
    double soft_pulse(const double t)
    {
      return t > 0. ? t * t * std::exp(-20. * t) : 0.;
    }


    /// What an oscillator of 1.5 Hz with 1 % of damping does with a force.
    std::vector<double> oscillation(double (*force)(double), const std::size_t rows)
    {
      constexpr double           w    = 2. * M_PI * 1.5;
      const std::complex<double> turn = std::exp(spacing * w * std::complex<double>(-0.01, 1.));
      std::complex<double>       z    = 0.;
      std::vector<double>        result;
      for (const double now : sampled(force, rows))
        {
          z = turn * z + now;
          result.push_back(z.imag());
        }
      return result;
    }


    /// Largest change of the ringing in the first 9.5 s by d = s^3, up to 25 Hz. (Of a record of 10
    /// s: the longest lags are told by the first rows of the pulse alone, which are small.)
    double change_of_ringing(const std::size_t rows)
    {
      const ResponseDelay     response(spacing, source_of(soft_pulse, rows));
      ResponseDelay::Spectrum cubes;
      for (const std::complex<double> &s : response.frequencies())
        cubes.push_back(s * s * s * std::clamp(2. - s.imag() / (2. * M_PI * 12.5), 0., 1.));
      std::vector<double> change =
        response.change(response.delay(oscillation(soft_pulse, rows)).spectrum, cubes);
      change.resize(1900);
      return largest_difference(change, std::vector<double>(change.size(), 0.));
    }


    TEST(ResponseDelay, ARecordThatEndsWhileItRingsHasTheErrorOfALongerOne)
    {
      const double whole = change_of_ringing(16000), ratio = change_of_ringing(2000) / whole;
      EXPECT_GT(ratio, 0.9);
      EXPECT_LT(ratio, 1.1);
    }


    TEST(ResponseDelay, WhatIsNoAnswerHardlyCountsAsOne)
    {
      const std::size_t         rows   = 4000;
      const std::vector<double> source = noise(1, 2 * rows), other = noise(2, rows);
      const ResponseDelay       response(spacing, source);
      std::vector<double>       motion = delayed(source, 20), error(rows, 0.);
      motion.resize(rows);
      for (std::size_t i = 1; i + 1 < rows; ++i) // -tau d/dt of the echo
        error[i] = -stretch * 20. * 0.5 * (motion[i + 1] - motion[i - 1]);
      for (std::size_t i = 0; i < rows; ++i)
        motion[i] += 0.03 * other[i];
      EXPECT_GT(rms(stretched(response, motion)), 0.9 * rms(error));
      EXPECT_LT(rms(stretched(response, motion)), 2. * rms(error)); // 12 with lags as long as all
    }


    /// A burst of the frequency of the oscillator.
    double burst(const double t)
    {
      return t < 8. ? std::sin(2. * M_PI * 1.5 * t) * std::pow(std::sin(M_PI * t / 8.), 2) : 0.;
    }


    TEST(ResponseDelay, ARecordThatEndsWithinTheMotionHasTheErrorOfALongerOne)
    {
      const auto errors = [](const std::size_t rows) {
        return stretched(ResponseDelay(spacing, source_of(burst, rows)), oscillation(burst, rows));
      };
      const std::vector<double> whole = errors(4000);
      for (const std::size_t rows : {600, 1000, 1600})
        {
          const std::vector<double> cut = errors(rows), known(whole.begin(), whole.begin() + rows);
          EXPECT_LT(largest_difference(cut, known),
                    0.1 * largest_difference(known, std::vector<double>(rows, 0.)))
            << rows;
        }
    }


    TEST(ResponseDelay, WithoutASourceTheWayBeginsAtZero)
    {
      const ResponseDelay response(spacing, std::vector<double>(2000, 0.));
      const auto          error = [](const double t) { // -d/dt of t times the motion
        return -stretch * (wavelet(t) + t * wavelet_rate(t));
      };
      const double peak = largest_difference(sampled(error), std::vector<double>(1000, 0.));
      EXPECT_LT(largest_difference(stretched(response, sampled(wavelet)), sampled(error)),
                0.01 * peak);
    }
  } // namespace
} // namespace hybrid::output
