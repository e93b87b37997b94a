// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/ownership.h>

#include <cstring>
#include <numeric>

namespace hybrid::continuum
{
  Ownership::Ownership(std::vector<int> mine, const std::size_t n, const MPI_Comm communicator)
    : own(std::move(mine))
    , all_nodes(n)
    , comm(communicator)
  {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
    alone   = ranks == 1;
    written = portion_of(n, rank, ranks);
    if (alone)
      {
        in_state = HeldNodes(n);
        return;
      }
    for (std::size_t k = 0; k < own.size(); k += 2)
      own_nodes.push_back(own[k] / 2);
    in_state = HeldNodes(own_nodes);
    std::vector<int> nodes(written.size());
    std::iota(nodes.begin(), nodes.end(), static_cast<int>(written.begin));
    writing = exchange(nodes);
  }



  std::vector<double> Ownership::read(const char *all) const
  {
    std::vector<double> mine(own.size());
    for (std::size_t k = 0; k < own.size(); ++k)
      std::memcpy(&mine[k], all + own[k] * sizeof(double), sizeof(double));
    return mine;
  }



  void Ownership::read_held(const char *all, double *held) const
  {
    for (const int unknown : own)
      std::memcpy(held++, all + unknown * sizeof(double), sizeof(double));
    for (const int node : in_state.others())
      {
        std::memcpy(held, all + 2 * node * sizeof(double), 2 * sizeof(double));
        held += 2;
      }
  }



  void
  Ownership::to_portion(const double *mine, const int width, std::vector<double> &of_portion) const
  {
    of_portion.resize(written.size() * width);
    if (alone)
      std::copy_n(mine, of_portion.size(), of_portion.data());
    else
      writing.bring(mine, width, of_portion.data());
  }



  NodeExchange Ownership::exchange(const std::vector<int> &nodes) const
  {
    return NodeExchange(own_nodes, nodes, all_nodes, comm);
  }
} // namespace hybrid::continuum
