// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid
{
  /**
   * Newmark's family of time integration (Newmark 1959):
   *   u1 = u0 + dt v0 + dt^2 ((1/2 - beta) a0 + beta a1),
   *   v1 = v0 + dt ((1 - gamma) a0 + gamma a1).
   * The same pair serves blocks and continuum.
   *
   * With a filter both brackets lose filter m, where m1 = m0 / 2 + (a1 - a0) / 2 remembers how a
   * changed: what Newmark's pair has beyond the mean of both ends counts only as far as it is new.
   * The scheme is then of second order, and damps w by 1.5 filter (w dt)^3 of critical
   * (doc/theory.md).
   */
  struct Newmark
  {
    double beta  = 0.3; ///< [-]
    double gamma = 0.6; ///< [-], >= 1/2; above 1/2 it damps high frequencies

    /// Step size whose period error the inertia of the continuum takes back (inertia_correction.h)
    /// [s]; 0: inertia is mass.
    double corrected_step = 0.;

    /// Of the remembered change of the acceleration, what a step takes back [-]: gamma - 1/2 of a
    /// scheme of second order, or 0: none.
    double filter = 0.;

    /// Of the change of a block's velocity over a step, as far as it is new, what the displacement
    /// has beyond the mean of both velocities, in halves [-]: for blocks that touch others. A
    /// contact that the step does not see would else throw the velocity from one side to the other.
    double velocity_filter = 0.;

    /// Of the change over a step, what is remembered; the rest is of what was before [-].
    static constexpr double memory = 0.5;

    /// What is left of the memory in a step of @p dt after one of @p last_step [s] (0: there was
    /// none) [-]. A shorter step has as much less; a longer one no more than there was, so that
    /// no step creates energy.
    static double remembered_in(double dt, double last_step);

    /// The filter in such a step [-].
    double filter_in(double dt, double last_step) const
    {
      return filter * remembered_in(dt, last_step);
    }

    /**
     * Named presets: "dissipative" (0.3, 0.6), also the pair of Newmark(); "filtered", the same
     * with a filter; "trapezoidal" (1/4, 1/2); "fourth order", the same pair, to be given its
     * corrected_step; "shi" (1/2, 1), the constant-acceleration scheme of Shi (1988). All have 2
     * beta = gamma, with which kinetic and strain energy never rise by themselves (Hughes 1987,
     * chapter 9).
     * @throws InputError for another name.
     */
    static Newmark preset(const std::string &name);
  };
} // namespace hybrid
