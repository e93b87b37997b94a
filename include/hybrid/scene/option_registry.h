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


  /// Names of those for which @p is_meant holds: "a, b or c".
  template <typename Option, typename Predicate>
  std::string names_in_words(const std::vector<Option> &options, const Predicate &is_meant)
  {
    std::vector<std::string> names;
    for (const Option &option : options)
      if (is_meant(option))
        names.push_back(option.name);
    std::string words;
    for (std::size_t k = 0; k < names.size(); ++k)
      words += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + names[k];
    return words;
  }
} // namespace hybrid::scene
