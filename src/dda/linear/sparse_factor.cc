// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/restart/archive.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Products of 6x6 blocks per block up to which BlockLu serves: beyond, dense fronts are
    /// faster.
    constexpr long few_products = 40;
  } // namespace



  bool SparseFactor::factorize(const BlockMatrix &matrix, const InterfaceStiffness *foundation)
  {
    size              = 0;
    n_added           = 0;
    symmetric         = matrix.symmetric;
    const long most   = few_products * matrix.n_blocks();
    const long n      = symmetric ? 0 : block_lu.analyze(matrix, most);
    block_lu_products = static_cast<double>(n);
    if (!symmetric && n <= most && block_lu.factorize(matrix))
      kind = Kind::block_lu;
    else if (foundation != nullptr && factorize_joined(matrix, *foundation))
      {
        kind    = Kind::frontal;
        n_added = JoinedMatrix::n_added(matrix.n_nodes());
      }
    else if (frontal.factorize(matrix))
      kind = Kind::frontal;
    else
      return false;
    if (kind != Kind::frontal)
      frontal.forget();
    size = 6 * matrix.n_blocks();
    make_room();
    return true;
  }



  bool SparseFactor::factorize_joined(const BlockMatrix        &matrix,
                                      const InterfaceStiffness &foundation)
  {
    const bool is_large = matrix.n_blocks() >= many_blocks;
    if (is_large)
      frontal.give_back_work();
    frontal.load(joined.join(matrix, foundation));
    if (is_large)
      joined = {};
    return frontal.factorize_loaded();
  }



  SparseFactor::Counts SparseFactor::counts(const int n_blocks) const
  {
    const double           n    = n_blocks;
    const FrontTree       &tree = frontal.fronts();
    const FrontalLu::Cost &last = frontal.last_cost();
    if (size > 0 && kind == Kind::block_lu)
      return {block_lu.n_entries(), block_lu_products, 0.02 * n};
    if (tree.n_blocks() != n_blocks + n_added)
      return {2. * n * std::log2(n + 1.), 6. * n * std::sqrt(n), 0.6 * n};
    return {tree.entries, last.products, last.fronts};
  }



  void SparseFactor::serialize(restart::Archive &archive)
  {
    archive(size, n_added, kind, symmetric, block_lu_products);
    frontal.serialize(archive, size > 0 && kind == Kind::frontal);
    BlockLu none;
    archive(size > 0 && kind == Kind::block_lu ? block_lu : none);
    if (archive.is_reading())
      make_room();
  }



  void SparseFactor::make_room()
  {
    padded.setZero(n_added > 0 ? size + 6 * n_added : 0);
  }



  bool SparseFactor::ready(const int n_blocks) const
  {
    return size > 0 && size == 6 * n_blocks;
  }



  void SparseFactor::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
  {
    switch (kind)
      {
        case Kind::frontal:
          if (n_added == 0)
            frontal.solve(b, x);
          else
            {
              padded.head(b.size()) = b;
              frontal.solve(padded, padded);
              x = padded.head(b.size());
            }
          break;
        case Kind::block_lu:
          block_lu.solve(b, x);
          break;
      }
  }
} // namespace hybrid::dda
