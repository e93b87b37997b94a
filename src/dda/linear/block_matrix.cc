// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    /// Where the pairs of each row begin if they are listed row by row; @p end: the one that is the
    /// row.
    std::vector<int>
    row_starts(const std::vector<BlockMatrix::Pair> &pairs, const int n_rows, const int end = 0)
    {
      std::vector<int> begin(n_rows + 1, 0);
      for (const auto &pair : pairs)
        ++begin[pair[end] + 1];
      std::partial_sum(begin.begin(), begin.end(), begin.begin());
      return begin;
    }



    /// By rows first: they are short.
    void sort_unique(std::vector<BlockMatrix::Pair> &pairs, const int n_rows)
    {
      const std::vector<int>         begin = row_starts(pairs, n_rows);
      std::vector<int>               next(begin.begin(), begin.end() - 1);
      std::vector<BlockMatrix::Pair> sorted(pairs.size());
      for (const auto &pair : pairs)
        sorted[next[pair[0]]++] = pair;
      for (int i = 0; i < n_rows; ++i)
        std::sort(sorted.begin() + begin[i], sorted.begin() + begin[i + 1]);
      sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
      pairs = std::move(sorted);
    }



    int find(const std::vector<BlockMatrix::Pair> &sorted,
             const std::vector<int>               &begin,
             const BlockMatrix::Pair              &pair)
    {
      const auto first = sorted.begin() + begin[pair[0]],
                 last  = sorted.begin() + begin[pair[0] + 1];
      const auto found = std::lower_bound(first, last, pair);
      return found != last && *found == pair ? static_cast<int>(found - sorted.begin()) : -1;
    }
  } // namespace



  void BlockMatrix::set_pattern(const int         n_blocks,
                                const int         n_nodes,
                                std::vector<Pair> block_pairs,
                                std::vector<Pair> node_pairs)
  {
    for (auto &pair : block_pairs)
      if (pair[0] > pair[1])
        std::swap(pair[0], pair[1]);
    sort_unique(block_pairs, n_blocks);
    sort_unique(node_pairs, n_blocks);
    pairs     = std::move(block_pairs);
    couplings = std::move(node_pairs);

    pair_begin     = row_starts(pairs, n_blocks);
    coupling_begin = row_starts(couplings, n_blocks);

    // Pairs come in order of their rows, so the others of each row do: those before it, then those
    // after it.
    const std::vector<int> before = row_starts(pairs, n_blocks, 1);
    row_begin.resize(n_blocks + 1);
    for (int i = 0; i <= n_blocks; ++i)
      row_begin[i] = pair_begin[i] + before[i];
    row_other.resize(2 * pairs.size());
    row_slot.resize(2 * pairs.size());
    std::vector<int> next(row_begin.begin(), row_begin.end() - 1);
    const auto       add = [&](const int row, const int other, const int slot) {
      row_other[next[row]]  = other;
      row_slot[next[row]++] = slot;
    };
    for (std::size_t s = 0; s < pairs.size(); ++s)
      add(pairs[s][1], pairs[s][0], ~static_cast<int>(s));
    for (std::size_t s = 0; s < pairs.size(); ++s)
      add(pairs[s][0], pairs[s][1], static_cast<int>(s));

    node_begin = row_starts(couplings, n_nodes, 1);
    node_coupling.resize(couplings.size());
    next.assign(node_begin.begin(), node_begin.end() - 1);
    for (std::size_t s = 0; s < couplings.size(); ++s)
      node_coupling[next[couplings[s][1]]++] = static_cast<int>(s);

    diagonal.resize(n_blocks);
    off_diagonal.resize(pairs.size());
    lower.resize(pairs.size());
    block_node.resize(couplings.size());
    node_block.resize(couplings.size());
    node_diagonal.resize(n_nodes);
    node_next.resize(n_nodes);
    node_previous.resize(n_nodes);
    set_zero();
    ++version;
  }



  void BlockMatrix::set_zero()
  {
    std::fill(diagonal.begin(), diagonal.end(), Mat6::Zero());
    std::fill(off_diagonal.begin(), off_diagonal.end(), Mat6::Zero());
    std::fill(lower.begin(), lower.end(), Mat6::Zero());
    set_nodes_zero();
  }



  void BlockMatrix::set_row_zero(const int i)
  {
    diagonal[i].setZero();
    for (int k = row_begin[i]; k < row_begin[i + 1]; ++k)
      (row_slot[k] >= 0 ? off_diagonal[row_slot[k]] : lower[~row_slot[k]]).setZero();
  }



  void BlockMatrix::set_nodes_zero()
  {
    std::fill(block_node.begin(), block_node.end(), Mat62::Zero());
    std::fill(node_block.begin(), node_block.end(), Mat26::Zero());
    std::fill(node_diagonal.begin(), node_diagonal.end(), Eigen::Matrix2d::Zero());
    std::fill(node_next.begin(), node_next.end(), Eigen::Matrix2d::Zero());
    std::fill(node_previous.begin(), node_previous.end(), Eigen::Matrix2d::Zero());
    symmetric = true;
  }



  int BlockMatrix::block_slot(const int i, const int j) const
  {
    return find(pairs, pair_begin, {i, j});
  }



  int BlockMatrix::node_slot(const int block, const int node) const
  {
    return find(couplings, coupling_begin, {block, node});
  }



  Vec6 BlockMatrix::row_of_nodes(const int i, const Eigen::VectorXd &x) const
  {
    const double *nodes = x.data() + 6 * n_blocks();
    Vec6          sum   = Vec6::Zero();
    for (int s = coupling_begin[i]; s < coupling_begin[i + 1]; ++s)
      sum.noalias() +=
        block_node[s] * Eigen::Map<const Eigen::Vector2d>(nodes + 2 * couplings[s][1]);
    return sum;
  }



  void BlockMatrix::multiply_nodes(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int     m   = n_nodes();
    const double *in  = x.data() + 6 * n_blocks();
    double       *out = y.data() + 6 * n_blocks();
    for (int k = 0; k < m; ++k)
      {
        Eigen::Vector2d sum = node_diagonal[k] * Eigen::Map<const Eigen::Vector2d>(in + 2 * k);
        if (k + 1 < m)
          sum.noalias() += node_next[k] * Eigen::Map<const Eigen::Vector2d>(in + 2 * k + 2);
        if (k > 0)
          sum.noalias() += node_previous[k - 1] * Eigen::Map<const Eigen::Vector2d>(in + 2 * k - 2);
        Eigen::Map<Eigen::Vector2d>(out + 2 * k) = sum;
      }
  }



  void BlockMatrix::add_blocks_to_nodes(const Eigen::VectorXd &x,
                                        Eigen::VectorXd       &y,
                                        const double           sign) const
  {
    double *nodes = y.data() + 6 * n_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n_nodes()))
    for (int k = 0; k < n_nodes(); ++k)
      for (int e = node_begin[k]; e < node_begin[k + 1]; ++e)
        {
          const int s = node_coupling[e];
          Eigen::Map<Eigen::Vector2d>(nodes + 2 * k).noalias() +=
            sign * node_block[s] * Eigen::Map<const Vec6>(x.data() + 6 * couplings[s][0]);
        }
  }



  void BlockMatrix::multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y) const
  {
    const int n = n_blocks();

#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int i = 0; i < n; ++i)
      {
        Vec6 sum = diagonal[i] * Eigen::Map<const Vec6>(x.data() + 6 * i) + row_of_nodes(i, x);
        for (int k = row_begin[i]; k < row_begin[i + 1]; ++k)
          {
            const int   slot  = row_slot[k];
            const Mat6 &entry = slot >= 0 ? off_diagonal[slot] : lower[~slot];
            sum.noalias() += entry * Eigen::Map<const Vec6>(x.data() + 6 * row_other[k]);
          }
        Eigen::Map<Vec6>(y.data() + 6 * i) = sum;
      }

    multiply_nodes(x, y);
    add_blocks_to_nodes(x, y);
  }



  void BlockMatrix::set_part(const BlockMatrix      &whole,
                             const std::vector<int> &blocks,
                             const std::vector<int> &nodes)
  {
    std::vector<int>  block_place(whole.n_blocks(), -1), node_place(whole.n_nodes(), -1);
    std::vector<int>  slots, node_slots;
    std::vector<Pair> block_pairs, node_pairs;
    for (std::size_t k = 0; k < blocks.size(); ++k)
      block_place[blocks[k]] = static_cast<int>(k);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      node_place[nodes[k]] = static_cast<int>(k);
    // Ascending as in the whole: the slots of the part come in the same order.
    for (const int b : blocks)
      {
        for (int s = whole.pair_begin[b]; s < whole.pair_begin[b + 1]; ++s)
          if (block_place[whole.pairs[s][1]] >= 0)
            {
              block_pairs.push_back({block_place[b], block_place[whole.pairs[s][1]]});
              slots.push_back(s);
            }
        for (int s = whole.coupling_begin[b]; s < whole.coupling_begin[b + 1]; ++s)
          if (node_place[whole.couplings[s][1]] >= 0)
            {
              node_pairs.push_back({block_place[b], node_place[whole.couplings[s][1]]});
              node_slots.push_back(s);
            }
      }
    set_pattern(static_cast<int>(blocks.size()),
                static_cast<int>(nodes.size()),
                std::move(block_pairs),
                std::move(node_pairs));
    for (std::size_t k = 0; k < blocks.size(); ++k)
      diagonal[k] = whole.diagonal[blocks[k]];
    for (std::size_t s = 0; s < slots.size(); ++s)
      {
        off_diagonal[s] = whole.off_diagonal[slots[s]];
        lower[s]        = whole.lower[slots[s]];
      }
    for (std::size_t s = 0; s < node_slots.size(); ++s)
      {
        block_node[s] = whole.block_node[node_slots[s]];
        node_block[s] = whole.node_block[node_slots[s]];
      }
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        node_diagonal[k] = whole.node_diagonal[nodes[k]];
        if (k + 1 == nodes.size() || nodes[k + 1] != nodes[k] + 1)
          continue;
        node_next[k]     = whole.node_next[nodes[k]];
        node_previous[k] = whole.node_previous[nodes[k]];
      }
    symmetric = whole.symmetric;
  }



  void BlockMatrix::serialize(restart::Archive &archive)
  {
    int blocks = n_blocks(), nodes = n_nodes();
    archive(blocks, nodes, pairs, couplings);
    if (archive.is_reading())
      set_pattern(blocks, nodes, pairs, couplings);
    archive(diagonal, off_diagonal, lower, block_node, node_block);
    archive(node_diagonal, node_next, node_previous, symmetric);
  }
} // namespace hybrid::dda
