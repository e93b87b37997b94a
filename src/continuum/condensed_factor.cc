// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/condensed_factor.h>

#include <algorithm>
#include <cholmod.h>
#include <cstring>
#include <new>
#include <stdexcept>

namespace hybrid::continuum
{
  class CondensedFactorisation::Factor
  {
  public:
    Factor(cholmod_factor *f, cholmod_common *c)
      : factor(f)
      , common(c)
    {}

    ~Factor()
    {
      cholmod_free_factor(&factor, common);
    }

    Factor(const Factor &)            = delete;
    Factor &operator=(const Factor &) = delete;

    cholmod_factor *factor;
    cholmod_factor  interior; ///< the same without columns of the surface; owns nothing
    cholmod_common *common;
    std::vector<int>
                    interior_super; ///< first column of each supernode of the interior, and the end
    Eigen::MatrixXd surface;        ///< L_GG, lower triangle
  };


  struct CondensedFactorisation::Cholmod
  {
    cholmod_common   common;
    std::vector<int> column_start, row;
    int              n_surface = 0;
    cholmod_factor  *symbolic  = nullptr;
    cholmod_dense   *y = nullptr, *x = nullptr; ///< forward and backward solution, in order of L
    cholmod_dense   *work = nullptr;            ///< of the rows below a supernode
    Eigen::VectorXd  surface_load;              ///< becomes the solution there

    int size() const
    {
      return static_cast<int>(column_start.size()) - 1;
    }

    cholmod_sparse matrix(void *values)
    {
      cholmod_sparse a = {};
      a.nrow = a.ncol = column_start.size() - 1;
      a.nzmax         = row.size();
      a.p             = column_start.data();
      a.i             = row.data();
      a.x             = values;
      a.stype         = -1;
      a.itype         = CHOLMOD_INT;
      a.xtype         = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
      a.dtype         = CHOLMOD_DOUBLE;
      a.sorted        = 1;
      a.packed        = 1;
      return a;
    }

    std::vector<int> ordering();

    /// Most rows below a supernode of the interior, at least 1.
    std::size_t rows_below() const
    {
      return std::max<std::size_t>({1, symbolic->maxesize, static_cast<std::size_t>(n_surface)});
    }

    /// Unknowns of the surface among those in order of L.
    Eigen::Map<Eigen::VectorXd> surface_of(cholmod_dense *dense) const
    {
      return {static_cast<double *>(dense->x) + size() - n_surface, n_surface};
    }
  };


  std::vector<int> CondensedFactorisation::Cholmod::ordering()
  {
    const int        n = size(), n_interior = n - n_surface;
    std::vector<int> group(n, 0), permutation(n);
    std::fill(group.begin() + n_interior, group.end(), 1);
    cholmod_sparse a = matrix(nullptr);
    if (!cholmod_camd(&a, nullptr, 0, group.data(), permutation.data(), &common))
      throw std::runtime_error("CHOLMOD: the constrained ordering failed");
    // The surface comes last; among itself it keeps its own order (the block is full anyway).
    for (int k = 0; k < n; ++k)
      if ((permutation[k] >= n_interior) != (k >= n_interior))
        throw std::logic_error("CHOLMOD: the surface is not the trailing block");
    for (int k = n_interior; k < n; ++k)
      permutation[k] = k;
    return permutation;
  }


