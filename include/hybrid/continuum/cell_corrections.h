// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/vectorization.h>

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace hybrid::continuum
{
  /**
   * What inertia_correction() adds to the mass of each cell, as dense matrices on the cell's
   * unknowns. Cells of the same shape and material share one.
   */
  class CellCorrections
  {
  public:
    using Lanes = dealii::VectorizedArray<double>;

    /// Shape and material of a cell in whole numbers.
    using Key = std::array<long, 9>;

    bool empty() const
    {
      return of_batch.empty();
    }

    /// The matrix for cells of this kind, if there is one. @return its number, -1: none.
    int find(const Key &key) const;

    int add(const Key &key, Eigen::MatrixXd matrix);

    /// Lane by lane, batch after batch: which matrix.
    void append_batch(const std::array<int, Lanes::size()> &of_lanes)
    {
      of_batch.push_back(of_lanes);
    }

    /// y += factor N x for the cells of a batch. @param x, y values of their unknowns
    void add_product(unsigned int batch, double factor, const Lanes *x, Lanes *y) const;

    double memory() const; ///< [B]

  private:
    std::map<Key, int>                          numbers;
    std::vector<Eigen::MatrixXd>                matrices;
    std::vector<std::array<int, Lanes::size()>> of_batch;
  };
} // namespace hybrid::continuum
