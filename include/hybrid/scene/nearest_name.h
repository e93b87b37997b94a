// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// The name closest to @p name by edit distance, or "" if none is similar.
  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates);

  /// " (did you mean 'x'?)" for the closest name, or "" if none is similar.
  std::string suggestion(const std::string &name, const std::vector<std::string> &candidates);
} // namespace hybrid::scene
