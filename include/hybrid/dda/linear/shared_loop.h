// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/process_group.h>

#include <array>
#include <cstddef>
#include <type_traits>

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
   * @param group processes that share the parts; null: this one has all
   */
  template <typename Sum, typename Add>
  Sum shared_sum(const std::size_t n, const Add &add, const ProcessGroup *group = nullptr)
  {
    // No pointers, which would mean nothing elsewhere.
    static_assert(std::is_trivially_destructible_v<Sum>);
    constexpr std::size_t    n_parts = 16;
    std::array<Sum, n_parts> parts{};
    const auto [first, last] = own_share(n_parts, group);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (std::size_t p = first; p < last; ++p)
      {
        Sum sum{};
        for (std::size_t k = p * n / n_parts; k < (p + 1) * n / n_parts; ++k)
          add(k, sum);
        parts[p] = sum;
      }
    if (group != nullptr)
      group->gather_shares(parts.data(), n_parts, sizeof(Sum));
    Sum all{};
    for (const Sum &part : parts)
      all += part;
    return all;
  }
} // namespace hybrid::dda
