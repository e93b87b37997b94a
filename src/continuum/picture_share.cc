// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/picture_share.h>

#include <algorithm>
#include <numeric>

namespace hybrid::continuum
{
  PictureShare::PictureShare(const ElementNodes &nodes, const Ownership *ownership)
    : drawn_nodes{0, static_cast<std::size_t>(nodes.size())}
    , drawn_cells{0, nodes.cells.size()}
    , owned(ownership)
  {
    if (owned == nullptr)
      return;
    int rank = 0, ranks = 1;
    MPI_Comm_rank(owned->communicator(), &rank);
    MPI_Comm_size(owned->communicator(), &ranks);
    drawn_nodes = owned->portion();
    drawn_cells = portion_of(nodes.cells.size(), rank, ranks);
    for (std::size_t c = drawn_cells.begin; c < drawn_cells.end; ++c)
      for (const int node : nodes.cells[c])
        if (!drawn_nodes.has(node))
          further.push_back(node);
    std::sort(further.begin(), further.end());
    further.erase(std::unique(further.begin(), further.end()), further.end());
    std::vector<int> wanted(drawn_nodes.size());
    std::iota(wanted.begin(), wanted.end(), static_cast<int>(drawn_nodes.begin));
    wanted.insert(wanted.end(), further.begin(), further.end());
    exchange = owned->exchange(wanted);
  }



  const std::vector<double> &PictureShare::bring(const std::vector<double> &held,
                                                 std::vector<double>       &room) const
  {
    return bring_own(held, true, room);
  }



  const std::vector<double> &PictureShare::bring_own(const std::vector<double> &own,
                                                     const bool                 are_there,
                                                     std::vector<double>       &room) const
  {
    if (owned == nullptr || !are_there)
      return own;
    room.resize(2 * (drawn_nodes.size() + further.size()));
    exchange.bring(own.data(), 2, room.data());
    return room;
  }



  std::size_t PictureShare::place(const int node) const
  {
    if (drawn_nodes.has(node))
      return node - drawn_nodes.begin;
    return drawn_nodes.size() +
           (std::lower_bound(further.begin(), further.end(), node) - further.begin());
  }



  void PictureShare::take_cell(const std::vector<int>    &nodes,
                               const std::vector<double> &brought,
                               std::vector<double>       &of_cell) const
  {
    of_cell.clear();
    if (brought.empty())
      return;
    for (const int node : nodes)
      {
        const std::size_t i = 2 * place(node);
        of_cell.insert(of_cell.end(), {brought[i], brought[i + 1]});
      }
  }
} // namespace hybrid::continuum
