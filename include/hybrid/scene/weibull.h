// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <cstdint>
#include <vector>

namespace hybrid::scene
{
  /**
   * Weibull's distribution of mean 1 (Weibull 1951):
   *   P(X <= x) = 1 - exp(-(x/s)^m),  s = 1 / Gamma(1 + 1/m),
   * so that a property with the factor X keeps its mean. Variance Gamma(1 + 2/m) s^2 - 1.
   */
  class Weibull
  {
  public:
    /// @param shape m [-], > 0: 1 exponential, 3.6 about normal, large: nearly uniform.
    explicit Weibull(double shape);

    /// x with P(X <= x) = @p u, in [0, 1).
    double quantile(double u) const;

  private:
    double m; ///< shape [-]
    double s; ///< scale [-]
  };


  /**
   * A number in [0, 1) that depends on the @p seed and on the places only, not on their order: so a
   * block or joint keeps its number when others are added, renumbered or computed by other threads.
   * The bits of the coordinates are mixed (SplitMix64: Steele, Lea & Flood 2014).
   */
  double number_of_place(std::uint64_t seed, std::vector<Vec2> places);
} // namespace hybrid::scene
