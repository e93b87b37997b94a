// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Mass and stiffness on one node-wise sparsity pattern: per pair of nodes one
   * number of the mass matrix [kg/m] (it is the same for both components) and a
   * 2 x 2 block of the stiffness matrix [N/m per m], and of the correction of the inertia where
   * the time integration asks for it (inertia_correction.h). All are symmetric and held
   * whole on every rank; products are shared out by rows and gathered.
   */
  class NodeMatrices
  {
  public:
    std::vector<int>    row_start;          ///< per node, and one past the end
    std::vector<int>    column;             ///< nodes, ascending in each row
    std::vector<double> mass;               ///< per entry [kg/m]
    std::vector<double> stiffness;          ///< per entry xx, xy, yx, yy [N/m per m]
    std::vector<double> inertia_correction; ///< per entry xx, xy, yx, yy [kg/m]; empty: none
    MPI_Comm            communicator = MPI_COMM_SELF;

    int n_nodes() const
    {
      return static_cast<int>(row_start.size()) - 1;
    }

    /// Position of (row, column) in the pattern, -1 if absent.
    int entry(int row, int col) const;

    /// y = M x.
    void multiply_mass(const double *x, double *y) const;

    /// y = (M + correction) x: what acceleration x takes.
    void multiply_inertia(const double *x, double *y) const;

    /// y += factor * correction x.
    void add_inertia_correction(double factor, const double *x, double *y) const;

    /// y = K x.
    void multiply_stiffness(const double *x, double *y) const;

    /// Split the rows among the ranks; to be called once when the pattern is complete.
    void share_rows(MPI_Comm comm);

  private:
    void gather(double *y) const;

    int              first_row = 0, last_row = 0;
    std::vector<int> counts, offsets; ///< per rank, in unknowns; empty on a single rank
  };
} // namespace hybrid::continuum
