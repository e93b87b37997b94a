// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/material.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /// Material of each cell of the rock, kept once for all that are made of it.
  class CellMaterials
  {
  public:
    CellMaterials() = default;

    /// @param of_cells per cell an index into @p materials
    CellMaterials(std::vector<Material> materials, std::vector<int> of_cells)
      : kinds(std::move(materials))
      , kind_of_cell(std::move(of_cells))
    {}

    /// Each cell has its own.
    CellMaterials(std::vector<Material> of_cells)
      : kinds(std::move(of_cells))
      , kind_of_cell(kinds.size())
    {
      std::iota(kind_of_cell.begin(), kind_of_cell.end(), 0);
    }

    const Material &operator[](const std::size_t cell) const
    {
      return kinds[kind_of_cell[cell]];
    }

    /// Number of cells.
    std::size_t size() const
    {
      return kind_of_cell.size();
    }

  private:
    std::vector<Material> kinds;
    std::vector<int>      kind_of_cell;
  };
} // namespace hybrid::continuum
