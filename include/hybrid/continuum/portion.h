// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

namespace hybrid::continuum
{
  /// Things with numbers that follow each other, [begin, end).
  struct Portion
  {
    std::size_t begin = 0, end = 0;

    std::size_t size() const
    {
      return end - begin;
    }

    bool has(const std::size_t number) const
    {
      return begin <= number && number < end;
    }
  };


  /// Things in a portion: as many for each of @p ranks, fewer or none for the last ones.
  inline std::size_t portion_size(const std::size_t n, const int ranks)
  {
    return std::max<std::size_t>(1, (n + ranks - 1) / ranks);
  }


  /// That of a rank, of @p n things.
  inline Portion portion_of(const std::size_t n, const int rank, const int ranks)
  {
    const std::size_t begin = std::min(n, rank * portion_size(n, ranks));
    return {begin, std::min(n, begin + portion_size(n, ranks))};
  }
} // namespace hybrid::continuum
