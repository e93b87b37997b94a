// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

#include <array>
#include <cstddef>
#include <vector>

namespace hybrid::output
{
  /**
   * Largest acceleration, velocity and displacement of many components, accumulated step by step.
   *
   * Accelerations of single steps are noise above what mesh and step resolve. So the peak
   * acceleration is what an accelerograph records whose transducer has the natural frequency
   * `corner` and 1/sqrt(2) of critical damping: a causal second-order Butterworth low-pass,
   *   y'' = w^2 (a - y) - 2 z w y',
   * integrated by the trapezoidal rule with w = 2/dt tan(pi corner dt) (pre-warped), driven by the
   * change of velocity over the step. Its state (y, y') does not depend on the step size.
   */
  class PeakMotion
  {
  public:
    /// @param corner_frequency of the low-pass [Hz]; 0, or above 0.45 / dt: none
    explicit PeakMotion(const double corner_frequency)
      : corner(corner_frequency)
    {}

    /// Components at rest but for their velocity [m/s], pairs x, y.
    void start(const double *velocity, std::size_t n);

    /// After a step of @p dt [s]. @param base displacement of the base, x and y [m]
    void add(const double *displacement, const double *velocity, double dt, const double *base);

    const std::vector<double> &peak_acceleration() const ///< [m/s2]
    {
      return largest[0];
    }

    const std::vector<double> &peak_velocity() const ///< [m/s]
    {
      return largest[1];
    }

    const std::vector<double> &peak_displacement() const ///< relative to the base [m]
    {
      return largest[2];
    }

    void serialize(restart::Archive &archive);

    static constexpr int n_arrays = 6;

    /// All that it remembers, each a number per component.
    std::array<std::vector<double> *, n_arrays> arrays()
    {
      return {&value, &rate, &previous, &largest[0], &largest[1], &largest[2]};
    }

  private:
    double              corner;
    std::vector<double> value;    ///< y [m/s2]
    std::vector<double> rate;     ///< y' [m/s3]
    std::vector<double> previous; ///< velocity before the step [m/s]
    std::vector<double> largest[3];
  };
} // namespace hybrid::output
