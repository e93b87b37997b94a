// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/shared_nodes.h>

#include <algorithm>

namespace hybrid::continuum
{
  SharedNodes::SharedNodes(std::vector<int>        nodes,
                           const std::vector<int> &unknowns,
                           const MPI_Comm          communicator)
    : list(std::move(nodes))
    , comm(communicator)
  {
    for (std::size_t k = 0; k < n_unknowns(); ++k)
      {
        const int  unknown = 2 * list[k / 2] + static_cast<int>(k % 2);
        const auto found   = std::lower_bound(unknowns.begin(), unknowns.end(), unknown);
        if (found != unknowns.end() && *found == unknown)
          shares.push_back({static_cast<int>(k), static_cast<int>(found - unknowns.begin())});
      }
    int ranks = 1;
    MPI_Comm_size(comm, &ranks);
    alone = ranks == 1;
    if (alone)
      return;
    const int        count = static_cast<int>(shares.size());
    std::vector<int> places;
    for (const Share &share : shares)
      places.push_back(share.place);
    counts.resize(ranks);
    offsets.assign(ranks, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
    for (int r = 1; r < ranks; ++r)
      offsets[r] = offsets[r - 1] + counts[r - 1];
    place_of.resize(n_unknowns());
    MPI_Allgatherv(
      places.data(), count, MPI_INT, place_of.data(), counts.data(), offsets.data(), MPI_INT, comm);
    sent.resize(shares.size());
    received.resize(n_unknowns());
  }



  void SharedNodes::gather(const double *mine, std::vector<double> &shared)
  {
    shared.resize(n_unknowns());
    if (alone)
      {
        for (const Share &share : shares)
          shared[share.place] = mine[share.local];
        return;
      }
    for (std::size_t k = 0; k < shares.size(); ++k)
      sent[k] = mine[shares[k].local];
    MPI_Allgatherv(sent.data(),
                   static_cast<int>(sent.size()),
                   MPI_DOUBLE,
                   received.data(),
                   counts.data(),
                   offsets.data(),
                   MPI_DOUBLE,
                   comm);
    for (std::size_t k = 0; k < received.size(); ++k)
      shared[place_of[k]] = received[k];
  }



  void SharedNodes::scatter(const std::vector<double> &shared, double *mine) const
  {
    for (const Share &share : shares)
      mine[share.local] = shared[share.place];
  }



  void SharedNodes::add(const std::vector<double> &shared, double *mine) const
  {
    for (const Share &share : shares)
      mine[share.local] += shared[share.place];
  }
} // namespace hybrid::continuum
