// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /// A part of a list of numbers.
  struct IndexRange
  {
    const int *first, *last; ///< the latter one place after the end

    bool empty() const
    {
      return first == last;
    }

    const int *begin() const
    {
      return first;
    }

    const int *end() const
    {
      return last;
    }
  };
} // namespace hybrid::dda
