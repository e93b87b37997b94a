// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_inverse.h>
#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <iterator>

extern "C"
{
  // BLAS: C = beta C + alpha A B.
  void dgemm_(const char   *trans_a,
              const char   *trans_b,
              const int    *m,
              const int    *n,
              const int    *k,
              const double *alpha,
              const double *a,
              const int    *lda,
              const double *b,
              const int    *ldb,
              const double *beta,
              double       *c,
              const int    *ldc);
  // BLAS: y = beta y + alpha A x.
  void dgemv_(const char   *trans,
              const int    *m,
              const int    *n,
              const double *alpha,
              const double *a,
              const int    *lda,
              const double *x,
              const int    *inc_x,
              const double *beta,
              double       *y,
              const int    *inc_y);
  // LAPACK: LU factors of a matrix, and its inverse from them.
  void dgetrf_(const int *m, const int *n, double *a, const int *lda, int *pivots, int *info);
  void dgetri_(const int *n,
               double    *a,
               const int *lda,
               const int *pivots,
               double    *work,
               const int *work_size,
               int       *info);
}

namespace hybrid::dda
{
  namespace
  {
    /// Of a block of the diagonal while others are eliminated; times the round-off it is the error
    /// of the factors (Wilkinson 1961).
    constexpr double max_front_growth = 1e4;

    /// Pairs that are analysed but zero cost fill-in: so many times as many as those that are not
    /// zero at most.
    constexpr double idle_fraction = 0.5;

    /// Columns of the work space of dgetri.
    constexpr int lapack_columns = 64;

    using Block = Eigen::Map<Mat6, 0, Eigen::OuterStride<>>;



    /// 6x6 block of a matrix by columns with @p rows rows.
    Block front_block(double *matrix, const int rows, const int i, const int j)
    {
      return Block(matrix + 6 * i + static_cast<std::ptrdiff_t>(6 * j) * rows,
                   Eigen::OuterStride<>(rows));
    }



    /// A factor times a matrix by columns times a vector.
    struct Product
    {
      double        factor;
      const double *matrix;
      const double *vector;
    };

    /// y = beta y + product; @p trans 'T': of the transpose.
    void add_product(const char     trans,
                     const int      rows,
                     const int      columns,
                     const Product &product,
                     const double   beta,
                     double        *y)
    {
      constexpr int one = 1;
      if (rows > 0 && columns > 0)
        dgemv_(&trans,
               &rows,
               &columns,
               &product.factor,
               product.matrix,
               &rows,
               product.vector,
               &one,
               &beta,
               y,
               &one);
    }



    std::vector<BlockMatrix::Pair> pairs_not_zero(const BlockMatrix &matrix)
    {
      std::vector<BlockMatrix::Pair> list;
      for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
        if (!matrix.is_zero(s))
          list.push_back(matrix.pairs[s]);
      return list;
    }
  } // namespace



  void FrontalLu::analyze(std::vector<BlockMatrix::Pair> now, const int n_blocks)
  {
    pairs = std::move(now);
    size  = n_blocks;
    tree  = FrontTree(n_blocks, pairs);
    ++analyses;

    const int n = tree.n_fronts();
    entry_begin.assign(n + 1, 0);
    const auto front_of = [&](const BlockMatrix::Pair &pair) {
      return tree.front[std::min(tree.place[pair[0]], tree.place[pair[1]])];
    };
    for (const auto &pair : pairs)
      ++entry_begin[front_of(pair) + 1];
    for (int f = 0; f < n; ++f)
      entry_begin[f + 1] += entry_begin[f];
    std::vector<int> at(entry_begin.begin(), entry_begin.end());
    entries.resize(pairs.size());
    for (std::size_t s = 0; s < pairs.size(); ++s)
      {
        const int f = front_of(pairs[s]), i = tree.place[pairs[s][0]], j = tree.place[pairs[s][1]];
        entries[at[f]++] = {static_cast<int>(s),
                            tree.position(f, std::min(i, j)),
                            tree.position(f, std::max(i, j)),
                            j < i};
      }

    diagonal.resize(n_blocks);
    upper.resize(pairs.size());
    lower.resize(pairs.size());
    front.resize(36 * static_cast<std::size_t>(tree.largest) * tree.largest);
    waiting.resize(36 * static_cast<std::size_t>(tree.waiting));
    pivots.resize(6 * tree.largest);
    lapack_work.resize(lapack_columns * 6 * tree.largest);
    ordered.resize(6 * n_blocks);
    gathered.resize(6 * tree.largest);
  }



