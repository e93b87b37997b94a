// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/newmark.h>

#include <gtest/gtest.h>

using hybrid::Newmark;

TEST(Newmark, PresetsHaveTheirParameters)
{
  EXPECT_DOUBLE_EQ(Newmark::preset("trapezoidal").beta, 0.25);
  EXPECT_DOUBLE_EQ(Newmark::preset("trapezoidal").gamma, 0.5);
  EXPECT_DOUBLE_EQ(Newmark::preset("fourth order").beta, 0.25);
  EXPECT_DOUBLE_EQ(Newmark::preset("fourth order").gamma, 0.5);
  EXPECT_DOUBLE_EQ(Newmark::preset("shi").beta, 0.5);
  EXPECT_DOUBLE_EQ(Newmark::preset("shi").gamma, 1.);
}

TEST(Newmark, DissipativePresetIsTheDefaultAndUnconditionallyStable)
{
  const Newmark dissipative = Newmark::preset("dissipative");
  EXPECT_DOUBLE_EQ(dissipative.gamma, 0.6);
  EXPECT_DOUBLE_EQ(dissipative.beta, 0.5 * dissipative.gamma);
  EXPECT_DOUBLE_EQ(dissipative.beta, Newmark().beta);
  EXPECT_DOUBLE_EQ(dissipative.gamma, Newmark().gamma);
}

TEST(Newmark, FilteredPresetIsOfSecondOrder)
{
  const Newmark filtered = Newmark::preset("filtered");
  EXPECT_DOUBLE_EQ(filtered.beta, 0.5 * filtered.gamma);
  EXPECT_NEAR(filtered.filter, filtered.gamma - 0.5, 1e-15); // takes back what the ends differ by
  EXPECT_LE(filtered.filter, 9. / 8.);                       // dashpots stay passive
  for (const char *name : {"dissipative", "trapezoidal", "fourth order", "shi"})
    {
      EXPECT_EQ(Newmark::preset(name).filter, 0.) << name;
      EXPECT_EQ(Newmark::preset(name).velocity_filter, 0.) << name;
    }
  EXPECT_GT(filtered.velocity_filter, 0.);
  EXPECT_LT(filtered.velocity_filter,
            0.5); // above, a stiff contact's velocity no longer changes sign
}

TEST(Newmark, FilterOfAStepAfterAnother)
{
  const Newmark filtered = Newmark::preset("filtered");
  EXPECT_EQ(filtered.filter_in(1e-3, 0.), 0.); // the first step
  EXPECT_DOUBLE_EQ(filtered.filter_in(1e-3, 1e-3), filtered.filter);
  EXPECT_DOUBLE_EQ(filtered.filter_in(1e-3, 4e-3), 0.25 * filtered.filter);
  EXPECT_DOUBLE_EQ(filtered.filter_in(4e-3, 1e-3), filtered.filter);
  EXPECT_EQ(Newmark().filter_in(1e-3, 1e-3), 0.);
}

TEST(Newmark, UnknownPresetIsRefusedWithTheKnownOnes)
{
  try
    {
      Newmark::preset("central");
      FAIL() << "accepted";
    }
  catch (const hybrid::InputError &error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("'central'"), std::string::npos) << text;
      EXPECT_NE(text.find("dissipative | filtered | trapezoidal | fourth order | shi"),
                std::string::npos)
        << text;
    }
}
