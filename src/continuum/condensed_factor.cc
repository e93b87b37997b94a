// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/condensed_factor.h>
#include <hybrid/continuum/substitution.h>

#include <algorithm>
#include <cholmod.h>
#include <new>
#include <stdexcept>

namespace hybrid::continuum
{
  struct CondensedFactorisation::Parts final : Factor
  {
    std::vector<double> interior; ///< L_II and L_GI in the order of substitutions
    Eigen::MatrixXd     surface;  ///< L_GG, lower triangle

    static Parts &of(Factor &factor)
    {
      return static_cast<Parts &>(factor);
    }

    static const Parts &of(const Factor &factor)
    {
      return static_cast<const Parts &>(factor);
    }
  };


  struct CondensedFactorisation::Cholmod
  {
    cholmod_common                          common;
    std::vector<int>                        column_start, row;
    int                                     n_surface = 0;
    cholmod_factor                         *symbolic  = nullptr;
    Eigen::VectorXd                         surface_load; ///< becomes the solution there
    std::unique_ptr<const SubstitutionPlan> plan;
    std::unique_ptr<Substitution>           substitution;

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

    /// b := A^-1 b.
    void solve(cholmod_factor &factor, Eigen::MatrixXd &b);

    SupernodalPattern pattern() const;
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


  void CondensedFactorisation::Cholmod::solve(cholmod_factor &factor, Eigen::MatrixXd &b)
  {
    cholmod_dense right = {};
    right.nrow          = b.rows();
    right.ncol          = b.cols();
    right.nzmax         = b.size();
    right.d             = b.rows();
    right.x             = b.data();
    right.xtype         = CHOLMOD_REAL;
    right.dtype         = CHOLMOD_DOUBLE;
    cholmod_dense *x    = cholmod_solve(CHOLMOD_A, &factor, &right, &common);
    if (x == nullptr)
      throw std::bad_alloc(); // the factor is whole: nothing else can fail
    b = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double *>(x->x), b.rows(), b.cols());
    cholmod_free_dense(&x, &common);
  }


  SupernodalPattern CondensedFactorisation::Cholmod::pattern() const
  {
    SupernodalPattern l;
    l.n_interior   = size() - n_surface;
    l.n_surface    = n_surface;
    l.first_column = static_cast<const int *>(symbolic->super);
    l.row_begin    = static_cast<const int *>(symbolic->pi);
    l.row          = static_cast<const int *>(symbolic->s);
    l.value_begin  = static_cast<const int *>(symbolic->px);
    l.permutation  = static_cast<const int *>(symbolic->Perm);
    l.n_supernodes = static_cast<int>(
      std::lower_bound(l.first_column, l.first_column + symbolic->nsuper, l.n_interior) -
      l.first_column);
    return l;
  }


  CondensedFactorisation::CondensedFactorisation(std::vector<int> column_start,
                                                 std::vector<int> row,
                                                 const int        n_surface)
    : cholmod(std::make_unique<Cholmod>())
  {
    Eigen::setNbThreads(1); // Eigen cuts large products by the number of threads: so would the bits
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
    c.plan         = std::make_unique<SubstitutionPlan>(c.pattern());
    c.substitution = std::make_unique<Substitution>(*c.plan);
  }


  CondensedFactorisation::~CondensedFactorisation()
  {
    Cholmod &c = *cholmod;
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
    // Numbers and their pattern, workspace, entries of the matrix in and out of order; numbers in
    // the order of substitutions; the surface's block of the factor, S and a copy of it.
    return sizeof(double) *
             (static_cast<double>(l.xsize) + static_cast<double>(l.maxcsize) +
              static_cast<double>(cholmod->plan->n_values) +
              2. * static_cast<double>(cholmod->row.size()) + 3. * surface * surface) +
           sizeof(int) * (static_cast<double>(l.ssize) + static_cast<double>(cholmod->row.size()));
  }