  void FrontalLu::load(const BlockMatrix &matrix)
  {
    std::size_t present = 0;
    bool        covered = size == matrix.n_blocks();
    for (std::size_t s = 0, a = 0; s < matrix.pairs.size(); ++s)
      {
        if (matrix.is_zero(s))
          continue;
        ++present;
        while (a < pairs.size() && pairs[a] < matrix.pairs[s])
          ++a;
        covered = covered && a < pairs.size() && pairs[a] == matrix.pairs[s];
      }
    const auto too_many = [&](const std::size_t n) {
      return static_cast<double>(n) > (1. + idle_fraction) * static_cast<double>(present);
    };
    if (!covered || too_many(pairs.size()))
      {
        std::vector<BlockMatrix::Pair> now = pairs_not_zero(matrix), both;
        if (size == matrix.n_blocks())
          std::set_union(
            now.begin(), now.end(), pairs.begin(), pairs.end(), std::back_inserter(both));
        analyze(both.empty() || too_many(both.size()) ? std::move(now) : std::move(both),
                matrix.n_blocks());
      }

    std::copy(matrix.diagonal.begin(), matrix.diagonal.end(), diagonal.begin());
    for (std::size_t a = 0, s = 0; a < pairs.size(); ++a)
      {
        while (s < matrix.pairs.size() && matrix.pairs[s] < pairs[a])
          ++s;
        const bool there = s < matrix.pairs.size() && matrix.pairs[s] == pairs[a];
        upper[a]         = there ? matrix.off_diagonal[s] : Mat6::Zero();
        lower[a]         = there ? matrix.lower[s] : Mat6::Zero();
      }
  }



  void FrontalLu::place_factors()
  {
    factor_begin.assign(1, 0);
    for (int f = 0; f < tree.n_fronts(); ++f)
      {
        const std::size_t p = tree.own(f), u = tree.later(f);
        factor_begin.push_back(factor_begin.back() + 36 * p * (p + (symmetric ? 1 : 2) * u));
      }
    factors.resize(factor_begin.back());
  }



  bool FrontalLu::factorize(const BlockMatrix &matrix)
  {
    load(matrix);
    symmetric = matrix.symmetric;
    return eliminate();
  }



  void FrontalLu::fill(const int f)
  {
    const int rows = 6 * (tree.own(f) + tree.later(f));
    std::fill_n(front.begin(), static_cast<std::size_t>(rows) * rows, 0.);
    for (int k = 0; k < tree.own(f); ++k)
      front_block(front.data(), rows, k, k) = diagonal[tree.block[tree.begin[f] + k]];
    for (int e = entry_begin[f]; e < entry_begin[f + 1]; ++e)
      {
        const Entry &entry                                         = entries[e];
        const Mat6  &right                                         = upper[entry.pair];
        const Mat6  &below                                         = lower[entry.pair];
        front_block(front.data(), rows, entry.first, entry.second) = entry.turned ? below : right;
        front_block(front.data(), rows, entry.second, entry.first) = entry.turned ? right : below;
      }
  }



  void FrontalLu::add_child(const int child, const std::size_t top)
  {
    const int  f    = tree.parent[child];
    const int  rows = 6 * (tree.own(f) + tree.later(f)), n = tree.later(child);
    const int *place = tree.in_parent.data() + tree.later_begin[child];
    double    *left  = waiting.data() + top;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        front_block(front.data(), rows, place[i], place[j]) += front_block(left, 6 * n, i, j);
  }



  bool FrontalLu::grows(const int f) const
  {
    const int rows = 6 * (tree.own(f) + tree.later(f));
    for (int k = 0; k < tree.own(f); ++k)
      {
        const double start = diagonal[tree.block[tree.begin[f] + k]].cwiseAbs().maxCoeff();
        const double now =
          front_block(const_cast<double *>(front.data()), rows, k, k).cwiseAbs().maxCoeff();
        if (!(now <= max_front_growth * start))
          return true;
      }
    return false;
  }



  bool FrontalLu::invert_own(const int f, double *inverse)
  {
    const int p = tree.own(f), n = 6 * p, rows = 6 * (p + tree.later(f));
    if (p == 1)
      {
        Eigen::Map<Mat6> d(inverse);
        d = block_inverse(front_block(front.data(), rows, 0, 0));
        return d.allFinite();
      }
    for (int j = 0; j < n; ++j)
      std::copy_n(front.data() + static_cast<std::size_t>(j) * rows, n, inverse + j * n);
    int       info      = 0;
    const int work_size = lapack_columns * n;
    dgetrf_(&n, &n, inverse, &n, pivots.data(), &info);
    if (info == 0)
      dgetri_(&n, inverse, &n, pivots.data(), lapack_work.data(), &work_size, &info);
    return info == 0 && Eigen::Map<Eigen::MatrixXd>(inverse, n, n).allFinite();
  }



