// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hybrid::test
{
  /// The only warning must have these words; none: there must be no warning.
  inline void expect_warning(const std::vector<std::string> &warnings,
                             const std::vector<std::string> &words)
  {
    ASSERT_EQ(warnings.size(), words.empty() ? 0u : 1u);
    for (const std::string &word : words)
      EXPECT_NE(warnings[0].find(word), std::string::npos) << warnings[0];
  }
} // namespace hybrid::test
