// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>

#include <cstdlib>
#include <vector>

namespace hybrid::test
{
  /// The whole matrix, base nodes after the blocks.
  inline Eigen::MatrixXd dense(const dda::BlockMatrix &m)
  {
    const int       n    = m.n_blocks();
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(m.size(), m.size());
    const auto      add  = [&](const int row, const int column, const Eigen::MatrixXd &part) {
      full.block(row, column, part.rows(), part.cols()) += part;
    };
    for (int i = 0; i < n; ++i)
      add(6 * i, 6 * i, m.diagonal[i]);
    for (std::size_t s = 0; s < m.pairs.size(); ++s)
      {
        add(6 * m.pairs[s][0], 6 * m.pairs[s][1], m.off_diagonal[s]);
        add(6 * m.pairs[s][1], 6 * m.pairs[s][0], m.lower[s]);
      }
    for (std::size_t s = 0; s < m.couplings.size(); ++s)
      {
        add(6 * m.couplings[s][0], 6 * n + 2 * m.couplings[s][1], m.block_node[s]);
        add(6 * n + 2 * m.couplings[s][1], 6 * m.couplings[s][0], m.node_block[s]);
      }
    for (int k = 0; k < m.n_nodes(); ++k)
      {
        add(6 * n + 2 * k, 6 * n + 2 * k, m.node_diagonal[k]);
        if (k + 1 < m.n_nodes())
          {
            add(6 * n + 2 * k, 6 * n + 2 * k + 2, m.node_next[k]);
            add(6 * n + 2 * k + 2, 6 * n + 2 * k, m.node_previous[k]);
          }
      }
    return full;
  }



  /// Positive definite: random springs between blocks i, i + 1, i + 3 (or other @p distances) and
  /// nodes, on a random mass.
  inline dda::BlockMatrix random_block_matrix(const int               n_blocks,
                                              const int               n_nodes,
                                              const std::vector<int> &distances = {1, 3})
  {
    using namespace dda;
    std::srand(1);
    std::vector<BlockMatrix::Pair> pairs, couplings;
    for (int i = 0; i < n_blocks; ++i)
      {
        for (const int distance : distances)
          if (i + distance < n_blocks)
            pairs.push_back({i, i + distance});
        if (n_nodes > 1)
          for (const int k : {i % (n_nodes - 1), i % (n_nodes - 1) + 1})
            couplings.push_back({i, k});
      }
    BlockMatrix m;
    m.set_pattern(n_blocks, n_nodes, pairs, couplings);
    for (Mat6 &block : m.diagonal)
      {
        const Mat6 a = Mat6::Random();
        block        = a * a.transpose() + Mat6::Identity();
      }
    for (std::size_t s = 0; s < m.pairs.size(); ++s)
      {
        const Vec6 a = Vec6::Random(), b = Vec6::Random();
        m.diagonal[m.pairs[s][0]] += a * a.transpose();
        m.diagonal[m.pairs[s][1]] += b * b.transpose();
        m.off_diagonal[s] = -a * b.transpose();
        m.lower[s]        = m.off_diagonal[s].transpose();
      }
    for (Eigen::Matrix2d &node : m.node_diagonal)
      node.setIdentity();
    for (std::size_t s = 0; s < m.couplings.size(); s += 2)
      {
        const Vec6            a = Vec6::Random();
        const Eigen::Vector2d b = Eigen::Vector2d::Random();
        const int             i = m.couplings[s][0], k = m.couplings[s][1];
        m.diagonal[i] += a * a.transpose();
        m.block_node[s]     = -0.6 * a * b.transpose();
        m.block_node[s + 1] = -0.4 * a * b.transpose();
        m.node_block[s]     = m.block_node[s].transpose();
        m.node_block[s + 1] = m.block_node[s + 1].transpose();
        m.node_diagonal[k] += 0.36 * b * b.transpose();
        m.node_diagonal[k + 1] += 0.16 * b * b.transpose();
        m.node_next[k] += 0.24 * b * b.transpose();
        m.node_previous[k] += 0.24 * b * b.transpose();
      }
    return m;
  }



  /// The same, as joints that slide with friction make it: rows and columns differ by @p size.
  inline dda::BlockMatrix unsymmetric_block_matrix(const int               n_blocks,
                                                   const int               n_nodes,
                                                   const double            size,
                                                   const std::vector<int> &distances = {1, 3})
  {
    dda::BlockMatrix m = random_block_matrix(n_blocks, n_nodes, distances);
    for (auto &part : m.diagonal)
      part += size * dda::Mat6::Random();
    for (auto &part : m.lower)
      part += size * dda::Mat6::Random();
    for (auto &part : m.node_block)
      part += size * dda::BlockMatrix::Mat26::Random();
    for (auto &part : m.node_previous)
      part += size * Eigen::Matrix2d::Random();
    m.symmetric = false;
    return m;
  }
} // namespace hybrid::test
