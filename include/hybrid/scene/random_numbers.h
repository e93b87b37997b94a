// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace hybrid::scene
{
  /// Random numbers with the same bits on every system: std::mt19937_64 and arithmetic of our own.
  class RandomNumbers
  {
  public:
    explicit RandomNumbers(const std::uint64_t seed)
      : engine(seed)
    {}

    /// Uniform in [0, 1): the upper 53 bits of the engine.
    double uniform()
    {
      return std::ldexp(static_cast<double>(engine() >> 11), -53);
    }

    /// Two independent standard normal deviates [-] (Box and Muller 1958).
    std::pair<double, double> normal_pair()
    {
      const double radius = std::sqrt(-2. * std::log(1. - uniform())); // 1 - [0, 1) is never 0
      const double angle  = 2. * M_PI * uniform();
      return {radius * std::cos(angle), radius * std::sin(angle)};
    }

  private:
    std::mt19937_64 engine;
  };
} // namespace hybrid::scene
