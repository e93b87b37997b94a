// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

namespace hybrid::dda
{
  /**
   * Sweeps or a sparse factor, and when a factor is made anew: what costs least in the long run.
   *
   * Costs are counted operations, not measured times, so that the same input gives the same bits.
   * A factor is bought once what was paid beyond its use amounts to its price (the ski rental
   * problem; Karlin, Manasse, Rudolph and Sleator 1988): the sum is at most twice the best that
   * could have been done. A factor is judged when another one has been made, by all the solutions
   * that it has served: what pays less than was thought is given up, and has to wait longer the
   * next time.
   */
  class PreconditionerChoice
  {
  public:
    /// Estimated for a core of 10 GB/s and 33 GFLOP/s [s].
    struct Costs
    {
      double sweep;         ///< an iteration with sweeps
      double with_factor;   ///< an iteration with a factor
      double factor;        ///< a new factor
      bool   lasts = false; ///< a factor is expected to serve for long: nothing slides
    };

    bool uses_factor() const
    {
      return factored;
    }

    /// Iterations with sweeps, before a factor of this matrix is cheaper.
    int sweep_limit(const Costs &costs) const;

    /// Iterations with the factor of an earlier matrix; 0: make a new one.
    int old_factor_limit(const Costs &costs);

    /// Sweeps took so many iterations.
    void swept(int iterations, bool converged, const Costs &costs);

    /// The factor of an earlier matrix took so many iterations.
    void used_old_factor(int iterations, bool converged, const Costs &costs);

    /// A solution is there, with so many iterations in all with factors. @param n_made factors were
    /// made for it
    void solved(int iterations, int n_made, const Costs &costs);

    /// No factor can be made.
    void give_up_factor();

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    bool   factored    = false;
    double excess      = 0.; ///< paid beyond the use of a new factor [s]
    double patience    = 1.; ///< times a factor's price, before it is bought
    double sweep_cost  = 0.; ///< of a solution with sweeps, as last known [s]
    double factor_cost = 0.; ///< of the solutions with factors since the last judgement [s]
    int    solutions   = 0;  ///< likewise
    int    failures    = 0;  ///< of old factors, in a row
    int    passed_over = 0;  ///< old factors since one was last tried

    void begin_factors();

    void begin_sweeps();
  };
} // namespace hybrid::dda
