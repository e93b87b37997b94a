// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/output/peak_fields.h>
#include <hybrid/output/peak_motion.h>
#include <hybrid/restart/shared_checkpoint.h>

#include <array>
#include <string>
#include <vector>

namespace hybrid::output
{
  /// PeakFields of a bedrock that processes share: each keeps the peaks of its own unknowns, and
  /// writes a portion of the nodes. All processes call all functions.
  class SharedPeaks
  {
  public:
    /// @param bedrock has an Ownership @param corner of the accelerations' low-pass [Hz]
    SharedPeaks(const continuum::Continuum &bedrock, double corner);

    /// Motions count from now.
    void start(const continuum::ContinuumState &state);

    /// After a step of @p dt [s]. @param base displacement of the base, x and y [m]
    void add(const continuum::ContinuumState &state, double dt, const double *base);

    /// Tables of @p run_file, which have been declared (PeakFields::declare_nodes()) under its
    /// temporary name, and the picture.
    void write(const std::string &run_file, const std::string &picture) const;

    /// What the processes have of the checkpoint. @param of_first the vectors that stand for it in
    /// the first process' state; null on the others
    std::vector<restart::SharedVector> shared_vectors(PeakFields *of_first);

  private:
    const continuum::Continuum               &continuum;
    const continuum::Ownership               &ownership;
    PeakMotion                                peaks;
    std::vector<continuum::Continuum::Facing> facing;         ///< nodes on the two sides of planes
    std::vector<int>                          slipping_nodes; ///< of these, ascending
    std::vector<double>                       slip;           ///< at them, largest magnitudes [m]
    std::vector<std::array<int, 2>>           slots;          ///< of facing nodes, in a state

    double &slip_at(int node);

    /// x and y of the nodes that this process writes.
    std::vector<double> portion_of_peaks(const std::vector<double> &own) const;

    std::vector<double> portion_of_slip() const;

    std::vector<double> portion_of_positions() const;
  };
} // namespace hybrid::output
