// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/motion_answer.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr std::size_t rows = 400;


    /// A sine that grows and goes on beyond the end of the record.
    double motion(const double row)
    {
      return row < 0. ? 0. : (1. - std::exp(-row / 40.)) * std::sin(0.3 * row);
    }


    std::vector<double> sampled(const double late)
    {
      std::vector<double> result;
      for (std::size_t i = 0; i < rows; ++i)
        result.push_back(motion(i - late));
      return result;
    }


    std::vector<double>
    sum(std::vector<double> x, const double factor, const std::vector<double> &y)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += factor * y[i];
      return x;
    }


    double size(const std::vector<double> &x)
    {
      double squares = 0.;
      for (const double value : x)
        squares += value * value;
      return std::sqrt(squares);
    }


    /// h * F.
    std::vector<double> answered(const std::vector<double> &pulse)
    {
      const std::vector<double> source = sampled(0.);
      std::vector<double>       result(rows, 0.);
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t k = 0; k <= i; ++k)
          result[i] += pulse[k] * source[i - k];
      return result;
    }


    /// The last lag that has an answer [rows].
    std::size_t last_lag(const std::vector<double> &pulse)
    {
      std::size_t result = 0;
      for (std::size_t k = 0; k < pulse.size(); ++k)
        if (pulse[k] != 0.)
          result = k;
      return result;
    }



    TEST(MotionAnswer, AnswersWithinARecordThatEndsWithinTheMotion)
    {
      const std::vector<double>  echoes = sum(sampled(30.), -0.5, sampled(250.));
      const MotionAnswer::Answer found  = MotionAnswer(sampled(0.)).find(echoes);
      ASSERT_EQ(found.pulse.size(), rows);
      EXPECT_LT(size(found.rest), 0.05 * size(echoes));
      EXPECT_LT(size(sum(sum(echoes, -1., answered(found.pulse)), -1., found.rest)),
                1e-10 * size(echoes));
    }


    TEST(MotionAnswer, LagsAreNoLongerThanNeedBe)
    {
      const MotionAnswer answer(sampled(0.));
      EXPECT_LT(last_lag(answer.find(sampled(3.)).pulse), rows / 64);
      EXPECT_GE(last_lag(answer.find(sampled(50.)).pulse), 50u);
      EXPECT_LT(last_lag(answer.find(sampled(50.)).pulse), rows / 4);
      EXPECT_GE(last_lag(answer.find(sum(sampled(30.), -0.5, sampled(250.))).pulse), 250u);
    }


    TEST(MotionAnswer, NothingAnswersIfNothingShakesOrMoves)
    {
      const std::vector<double> none(rows, 0.);
      EXPECT_EQ(size(MotionAnswer(sampled(0.)).find(none).pulse), 0.);
      const MotionAnswer::Answer found = MotionAnswer(none).find(sampled(0.));
      EXPECT_EQ(size(found.pulse), 0.);
      EXPECT_EQ(found.rest, sampled(0.));
    }
  } // namespace
} // namespace hybrid::output
