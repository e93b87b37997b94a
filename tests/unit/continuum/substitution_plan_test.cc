// SPDX-License-Identifier: GPL-3.0-or-later
#include "dense_supernodes.h"

#include <gtest/gtest.h>

#include <hybrid/continuum/substitution_plan.h>

#include <algorithm>

namespace
{
  using namespace hybrid::continuum;

  std::size_t numbers_of(const SubstitutionPlan &plan, const SubstitutionPlan::Part &part)
  {
    return (part.last_panel < static_cast<int>(plan.panels.size())
              ? plan.panels[part.last_panel].begin
              : plan.n_values) -
           plan.panels[part.first_panel].begin;
  }
} // namespace


TEST(SubstitutionPlan, parts_hold_each_unknown_once)
{
  const DenseSupernodes  factor = two_level_supernodes();
  const SubstitutionPlan plan(factor.pattern());
  std::vector<int>       unknowns = plan.own;
  std::sort(unknowns.begin(), unknowns.end());
  ASSERT_EQ(static_cast<int>(unknowns.size()), factor.n_interior);
  for (int i = 0; i < factor.n_interior; ++i)
    EXPECT_EQ(unknowns[i], i);
  EXPECT_EQ(plan.above().n_outside(), factor.n_surface);
  EXPECT_EQ(plan.above().n_own(), 32);
  EXPECT_EQ(plan.parts.back().last_panel, static_cast<int>(plan.panels.size()));
}


TEST(SubstitutionPlan, parts_below_are_small_and_independent)
{
  const SubstitutionPlan plan(two_level_supernodes().pattern());
  EXPECT_GT(plan.parts.size(), 8u);
  for (std::size_t k = 0; k + 1 < plan.parts.size(); ++k)
    {
      const SubstitutionPlan::Part &part = plan.parts[k];
      EXPECT_LT(numbers_of(plan, part), 0.1 * plan.n_values);
      for (int i = part.first_outside; i < part.last_outside; ++i)
        EXPECT_LT(plan.outside[i], plan.above().n_own() + plan.above().n_outside());
      for (int p = part.first_panel; p < part.last_panel; ++p)
        for (int i = 0; i < 4 * plan.panels[p].n_fours; ++i)
          {
            const int place = plan.row[plan.panels[p].row_begin + i];
            EXPECT_GE(place, plan.panels[p].place + plan.panels[p].columns);
            EXPECT_LE(place, part.n_own() + part.n_outside());
          }
    }
}


TEST(SubstitutionPlan, panels_are_narrow_and_read_in_turn)
{
  const SubstitutionPlan plan(two_level_supernodes().pattern());
  std::size_t            begin  = 0;
  int                    twenty = 0;
  for (const SubstitutionPlan::Panel &panel : plan.panels)
    {
      EXPECT_LE(panel.columns, SubstitutionPlan::widest);
      EXPECT_EQ(panel.begin, begin);
      begin += panel.columns * (panel.columns + 1) / 2 + 4 * panel.n_fours * panel.columns;
      twenty += panel.supernode == 41 ? 1 : 0;
    }
  EXPECT_EQ(plan.n_values, begin);
  EXPECT_EQ(twenty, 3); // of 6, 7 and 7 columns
}


TEST(SubstitutionPlan, packs_what_is_on_and_below_the_diagonal)
{
  const DenseSupernodes     factor({2}, {{2, 3, 4, 5, 6}}, 5);
  const SubstitutionPlan    plan(factor.pattern());
  const std::vector<double> packed = plan.pack(factor.pattern(), factor.values.data());
  const Eigen::MatrixXd     l      = factor.matrix();
  const std::vector<double> triangle{1. / l(0, 0), l(1, 0), 1. / l(1, 1)};
  ASSERT_EQ(packed.size(), 3u + 16u);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(packed[i], triangle[i]);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_EQ(packed[3 + 8 * (i / 4) + 4 * j + i % 4], i < 5 ? l(2 + i, j) : 0.);
}
