// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/joined_matrix.h>
#include <hybrid/dda/linear/shared_loop.h>

#include <algorithm>

namespace hybrid::dda
{
  JoinedMatrix::Place JoinedMatrix::place_of(const int node) const
  {
    return {n_blocks + node / nodes_per_block, 2 * (node % nodes_per_block)};
  }



  void JoinedMatrix::set_pattern(const BlockMatrix &matrix, const int reach)
  {
    n_blocks                               = matrix.n_blocks();
    n_nodes                                = matrix.n_nodes();
    const int                      n_added = JoinedMatrix::n_added(n_nodes);
    std::vector<BlockMatrix::Pair> pairs   = matrix.pairs;
    for (const auto &[block, node] : matrix.couplings)
      pairs.push_back({block, place_of(node).block});
    for (int a = 0; a < n_added; ++a)
      for (int b = a + 1; b <= std::min(n_added - 1, a + reach); ++b)
        pairs.push_back({n_blocks + a, n_blocks + b});
    joined.set_pattern(n_blocks + n_added, 0, std::move(pairs), {});
    of_pair.clear();
    for (const auto &[i, j] : matrix.pairs)
      of_pair.push_back(joined.block_slot(i, j));
    of_coupling.clear();
    for (const auto &[block, node] : matrix.couplings)
      of_coupling.push_back(joined.block_slot(block, place_of(node).block));
    reach_now = reach;
    version   = matrix.pattern_version();
  }



  void JoinedMatrix::add(const int              a,
                         const int              b,
                         const Eigen::Matrix2d &above,
                         const Eigen::Matrix2d &below)
  {
    const Place p = place_of(a), q = place_of(b);
    if (p.block == q.block)
      {
        joined.diagonal[p.block].block<2, 2>(p.first, q.first) += above;
        if (a != b)
          joined.diagonal[p.block].block<2, 2>(q.first, p.first) += below;
        return;
      }
    const int slot = joined.block_slot(p.block, q.block);
    joined.off_diagonal[slot].block<2, 2>(p.first, q.first) += above;
    joined.lower[slot].block<2, 2>(q.first, p.first) += below;
  }



  void JoinedMatrix::add_foundation(const InterfaceStiffness &foundation)
  {
    for (int a = 0; a < n_nodes; ++a)
      for (int b = a; b < n_nodes && place_of(b).block - place_of(a).block <= reach_now; ++b)
        {
          Eigen::Matrix2d part;
          for (int r = 0; r < 2; ++r)
            for (int c = 0; c < 2; ++c)
              part(r, c) = foundation.entry(2 * a + r, 2 * b + c);
          add(a, b, part, part.transpose());
        }
  }



  const BlockMatrix &JoinedMatrix::join(const BlockMatrix        &matrix,
                                        const InterfaceStiffness &foundation)
  {
    const int reach = foundation.near_width() / (2 * nodes_per_block) + 1;
    if (version != matrix.pattern_version() || n_blocks != matrix.n_blocks() ||
        n_nodes != matrix.n_nodes() || reach != reach_now)
      set_pattern(matrix, reach);
    std::copy(matrix.diagonal.begin(), matrix.diagonal.end(), joined.diagonal.begin());
    const int n = static_cast<int>(of_pair.size());
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int s = 0; s < n; ++s)
      {
        joined.off_diagonal[of_pair[s]] = matrix.off_diagonal[s];
        joined.lower[of_pair[s]]        = matrix.lower[s];
      }
    for (const int slot : of_coupling)
      {
        joined.off_diagonal[slot].setZero();
        joined.lower[slot].setZero();
      }
    for (int i = n_blocks; i < joined.n_blocks(); ++i)
      {
        joined.set_row_zero(i);
        joined.diagonal[i].setZero();
      }
    for (std::size_t s = 0; s < of_coupling.size(); ++s)
      {
        const int first = place_of(matrix.couplings[s][1]).first;
        joined.off_diagonal[of_coupling[s]].middleCols<2>(first) += matrix.block_node[s];
        joined.lower[of_coupling[s]].middleRows<2>(first) += matrix.node_block[s];
      }
    for (int k = 0; k < n_nodes; ++k)
      {
        add(k, k, matrix.node_diagonal[k], matrix.node_diagonal[k]);
        if (k + 1 < n_nodes)
          add(k, k + 1, matrix.node_next[k], matrix.node_previous[k]);
      }
    for (int rest = n_nodes; rest < nodes_per_block * n_added(n_nodes); ++rest)
      add(rest, rest, Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Identity());
    add_foundation(foundation);
    joined.symmetric = matrix.symmetric;
    return joined;
  }

} // namespace hybrid::dda
