// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hybrid::scene
{
  /**
   * A ground motion in one direction, sampled at equal spacing.
   *
   * The acceleration is linear between the samples and zero outside the record. Velocity and
   * displacement are its exact integrals from rest: before the record they are zero, after it
   * the velocity is constant and the displacement goes on with it (both are zero if the source
   * is baseline-corrected).
   */
  class Motion
  {
  public:
    Motion() = default;

    /// @param dt spacing [s], > 0.  @param acceleration samples [m/s2], the first at t = 0.
    Motion(double dt, std::vector<double> acceleration);

    /// Linear interpolation of the samples [m/s2]; 0 outside the record.
    double acceleration(double t) const;

    /// Exact integral of the interpolated acceleration [m/s].
    double velocity(double t) const;

    /// Exact double integral of the interpolated acceleration [m].
    double displacement(double t) const;

    double time_step() const
    {
      return dt;
    }

    /// Time of the last sample [s].
    double duration() const;

    const std::vector<double> &samples() const
    {
      return a;
    }

    /// Largest absolute acceleration [m/s2].
    double peak_acceleration() const;

    /// Same motion times @p factor.
    Motion scaled(double factor) const;

    bool empty() const
    {
      return a.empty();
    }

  private:
    /// Where a time falls: sample i at or before it, and the time s since that sample [s].
    struct Interval
    {
      std::size_t i;
      double      s;
    };

    /// @pre at least two samples, 0 <= t <= duration()
    Interval interval(double t) const;

    double              dt = 0.;
    std::vector<double> a; ///< acceleration [m/s2]
    std::vector<double> v; ///< velocity at the samples [m/s]
    std::vector<double> u; ///< displacement at the samples [m]
  };
} // namespace hybrid::scene
