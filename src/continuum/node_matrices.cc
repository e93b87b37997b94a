// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/node_matrices.h>

#include <algorithm>

namespace hybrid::continuum
{
  namespace
  {
    /// Rows of which a thread does more in the time it takes to wake it.
    bool is_worth_sharing(const int rows)
    {
      return rows >= 2000;
    }
  } // namespace



  int NodeMatrices::entry(const int row, const int col) const
  {
    const auto begin = column.begin() + row_start[row], end = column.begin() + row_start[row + 1];
    const auto found = std::lower_bound(begin, end, col);
    return found != end && *found == col ? static_cast<int>(found - column.begin()) : -1;
  }


  void NodeMatrices::multiply_mass(const double *x, double *y) const
  {
#pragma omp parallel for schedule(static) if (is_worth_sharing(last_row - first_row))
    for (int i = first_row; i < last_row; ++i)
      {
        double sx = 0., sy = 0.;
        for (int e = row_start[i]; e < row_start[i + 1]; ++e)
          {
            const double *xj = x + 2 * column[e];
            sx += mass[e] * xj[0];
            sy += mass[e] * xj[1];
          }
        y[2 * i]     = sx;
        y[2 * i + 1] = sy;
      }
    gather(y);
  }


  void NodeMatrices::multiply_inertia(const double *x, double *y) const
  {
    multiply_mass(x, y);
    add_inertia_correction(1., x, y);
  }


  void NodeMatrices::add_inertia_correction(const double factor, const double *x, double *y) const
  {
    if (inertia_correction.empty())
      return;
#pragma omp parallel for schedule(static) if (is_worth_sharing(last_row - first_row))
    for (int i = first_row; i < last_row; ++i)
      {
        double sx = 0., sy = 0.;
        for (int e = row_start[i]; e < row_start[i + 1]; ++e)
          {
            const double *xj = x + 2 * column[e];
            const double *m  = inertia_correction.data() + 4 * e;
            sx += m[0] * xj[0] + m[1] * xj[1];
            sy += m[2] * xj[0] + m[3] * xj[1];
          }
        y[2 * i] += factor * sx;
        y[2 * i + 1] += factor * sy;
      }
    gather(y);
  }


  void NodeMatrices::multiply_stiffness(const double *x, double *y) const
  {
#pragma omp parallel for schedule(static) if (is_worth_sharing(last_row - first_row))
    for (int i = first_row; i < last_row; ++i)
      {
        double sx = 0., sy = 0.;
        for (int e = row_start[i]; e < row_start[i + 1]; ++e)
          {
            const double *xj = x + 2 * column[e];
            const double *k  = stiffness.data() + 4 * e;
            sx += k[0] * xj[0] + k[1] * xj[1];
            sy += k[2] * xj[0] + k[3] * xj[1];
          }
        y[2 * i]     = sx;
        y[2 * i + 1] = sy;
      }
    gather(y);
  }


  void NodeMatrices::share_rows(const MPI_Comm comm)
  {
    communicator = comm;
    int rank = 0, size = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    const auto begin = [&](const long r) { return static_cast<int>(r * n_nodes() / size); };
    first_row        = begin(rank);
    last_row         = begin(rank + 1);
    counts.clear();
    offsets.clear();
    for (int r = 0; size > 1 && r < size; ++r)
      {
        counts.push_back(2 * (begin(r + 1) - begin(r)));
        offsets.push_back(2 * begin(r));
      }
  }


  void NodeMatrices::gather(double *y) const
  {
    if (!counts.empty())
      MPI_Allgatherv(MPI_IN_PLACE,
                     0,
                     MPI_DATATYPE_NULL,
                     y,
                     counts.data(),
                     offsets.data(),
                     MPI_DOUBLE,
                     communicator);
  }
} // namespace hybrid::continuum
