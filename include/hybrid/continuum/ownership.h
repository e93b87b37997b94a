// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/held_nodes.h>
#include <hybrid/continuum/node_exchange.h>
#include <hybrid/continuum/portion.h>

#include <cstddef>
#include <mpi.h>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Which unknowns are whose, among ranks, and what each writes: cells are shared out so that few
   * nodes have neighbours elsewhere, files in portions of nodes by number.
   */
  class Ownership
  {
  public:
    Ownership() = default;

    /// @param mine of this rank (2 node + component), ascending; each node is one rank's @param n
    /// nodes of all
    Ownership(std::vector<int> mine, std::size_t n, MPI_Comm communicator);

    /// On a single rank its unknowns are all.
    bool is_alone() const
    {
      return alone;
    }

    MPI_Comm communicator() const
    {
      return comm;
    }

    const std::vector<int> &unknowns() const
    {
      return own;
    }

    std::size_t n_nodes() const
    {
      return all_nodes;
    }

    /// Nodes that this rank writes.
    const Portion &portion() const
    {
      return written;
    }

    /// Nodes that states of this rank hold.
    const HeldNodes &held() const
    {
      return in_state;
    }

    /// Further ones that they are to hold.
    void hold(const std::vector<int> &nodes)
    {
      in_state.add(nodes);
    }

    /// This rank's unknowns from the bytes of a vector of all. @param all 8 bytes per unknown,
    /// anywhere in memory
    std::vector<double> read(const char *all) const;

    /// The same of all nodes that a state holds. @param held takes x and y of each
    void read_held(const char *all, double *held) const;

    /// @p width numbers per node: of this rank's portion, from those of its nodes; all ranks call
    /// it.
    void to_portion(const double *mine, int width, std::vector<double> &of_portion) const;

    /// For @p nodes that this rank wants to know.
    NodeExchange exchange(const std::vector<int> &nodes) const;

  private:
    std::vector<int> own, own_nodes;
    std::size_t      all_nodes = 0;
    MPI_Comm         comm      = MPI_COMM_SELF;
    bool             alone     = true;
    Portion          written;
    NodeExchange     writing; ///< to the portion; not on a single rank
    HeldNodes        in_state;
  };
} // namespace hybrid::continuum
