// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/lagrange_line.h>
#include <hybrid/continuum/portion.h>
#include <hybrid/continuum/rock_mesh.h>

#include <functional>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Nodes of the finite-element space as plain arrays, numbered in the order in which a
   * loop over the cells meets them: the same on any number of MPI ranks.
   * Unknown 2 n is the horizontal, 2 n + 1 the vertical displacement of node n.
   */
  struct ElementNodes
  {
    explicit ElementNodes(const int degree, const MassQuadrature of_mass = MassQuadrature::gauss)
      : line(degree, of_mass)
    {}

    LagrangeLine                  line;      ///< one-dimensional basis
    std::vector<Vec2>             positions; ///< from node first_position on [m]
    std::vector<std::vector<int>> cells; ///< per cell (p+1)^2 nodes, first local direction fastest
    std::vector<std::array<int, 4>>
                      corners;          ///< per cell: RockMesh nodes at (0,0), (1,0), (0,1), (1,1)
    std::vector<Vec2> corner_positions; ///< of the RockMesh's nodes [m]

    int n_nodes        = 0;
    int first_position = 0; ///< until keep_positions(): the first of all

    int size() const
    {
      return n_nodes;
    }

    /// [m]. @pre it has been kept
    const Vec2 &position(const int node) const
    {
      return positions[node - first_position];
    }

    /// Positions of other nodes go.
    void keep_positions(const Portion &portion);

    /// Nodes of other cells go; their corners stay. @param is_kept whether a cell is
    void keep_cells(const std::function<bool(std::size_t)> &is_kept);

    /// The p+1 nodes along a cell's face, from a to b.
    std::vector<int> along(const RockFace &face) const;

    /// Where local coordinates (x, y) in [0, 1]^2 of a cell lie [m].
    Vec2 map(int cell, const Vec2 &local) const;

    /// Columns: derivatives of map() with respect to the local coordinates [m].
    Eigen::Matrix2d jacobian(int cell, const Vec2 &local) const;

    /// Shape function values at a local point, in the order of cells[c].
    std::vector<double> values(const Vec2 &local) const;

    /// Displacement gradient du_i/dx_j at a local point [-]; @p u x and y of cells[cell] [m].
    Eigen::Matrix2d gradient(int cell, const Vec2 &local, const std::vector<double> &u) const;
  };
} // namespace hybrid::continuum