  std::shared_ptr<Condensation::Factor>
  CondensedFactorisation::factor(const std::vector<double>                    &values,
                                 const std::function<void(const SolveMany &)> &use)
  {
    Cholmod        &c       = *cholmod;
    cholmod_sparse  a       = c.matrix(const_cast<double *>(values.data()));
    cholmod_factor *whole   = cholmod_copy_factor(c.symbolic, &c.common);
    const bool      is_done = cholmod_factorize(&a, whole, &c.common) != 0;
    const int       status  = c.common.status;
    auto            result  = std::make_shared<Parts>();
    if (is_done && status == CHOLMOD_OK)
      {
        take_parts(static_cast<const double *>(whole->x), *result);
        if (use != nullptr)
          use([&](Eigen::MatrixXd &b) { c.solve(*whole, b); });
      }
    cholmod_free_factor(&whole, &c.common);
    if (status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
    if (!is_done || status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD: the dynamic stiffness is not positive definite");
    return result;
  }


  void CondensedFactorisation::take_parts(const double *values, Parts &parts) const
  {
    // L = [L_II 0; L_GI L_GG]: L_GG is copied out of the supernodes that reach into it. Of one with
    // columns of both kinds those of the interior are L_II's and L_GI's.
    const SupernodalPattern pattern = cholmod->pattern();
    const int              *super = pattern.first_column, *pi = pattern.row_begin;
    const int               first = pattern.n_interior;
    parts.interior                = cholmod->plan->pack(pattern, values);
    parts.surface                 = Eigen::MatrixXd::Zero(cholmod->n_surface, cholmod->n_surface);
    for (int k = static_cast<int>(cholmod->symbolic->nsuper) - 1; k >= 0 && super[k + 1] > first;
         --k)
      {
        const int rows = pi[k + 1] - pi[k];
        for (int j = std::max(first, super[k]); j < super[k + 1]; ++j)
          for (int i = j - super[k]; i < rows; ++i)
            parts.surface(pattern.row[pi[k] + i] - first, j - first) =
              values[pattern.value_begin[k] + (j - super[k]) * rows + i];
      }
  }


  SurfaceStiffness CondensedFactorisation::surface_stiffness(const Factor &factor) const
  {
    const Eigen::MatrixXd &l = Parts::of(factor).surface;
    const Eigen::MatrixXd  s = l * l.transpose();
    return {0.5 * (s + s.transpose()), false};
  }


  void
  CondensedFactorisation::forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g)
  {
    cholmod->substitution->forward(Parts::of(factor).interior.data(), b.data(), g);
  }


  void CondensedFactorisation::backward(Factor                &factor,
                                        const Eigen::VectorXd &surface,
                                        std::vector<double>   &x)
  {
    cholmod->substitution->backward(Parts::of(factor).interior.data(), surface, x.data());
  }


  void CondensedFactorisation::backward(Factor &factor, std::vector<double> &x)
  {
    cholmod->surface_load = cholmod->substitution->surface_load();
    solve_surface(Parts::of(factor), cholmod->surface_load);
    backward(factor, cholmod->surface_load, x);
  }


  void CondensedFactorisation::solve_load_on_surface(Factor                &factor,
                                                     const Eigen::VectorXd &load,
                                                     std::vector<double>   &x)
  {
    cholmod->surface_load = load;
    solve_surface(Parts::of(factor), cholmod->surface_load);
    cholmod->substitution->backward_from_surface(Parts::of(factor).interior.data(),
                                                 cholmod->surface_load,
                                                 x.data());
  }


  void CondensedFactorisation::solve(const Factor &factor, Eigen::MatrixXd &b)
  {
    Substitution    substitution(*cholmod->plan);
    Eigen::VectorXd surface;
    for (Eigen::Index k = 0; k < b.cols(); ++k)
      {
        substitution.forward(Parts::of(factor).interior.data(), b.col(k).data(), surface);
        solve_surface(Parts::of(factor), surface);
        substitution.backward(Parts::of(factor).interior.data(), surface, b.col(k).data());
      }
  }


  template <typename Values>
  void CondensedFactorisation::solve_surface(const Parts &parts, Values &b)
  {
    parts.surface.triangularView<Eigen::Lower>().solveInPlace(b);
    parts.surface.transpose().triangularView<Eigen::Upper>().solveInPlace(b);
  }
} // namespace hybrid::continuum