  bool FrontalLu::eliminate()
  {
    constexpr double one = 1., minus = -1., zero = 0.;
    std::size_t      top = 0;
    place_factors();
    std::vector<int> &stack = fronts_waiting;
    stack.clear();
    for (int f = 0; f < tree.n_fronts(); ++f)
      {
        fill(f);
        while (!stack.empty() && tree.parent[stack.back()] == f)
          {
            const std::size_t n = 6 * tree.later(stack.back());
            top -= n * n;
            add_child(stack.back(), top);
            stack.pop_back();
          }
        const int p = 6 * tree.own(f), u = 6 * tree.later(f), rows = p + u;
        double   *inverse = factors.data() + factor_begin[f];
        double   *below   = inverse + static_cast<std::size_t>(p) * p;
        double   *right   = below + static_cast<std::size_t>(p) * u;
        if (grows(f) || !invert_own(f, inverse))
          return false;
        if (u == 0)
          continue;
        const double *b = front.data() + static_cast<std::size_t>(p) * rows;
        double       *e = front.data() + static_cast<std::size_t>(p) * rows + p;
        dgemm_("N", "N", &u, &p, &p, &one, front.data() + p, &rows, inverse, &p, &zero, below, &u);
        dgemm_("N", "N", &u, &u, &p, &minus, below, &u, b, &rows, &one, e, &rows);
        for (int j = 0; j < u && !symmetric; ++j)
          std::copy_n(b + static_cast<std::size_t>(j) * rows,
                      p,
                      right + static_cast<std::size_t>(j) * p);
        if (tree.parent[f] < 0)
          continue;
        for (int j = 0; j < u; ++j)
          std::copy_n(e + static_cast<std::size_t>(j) * rows,
                      u,
                      waiting.data() + top + static_cast<std::size_t>(j) * u);
        top += static_cast<std::size_t>(u) * u;
        stack.push_back(f);
      }
    return true;
  }



  void FrontalLu::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    for (int p = 0; p < size; ++p)
      ordered.segment<6>(6 * p) = b.segment<6>(6 * tree.block[p]);
    for (int f = 0; f < tree.n_fronts(); ++f)
      solve_forward(f);
    for (int f = tree.n_fronts() - 1; f >= 0; --f)
      solve_backward(f);
    for (int p = 0; p < size; ++p)
      x.segment<6>(6 * tree.block[p]) = ordered.segment<6>(6 * p);
  }



  void FrontalLu::solve_forward(const int f)
  {
    const int     p = 6 * tree.own(f), u = 6 * tree.later(f);
    const double *below = factors.data() + factor_begin[f] + static_cast<std::size_t>(p) * p;
    add_product('N', u, p, {1., below, ordered.data() + 6 * tree.begin[f]}, 0., gathered.data());
    const int *place = tree.later_places.data() + tree.later_begin[f];
    for (int k = 0; k < u / 6; ++k)
      ordered.segment<6>(6 * place[k]) -= gathered.segment<6>(6 * k);
  }



  void FrontalLu::solve_backward(const int f)
  {
    const int     p = 6 * tree.own(f), u = 6 * tree.later(f);
    const double *inverse = factors.data() + factor_begin[f];
    const double *below   = inverse + static_cast<std::size_t>(p) * p;
    const double *right   = below + static_cast<std::size_t>(p) * u;
    const int    *place   = tree.later_places.data() + tree.later_begin[f];
    double       *here    = ordered.data() + 6 * tree.begin[f];
    for (int k = 0; k < u / 6; ++k)
      gathered.segment<6>(p + 6 * k) = ordered.segment<6>(6 * place[k]);
    std::copy_n(here, p, gathered.data());
    if (!symmetric)
      add_product('N', p, u, {-1., right, gathered.data() + p}, 1., gathered.data());
    add_product('N', p, p, {1., inverse, gathered.data()}, 0., here);
    if (symmetric) // D^-1 B is the transpose of C D^-1
      add_product('T', u, p, {-1., below, gathered.data() + p}, 1., here);
  }



  void FrontalLu::serialize(restart::Archive &archive, bool is_used)
  {
    std::vector<BlockMatrix::Pair> stored = pairs;
    int                            blocks = size;
    archive(blocks, stored, symmetric);
    if (archive.is_reading() && blocks > 0)
      analyze(stored, blocks);
    std::vector<Mat6> none;
    archive(is_used ? diagonal : none, is_used ? upper : none, is_used ? lower : none);
    if (archive.is_reading() && is_used)
      eliminate();
  }
} // namespace hybrid::dda