  CondensedFactorisation::CondensedFactorisation(std::vector<int> column_start,
                                                 std::vector<int> row,
                                                 const int        n_surface)
    : cholmod(std::make_unique<Cholmod>())
  {
    Cholmod &c = *cholmod;
    cholmod_start(&c.common);
    c.column_start                      = std::move(column_start);
    c.row                               = std::move(row);
    c.n_surface                         = n_surface;
    c.common.supernodal                 = CHOLMOD_SUPERNODAL;
    c.common.final_ll                   = 1;
    c.common.print                      = 0;
    c.common.nmethods                   = 1;
    c.common.method[0].ordering         = CHOLMOD_GIVEN;
    c.common.postorder                  = 0; // it would move the surface away from the end
    c.common.quick_return_if_not_posdef = 1;

    std::vector<int> permutation = c.ordering();
    cholmod_sparse   a           = c.matrix(nullptr);
    c.symbolic                   = cholmod_analyze_p(&a, permutation.data(), nullptr, 0, &c.common);
    if (c.symbolic == nullptr)
      throw std::bad_alloc(); // the pattern is symmetric and sorted: nothing else can fail
    const int *used = static_cast<const int *>(c.symbolic->Perm);
    for (int k = c.size() - n_surface; k < c.size(); ++k)
      if (used[k] != k)
        throw std::logic_error("CHOLMOD: the surface is not the trailing block");
    c.y    = cholmod_zeros(c.size(), 1, CHOLMOD_REAL, &c.common);
    c.x    = cholmod_zeros(c.size(), 1, CHOLMOD_REAL, &c.common);
    c.work = cholmod_zeros(c.rows_below(), 1, CHOLMOD_REAL, &c.common);
  }


  CondensedFactorisation::~CondensedFactorisation()
  {
    Cholmod &c = *cholmod;
    for (cholmod_dense **dense : {&c.y, &c.x, &c.work})
      cholmod_free_dense(dense, &c.common);
    cholmod_free_factor(&c.symbolic, &c.common);
    cholmod_finish(&c.common);
  }


  int CondensedFactorisation::size() const
  {
    return cholmod->size();
  }


  double CondensedFactorisation::factor_memory() const
  {
    const cholmod_factor &l       = *cholmod->symbolic;
    const double          surface = static_cast<double>(cholmod->n_surface);
    // Numbers and their pattern, workspace, entries of the matrix in and out of order; the
    // surface's block of the factor, S and a copy of it.
    return sizeof(double) *
             (static_cast<double>(l.xsize) + static_cast<double>(l.maxcsize) +
              2. * static_cast<double>(cholmod->row.size()) + 3. * surface * surface) +
           sizeof(int) * (static_cast<double>(l.ssize) + static_cast<double>(cholmod->row.size()));
  }


