// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/sparse_factor.h>

#include <cholmod.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace hybrid::dda
{
  struct SparseFactor::Implementation
  {
    cholmod_common   common;
    cholmod_sparse  *matrix          = nullptr; ///< upper triangle, columns sorted
    cholmod_factor  *factor          = nullptr;
    cholmod_dense   *x               = nullptr; ///< kept workspaces of cholmod_solve2
    cholmod_dense   *y               = nullptr;
    cholmod_dense   *e               = nullptr;
    int              pattern_version = -1;
    bool             ready           = false;
    std::vector<int> column_slot; ///< per matrix block in column order: slot in off_diagonal

    Implementation()
    {
      cholmod_start(&common);
      common.supernodal = CHOLMOD_AUTO;
      common.print      = 0;
    }

    ~Implementation()
    {
      release();
      cholmod_free_dense(&x, &common);
      cholmod_free_dense(&y, &common);
      cholmod_free_dense(&e, &common);
      cholmod_finish(&common);
    }

    void release()
    {
      cholmod_free_sparse(&matrix, &common);
      cholmod_free_factor(&factor, &common);
      ready = false;
    }

    void make_pattern(const BlockMatrix &source);

    void fill_values(const BlockMatrix &source);
  };



  void SparseFactor::Implementation::make_pattern(const BlockMatrix &source)
  {
    release();
    const int n = source.n_blocks();
    // Upper triangle by columns: block column j holds blocks i < j and its own upper triangle.
    std::vector<std::vector<std::array<int, 2>>> above(n); // (i, slot)
    for (std::size_t s = 0; s < source.pairs.size(); ++s)
      above[source.pairs[s][1]].push_back({source.pairs[s][0], static_cast<int>(s)});

    const std::size_t nonzeros = 36 * source.pairs.size() + 21 * static_cast<std::size_t>(n);
    matrix = cholmod_allocate_sparse(6 * n, 6 * n, nonzeros, true, true, 1, CHOLMOD_REAL, &common);
    int *p = static_cast<int *>(matrix->p);
    int *rows = static_cast<int *>(matrix->i);
    int  at   = 0;
    column_slot.clear();
    for (int j = 0; j < n; ++j)
      {
        std::sort(above[j].begin(), above[j].end());
        for (const auto &entry : above[j])
          column_slot.push_back(entry[1]);
        for (int c = 0; c < 6; ++c)
          {
            p[6 * j + c] = at;
            for (const auto &entry : above[j])
              for (int r = 0; r < 6; ++r)
                rows[at++] = 6 * entry[0] + r;
            for (int r = 0; r <= c; ++r)
              rows[at++] = 6 * j + r;
          }
      }
    p[6 * n]        = at;
    factor          = cholmod_analyze(matrix, &common);
    pattern_version = source.pattern_version();
  }



  void SparseFactor::Implementation::fill_values(const BlockMatrix &source)
  {
    const int n      = source.n_blocks();
    double   *values = static_cast<double *>(matrix->x);
    int      *p      = static_cast<int *>(matrix->p);
    int       first  = 0;
    for (int j = 0; j < n; ++j)
      {
        const int blocks_above = (p[6 * j + 1] - p[6 * j] - 1) / 6;
        for (int c = 0; c < 6; ++c)
          {
            double *column = values + p[6 * j + c];
            for (int b = 0; b < blocks_above; ++b)
              for (int r = 0; r < 6; ++r)
                *column++ = source.off_diagonal[column_slot[first + b]](r, c);
            for (int r = 0; r <= c; ++r)
              *column++ = source.diagonal[j](r, c);
          }
        first += blocks_above;
      }
  }



  SparseFactor::SparseFactor()
    : impl(std::make_unique<Implementation>())
  {}



  SparseFactor::~SparseFactor() = default;



  bool SparseFactor::factorize(const BlockMatrix &matrix)
  {
    if (impl->pattern_version != matrix.pattern_version() || impl->matrix == nullptr)
      impl->make_pattern(matrix);
    impl->fill_values(matrix);
    impl->ready = cholmod_factorize(impl->matrix, impl->factor, &impl->common) &&
                  impl->common.status == CHOLMOD_OK;
    return impl->ready;
  }



  bool SparseFactor::ready(const int n_blocks) const
  {
    return impl->ready && static_cast<int>(impl->matrix->nrow) == 6 * n_blocks;
  }



  void SparseFactor::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    cholmod_dense right;
    std::memset(&right, 0, sizeof(right));
    right.nrow = right.d = right.nzmax = impl->matrix->nrow;
    right.ncol                         = 1;
    right.x                            = const_cast<double *>(b.data());
    right.xtype                        = CHOLMOD_REAL;
    right.dtype                        = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A,
                   impl->factor,
                   &right,
                   nullptr,
                   &impl->x,
                   nullptr,
                   &impl->y,
                   &impl->e,
                   &impl->common);
    std::copy_n(static_cast<const double *>(impl->x->x), right.nrow, x.data());
  }
} // namespace hybrid::dda
