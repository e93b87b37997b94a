// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <umfpack.h>
#include <vector>

namespace hybrid::dda
{
  namespace
  {
    /// Products of 6x6 blocks per block up to which BlockLu serves: beyond, dense fronts are
    /// faster.
    constexpr long few_products = 40;

    /// One 6x6 block of a block column.
    struct Entry
    {
      int row;  ///< block row
      int slot; ///< in off_diagonal; bit-complement: in lower; the diagonal's is its number

      bool operator<(const Entry &other) const
      {
        return row < other.row;
      }
    };

    using Columns = std::vector<std::vector<Entry>>;



    /// Blocks of each block column, rows increasing; the diagonal block is the one with row =
    /// column.
    Columns block_columns(const BlockMatrix &matrix)
    {
      Columns columns(matrix.n_blocks());
      for (int b = 0; b < matrix.n_blocks(); ++b)
        columns[b].push_back({b, b});
      for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
        {
          const int i = matrix.pairs[s][0], j = matrix.pairs[s][1];
          columns[j].push_back({i, static_cast<int>(s)});
          columns[i].push_back({j, ~static_cast<int>(s)});
        }
      for (auto &column : columns)
        std::sort(column.begin(), column.end());
      return columns;
    }



    const Mat6 &block_of(const BlockMatrix &matrix, const int column, const Entry &entry)
    {
      if (entry.row == column)
        return matrix.diagonal[column];
      return entry.slot >= 0 ? matrix.off_diagonal[entry.slot] : matrix.lower[~entry.slot];
    }



    /// A compressed-column copy of the blocks' part of a matrix.
    struct CompressedColumns
    {
      Columns             columns;
      std::vector<int>    start, rows;
      std::vector<double> values;

      void set_pattern(const BlockMatrix &matrix)
      {
        columns = block_columns(matrix);
        start.assign(1, 0);
        rows.clear();
        for (int j = 0; j < matrix.n_blocks(); ++j)
          for (int c = 0; c < 6; ++c)
            {
              for (const Entry &entry : columns[j])
                for (int r = 0; r < 6; ++r)
                  rows.push_back(6 * entry.row + r);
              start.push_back(static_cast<int>(rows.size()));
            }
        values.resize(rows.size());
      }

      /// For the checkpoint.
      void serialize(restart::Archive &archive)
      {
        archive(start, rows, values);
      }

      void set_values(const BlockMatrix &matrix)
      {
        std::size_t at = 0;
        for (int j = 0; j < matrix.n_blocks(); ++j)
          for (int c = 0; c < 6; ++c)
            for (const Entry &entry : columns[j])
              {
                const Mat6 &block = block_of(matrix, j, entry);
                for (int r = 0; r < 6; ++r)
                  values[at++] = block(r, c);
              }
      }
    };
  } // namespace



  struct SparseFactor::Lu
  {
    CompressedColumns   matrix;
    std::vector<double> analyzed; ///< values that the analysis has seen
    void               *symbolic        = nullptr;
    void               *numeric         = nullptr;
    int                 pattern_version = -1;
    double              control[UMFPACK_CONTROL];
    std::vector<int>    int_work;
    std::vector<double> work;

    Lu()
    {
      umfpack_di_defaults(control);
      control[UMFPACK_IRSTEP] = 0; // the iteration around it refines
    }

    ~Lu()
    {
      umfpack_di_free_symbolic(&symbolic);
      umfpack_di_free_numeric(&numeric);
    }

    bool factorize(const BlockMatrix &source)
    {
      const std::size_t n = 6 * static_cast<std::size_t>(source.n_blocks());
      if (pattern_version != source.pattern_version())
        {
          matrix.set_pattern(source);
          umfpack_di_free_symbolic(&symbolic);
          pattern_version = source.pattern_version();
          int_work.resize(n);
          work.resize(n);
        }
      matrix.set_values(source);
      if (symbolic == nullptr)
        analyzed = matrix.values;
      return (symbolic != nullptr || analyze()) && factorize();
    }

    bool analyze()
    {
      const int n = static_cast<int>(matrix.start.size()) - 1;
      return umfpack_di_symbolic(n,
                                 n,
                                 matrix.start.data(),
                                 matrix.rows.data(),
                                 analyzed.data(),
                                 &symbolic,
                                 control,
                                 nullptr) == UMFPACK_OK;
    }

    bool factorize()
    {
      umfpack_di_free_numeric(&numeric);
      return umfpack_di_numeric(matrix.start.data(),
                                matrix.rows.data(),
                                matrix.values.data(),
                                symbolic,
                                &numeric,
                                control,
                                nullptr) == UMFPACK_OK;
    }

    /// The analysis depends on the values with which it was made, and stays with the pattern: a
    /// later factor needs it even while another factor serves. @param is_used this factor
    /// serves.
    void serialize(restart::Archive &archive, const BlockMatrix &source, const bool is_used)
    {
      bool keeps_pattern = pattern_version == source.pattern_version() && symbolic != nullptr;
      bool is_kept       = is_used || keeps_pattern;
      archive(keeps_pattern, is_kept);
      CompressedColumns   none;
      std::vector<double> no_values;
      archive(is_kept ? matrix : none, is_kept ? analyzed : no_values);
      if (!archive.is_reading() || !is_kept)
        return;
      if (keeps_pattern)
        {
          const CompressedColumns stored = matrix;
          matrix.set_pattern(source);
          matrix.values   = stored.values;
          pattern_version = source.pattern_version();
        }
      int_work.resize(matrix.start.size() - 1);
      work.resize(matrix.start.size() - 1);
      umfpack_di_free_symbolic(&symbolic);
      if (analyze() && is_used)
        factorize();
    }

    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &result)
    {
      umfpack_di_wsolve(UMFPACK_A,
                        matrix.start.data(),
                        matrix.rows.data(),
                        matrix.values.data(),
                        result.data(),
                        b.data(),
                        numeric,
                        control,
                        nullptr,
                        int_work.data(),
                        work.data());
    }
  };



  SparseFactor::SparseFactor()
    : lu(std::make_unique<Lu>())
  {}



  SparseFactor::~SparseFactor() = default;



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
    else if (foundation != nullptr && frontal.factorize(joined.join(matrix, *foundation)))
      {
        kind    = Kind::frontal;
        n_added = JoinedMatrix::n_added(matrix.n_nodes());
      }
    else if (frontal.factorize(matrix))
      kind = Kind::frontal;
    else if (lu->factorize(matrix))
      kind = Kind::lu;
    else
      return false;
    if (kind != Kind::frontal)
      frontal.forget();
    if (matrix.n_blocks() >= many_blocks)
      joined = {};
    size = 6 * matrix.n_blocks();
    make_room();
    return true;
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
    if (size > 0 && kind == Kind::lu) // UMFPACK exchanges rows
      return {3. * tree.entries, 3. * tree.products, static_cast<double>(tree.n_fronts())};
    return {tree.entries, last.products, last.fronts};
  }



  void SparseFactor::serialize(restart::Archive &archive, const BlockMatrix &matrix)
  {
    archive(size, n_added, kind, symmetric, block_lu_products);
    lu->serialize(archive, matrix, size > 0 && kind == Kind::lu);
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
        case Kind::lu:
          lu->solve(b, x);
          break;
        case Kind::block_lu:
          block_lu.solve(b, x);
          break;
      }
  }
} // namespace hybrid::dda
