// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mpi.h>
#include <vector>

namespace hybrid::continuum
{
  /// Which unknowns are whose, among ranks: brings what each has to the first one, and back.
  class Ownership
  {
  public:
    Ownership() = default;

    /// @param mine of this rank, ascending; each unknown is one rank's @param n of all
    Ownership(std::vector<int> mine, std::size_t n, MPI_Comm communicator);

    /// On a single rank its unknowns are all.
    bool is_alone() const
    {
      return counts.empty();
    }

    MPI_Comm communicator() const
    {
      return comm;
    }

    const std::vector<int> &unknowns() const
    {
      return own;
    }

    /// @p width numbers per unknown, one after the other: of all on the first rank, by number of
    /// the unknown, from those of each rank; all ranks call it. Nothing on a single rank.
    void gather(const std::vector<double> &mine, int width, std::vector<double> &all);

    /// The other way.
    void scatter(const std::vector<double> &all, int width, std::vector<double> &mine);

  private:
    std::vector<int>    own;
    MPI_Comm            comm = MPI_COMM_SELF;
    std::vector<int>    counts, offsets; ///< per rank
    std::vector<int>    unknown_of;      ///< on the first rank: as the ranks send them
    std::vector<double> sent;            ///< on the first rank: what they send

    /// Counts and offsets for @p width numbers per unknown.
    std::vector<int> times(const std::vector<int> &numbers, int width) const;
  };
} // namespace hybrid::continuum
