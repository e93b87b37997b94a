// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mpi.h>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Brings numbers of nodes from the ranks whose they are to ranks that want them, without any
   * rank having all.
   *
   * Who owns what a rank wants is found once: rank k keeps the owners of the k-th portion of the
   * nodes and is asked for them.
   */
  class NodeExchange
  {
  public:
    NodeExchange() = default;

    /// @param mine of this rank, ascending; each node is one rank's @param wanted by this rank, in
    /// any order @param n of all. All ranks call it.
    NodeExchange(const std::vector<int> &mine,
                 const std::vector<int> &wanted,
                 std::size_t             n,
                 MPI_Comm                communicator);

    /// @p width numbers per node, node after node. @param mine as in the constructor @param wanted
    /// as there; has to have the size. All ranks call it.
    void bring(const double *mine, int width, double *wanted) const;

  private:
    MPI_Comm         comm = MPI_COMM_SELF;
    std::vector<int> sent;               ///< places in mine, rank after rank
    std::vector<int> received;           ///< places in wanted, rank after rank
    std::vector<int> n_sent, n_received; ///< per rank
  };
} // namespace hybrid::continuum
