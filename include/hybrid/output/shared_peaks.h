// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/ownership.h>
#include <hybrid/output/peak_motion.h>

#include <vector>

namespace hybrid::output
{
  /// Peaks at the nodes of a bedrock that processes share: each keeps those of its own unknowns.
  class SharedPeaks
  {
  public:
    /// @param corner of the accelerations' low-pass [Hz]
    SharedPeaks(const continuum::Ownership &ownership, double corner);

    /// Motions count from now. @param velocity all unknowns; those of this process count [m/s]
    void start(const std::vector<double> &velocity);

    /// After a step of @p dt [s]. @param displacement, velocity as in start() @param base
    /// displacement of the base, x and y [m]
    void add(const std::vector<double> &displacement,
             const std::vector<double> &velocity,
             double                     dt,
             const double              *base);

    /// Peaks of all into those of the first process (null on the others); all call it.
    void collect(PeakMotion *of_all);

    /// The other way, to go on from a checkpoint.
    void spread(PeakMotion *of_all);

  private:
    continuum::Ownership ownership;
    PeakMotion           peaks;
    std::vector<double>  own_displacement, own_velocity, packed, all; ///< work

    void pack(const std::vector<double> &whole, std::vector<double> &own) const;
  };
} // namespace hybrid::output
