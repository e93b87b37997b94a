// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_values.h>

#include <limits>
#include <string>

namespace hybrid::scene
{
  /// An interval of allowed numbers; each end belongs to it or not.
  struct ParameterRange
  {
    double low             = -std::numeric_limits<double>::infinity();
    double high            = std::numeric_limits<double>::infinity();
    bool   low_is_allowed  = true;
    bool   high_is_allowed = true;

    static ParameterRange any()
    {
      return {};
    }

    static ParameterRange at_least(const double low)
    {
      return {low, std::numeric_limits<double>::infinity(), true, true};
    }

    static ParameterRange above(const double low)
    {
      return {low, std::numeric_limits<double>::infinity(), false, true};
    }

    /// [low, high]
    static ParameterRange closed(const double low, const double high)
    {
      return {low, high, true, true};
    }

    /// (low, high)
    static ParameterRange open(const double low, const double high)
    {
      return {low, high, false, false};
    }

    bool contains(const double value) const
    {
      return (low_is_allowed ? value >= low : value > low) &&
             (high_is_allowed ? value <= high : value < high);
    }

    /// " >= 0 and < 90", or "" if every number is allowed.
    std::string text() const
    {
      std::string result;
      if (low > -std::numeric_limits<double>::infinity())
        result += (low_is_allowed ? " >= " : " > ") + number_text(low);
      if (high < std::numeric_limits<double>::infinity())
        result += (result.empty() ? "" : " and") + std::string(high_is_allowed ? " <= " : " < ") +
                  number_text(high);
      return result;
    }
  };
} // namespace hybrid::scene
