// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// A function given by its values at some places: linear between them, constant beyond the first
  /// and the last.
  struct LinearTable
  {
    std::vector<Vec2> points; ///< place and value, places rising

    bool empty() const
    {
      return points.empty();
    }

    /// @pre not empty
    double operator()(double place) const;

    /// From the first to the last place.
    double lowest() const;
    double highest() const;

    /// Highest value from one place to another [@p from <= @p to].
    double highest_between(double from, double to) const;
  };


  /// What stands in a column of a file, with its unit, and what it may be.
  struct ColumnRange
  {
    std::string name;    ///< "time [s]"
    double      largest; ///< in absolute value
  };


  /// Two columns of @p file, a row of headings allowed. @throws InputError if there is no row, if
  /// the places do not rise or a number is beyond its range.
  LinearTable
  read_linear_table(const std::string &file, const ColumnRange &place, const ColumnRange &value);
} // namespace hybrid::scene
