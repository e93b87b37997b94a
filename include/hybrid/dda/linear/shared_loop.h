// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace hybrid::dda
{
  /// Whether threads share a loop over @p n blocks, springs or degrees of freedom. Waking a thread
  /// takes as long as some 200 of them (50 us, 0.2 us each), so that a short loop is faster alone.
  /// Results do not depend on it.
  constexpr bool is_worth_sharing(const std::size_t n)
  {
    return n >= 2000;
  }
} // namespace hybrid::dda
