// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace hybrid::scene
{
  /// The option of @p name in a registry, or nullptr.
  template <typename Option>
  const Option *find_option(const std::string &name, const std::vector<Option> &options)
  {
    const auto found = std::find_if(options.begin(), options.end(), [&](const Option &option) {
      return option.name == name;
    });
    return found == options.end() ? nullptr : &*found;
  }
} // namespace hybrid::scene