  std::shared_ptr<CondensedFactorisation::Factor>
  CondensedFactorisation::factor(const std::vector<double> &values)
  {
    Cholmod       &c = *cholmod;
    cholmod_sparse a = c.matrix(const_cast<double *>(values.data()));
    auto result = std::make_shared<Factor>(cholmod_copy_factor(c.symbolic, &c.common), &c.common);
    const bool is_done = cholmod_factorize(&a, result->factor, &c.common) != 0;
    if (c.common.status == CHOLMOD_OUT_OF_MEMORY || c.common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
    if (!is_done || c.common.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD: the dynamic stiffness is not positive definite");

    separate_surface(*result);
    return result;
  }


  void CondensedFactorisation::separate_surface(Factor &factor) const
  {
    // L = [L_II 0; L_GI L_GG]: L_GG is copied out of the supernodes that reach into it. Supernodes
    // of the surface alone are left out of the triangular solves; of one with columns of both kinds
    // only those of the interior stay, the rows of the surface below them.
    const cholmod_factor &l     = *factor.factor;
    const int            *super = static_cast<const int *>(l.super);
    const int            *pi    = static_cast<const int *>(l.pi);
    const int            *px    = static_cast<const int *>(l.px);
    const int            *s     = static_cast<const int *>(l.s);
    const double         *x     = static_cast<const double *>(l.x);
    const int             first = cholmod->size() - cholmod->n_surface;
    factor.surface              = Eigen::MatrixXd::Zero(cholmod->n_surface, cholmod->n_surface);
    factor.interior             = l;
    for (int k = static_cast<int>(l.nsuper) - 1; k >= 0 && super[k + 1] > first; --k)
      {
        const int rows = pi[k + 1] - pi[k];
        for (int j = std::max(first, super[k]); j < super[k + 1]; ++j)
          for (int i = j - super[k]; i < rows; ++i)
            factor.surface(s[pi[k] + i] - first, j - first) = x[px[k] + (j - super[k]) * rows + i];
        if (super[k] >= first)
          factor.interior.nsuper = k;
      }
    factor.interior_super.assign(super, super + factor.interior.nsuper + 1);
    factor.interior_super.back() = std::min(first, factor.interior_super.back());
    factor.interior.super        = factor.interior_super.data();
    factor.interior.maxesize     = cholmod->rows_below();
  }


  Eigen::MatrixXd CondensedFactorisation::surface_matrix(const Factor &factor) const
  {
    const Eigen::MatrixXd s = factor.surface * factor.surface.transpose();
    return 0.5 * (s + s.transpose());
  }


  void
  CondensedFactorisation::forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g)
  {
    Cholmod   &c    = *cholmod;
    const int *perm = static_cast<const int *>(factor.factor->Perm);
    double    *y    = static_cast<double *>(c.y->x);
    for (int k = 0; k < c.size(); ++k)
      y[k] = b[perm[k]];
    cholmod_super_lsolve(&factor.interior, c.y, c.work, &c.common);
    g = c.surface_of(c.y);
  }


  void CondensedFactorisation::backward(Factor                &factor,
                                        const Eigen::VectorXd &surface,
                                        std::vector<double>   &x)
  {
    Cholmod &c = *cholmod;
    std::memcpy(c.x->x, c.y->x, sizeof(double) * c.size());
    c.surface_of(c.x) = surface;
    cholmod_super_ltsolve(&factor.interior, c.x, c.work, &c.common);
    const int    *perm     = static_cast<const int *>(factor.factor->Perm);
    const double *solution = static_cast<const double *>(c.x->x);
    for (int k = 0; k < c.size(); ++k)
      x[perm[k]] = solution[k];
  }


  void CondensedFactorisation::backward(Factor &factor, std::vector<double> &x)
  {
    cholmod->surface_load = cholmod->surface_of(cholmod->y);
    solve_surface(factor, cholmod->surface_load);
    backward(factor, cholmod->surface_load, x);
  }


  void CondensedFactorisation::solve_load_on_surface(Factor                &factor,
                                                     const Eigen::VectorXd &load,
                                                     std::vector<double>   &x)
  {
    cholmod->surface_load = load;
    solve_surface(factor, cholmod->surface_load);
    double *y = static_cast<double *>(cholmod->y->x);
    std::fill(y, y + cholmod->size(), 0.);
    backward(factor, cholmod->surface_load, x);
  }


  void CondensedFactorisation::solve(const Factor &factor, Eigen::MatrixXd &b)
  {
    Cholmod       &c    = *cholmod;
    const int     *perm = static_cast<const int *>(factor.factor->Perm);
    cholmod_dense *x    = cholmod_zeros(b.rows(), b.cols(), CHOLMOD_REAL, &c.common);
    cholmod_dense *work = cholmod_zeros(c.rows_below(), b.cols(), CHOLMOD_REAL, &c.common);
    Eigen::Map<Eigen::MatrixXd> in_order(static_cast<double *>(x->x), b.rows(), b.cols());
    for (int k = 0; k < c.size(); ++k)
      in_order.row(k) = b.row(perm[k]);
    cholmod_factor interior = factor.interior; // CHOLMOD takes no constant one
    cholmod_super_lsolve(&interior, x, work, &c.common);
    Eigen::MatrixXd surface = in_order.bottomRows(c.n_surface);
    solve_surface(factor, surface);
    in_order.bottomRows(c.n_surface) = surface;
    cholmod_super_ltsolve(&interior, x, work, &c.common);
    for (int k = 0; k < c.size(); ++k)
      b.row(perm[k]) = in_order.row(k);
    cholmod_free_dense(&x, &c.common);
    cholmod_free_dense(&work, &c.common);
  }


  template <typename Values>
  void CondensedFactorisation::solve_surface(const Factor &factor, Values &b)
  {
    factor.surface.triangularView<Eigen::Lower>().solveInPlace(b);
    factor.surface.transpose().triangularView<Eigen::Upper>().solveInPlace(b);
  }
} // namespace hybrid::continuum
