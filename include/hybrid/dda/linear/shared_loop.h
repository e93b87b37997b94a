// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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



  /**
   * Sum over @p n blocks or springs, which threads share: @p add takes a number and what it is to
   * be added to. Each part of the sum, and the order in which the parts are summed, depends on @p n
   * alone, and so do the bits. @tparam Sum default: nothing; has operator+=.
   */
  template <typename Sum, typename Add>
  Sum shared_sum(const std::size_t n, const Add &add)
  {
    constexpr std::size_t    n_parts = 16;
    std::array<Sum, n_parts> parts{};
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (std::size_t p = 0; p < n_parts; ++p)
      {
        Sum sum{};
        for (std::size_t k = p * n / n_parts; k < (p + 1) * n / n_parts; ++k)
          add(k, sum);
        parts[p] = sum;
      }
    Sum all{};
    for (const Sum &part : parts)
      all += part;
    return all;
  }
} // namespace hybrid::dda
