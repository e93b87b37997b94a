// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>
#include <vector>

namespace hybrid::continuum
{
  /**
   * A few nodes - of boundaries, joints, loads - whose values every rank knows, though each node
   * belongs to one: what acts there is computed alike on all ranks. Of n unknowns of the bedrock
   * these are in the order of sqrt(n).
   *
   * A "place" is a position in the list of nodes; vectors of places hold x and y of each.
   */
  class SharedNodes
  {
  public:
    SharedNodes() = default;

    /// @param nodes without repetition @param unknowns those of this rank (2 node + component),
    /// ascending; each is one rank's
    SharedNodes(std::vector<int> nodes, const std::vector<int> &unknowns, MPI_Comm communicator);

    /// In the order of places.
    const std::vector<int> &nodes() const
    {
      return list;
    }

    std::size_t n_unknowns() const
    {
      return 2 * list.size();
    }

    /// Values of all places from those of this rank's unknowns; all ranks call it.
    void gather(const double *mine, std::vector<double> &shared);

    /// Values of places into those of this rank's unknowns.
    void scatter(const std::vector<double> &shared, double *mine) const;

    /// The same, added.
    void add(const std::vector<double> &shared, double *mine) const;

  private:
    /// An unknown of this rank that is shared.
    struct Share
    {
      int place; ///< in vectors of places
      int local; ///< in the rank's unknowns
    };

    std::vector<int>    list;
    std::vector<Share>  shares;
    MPI_Comm            comm  = MPI_COMM_SELF;
    bool                alone = true;
    std::vector<int>    counts, offsets; ///< per rank
    std::vector<int>    place_of;        ///< of what the ranks send, one after the other
    std::vector<double> sent, received;
  };
} // namespace hybrid::continuum
