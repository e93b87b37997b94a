// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/element_nodes.h>
#include <hybrid/continuum/ownership.h>

#include <vector>

namespace hybrid::continuum
{
  /// What a rank draws of the bedrock: a portion of its nodes and one of its cells by number, and
  /// where it finds the motion of their nodes.
  class PictureShare
  {
  public:
    /// @param ownership null: a single rank
    PictureShare(const ElementNodes &nodes, const Ownership *ownership);

    const Portion &nodes() const
    {
      return drawn_nodes;
    }

    const Portion &cells() const
    {
      return drawn_cells;
    }

    /// x and y of the nodes that are drawn and of those of the cells, in the order of place(); all
    /// ranks call it. @param held of a state; this rank's nodes count @return on a single rank
    /// these, else @p room
    const std::vector<double> &bring(const std::vector<double> &held,
                                     std::vector<double>       &room) const;

    /// The same. @param own this rank's unknowns, on a single rank all @param are_there on any
    /// rank; else there is nothing to bring
    const std::vector<double> &
    bring_own(const std::vector<double> &own, bool are_there, std::vector<double> &room) const;

    std::size_t place(int node) const;

    /// x and y of a cell's nodes, from what was brought; empty: of nothing.
    void take_cell(const std::vector<int>    &nodes,
                   const std::vector<double> &brought,
                   std::vector<double>       &of_cell) const;

  private:
    Portion          drawn_nodes, drawn_cells;
    const Ownership *owned;
    std::vector<int> further; ///< nodes of the cells that are not drawn here, ascending
    NodeExchange     exchange;
  };
} // namespace hybrid::continuum
