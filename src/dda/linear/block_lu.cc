// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_inverse.h>
#include <hybrid/dda/linear/block_lu.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <iterator>

namespace hybrid::dda
{
  namespace
  {
    /// Of a block of the diagonal while others are eliminated; times the round-off it is the error
    /// of the factors (Wilkinson 1961).
    constexpr double max_growth = 1e4;
  } // namespace



  void BlockLu::connect()
  {
    neighbours.resize(n_analyzed);
    for (auto &list : neighbours)
      list.clear();
    for (const auto &pair : analyzed)
      for (const int end : {0, 1})
        neighbours[pair[end]].push_back(pair[1 - end]);
    for (auto &list : neighbours)
      std::sort(list.begin(), list.end());
  }



  void BlockLu::eliminate(const int b)
  {
    for (const int n : neighbours[b])
      {
        joined.clear();
        std::set_union(neighbours[n].begin(),
                       neighbours[n].end(),
                       neighbours[b].begin(),
                       neighbours[b].end(),
                       std::back_inserter(joined));
        joined.erase(std::remove_if(joined.begin(),
                                    joined.end(),
                                    [&](const int other) { return other == b || other == n; }),
                     joined.end());
        neighbours[n].assign(joined.begin(), joined.end());
        by_degree[joined.size()].push_back(n);
      }
  }



  void BlockLu::choose_order(const long most)
  {
    const int n = static_cast<int>(neighbours.size());
    by_degree.resize(std::max<std::size_t>(by_degree.size(), n + 1));
    for (auto &list : by_degree)
      list.clear();
    for (int b = n - 1; b >= 0; --b)
      by_degree[neighbours[b].size()].push_back(b);
    block.clear();
    place.assign(n, -1);
    n_products = 0;
    for (std::size_t degree = 0; static_cast<int>(block.size()) < n;)
      {
        if (by_degree[degree].empty())
          {
            ++degree;
            continue;
          }
        const int b = by_degree[degree].back();
        by_degree[degree].pop_back();
        if (place[b] >= 0 || neighbours[b].size() != degree)
          continue;
        // The d neighbours of a block are coupled to each other once it is gone, and then take at
        // least what a full matrix of d blocks takes: the sum of k (k + 1), k < d.
        const long d = static_cast<long>(degree);
        if (d * (d + 1) + (d - 1) * d * (d + 1) / 3 > most - n_products)
          {
            n_products = most + 1;
            return;
          }
        n_products += d * (d + 1);
        place[b] = static_cast<int>(block.size());
        block.push_back(b);
        eliminate(b);
        degree -= std::min<std::size_t>(degree, 1); // a neighbour has lost b
      }
  }



  void BlockLu::set_pattern()
  {
    begin.assign(1, 0);
    later.clear();
    for (const int b : block)
      {
        for (const int other : neighbours[b])
          later.push_back(place[other]);
        std::sort(later.begin() + begin.back(), later.end());
        begin.push_back(static_cast<int>(later.size()));
      }
  }



  long BlockLu::analyze(const BlockMatrix &matrix, const long most)
  {
    touching.clear();
    for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
      if (!matrix.is_zero(s))
        touching.push_back(matrix.pairs[s]);
    if (n_analyzed == matrix.n_blocks() && most_allowed == most && touching == analyzed)
      return n_products;
    n_analyzed   = matrix.n_blocks();
    most_allowed = most;
    std::swap(touching, analyzed);
    connect();
    choose_order(most);
    if (n_products <= most)
      set_pattern();
    return n_products;
  }



  std::size_t BlockLu::entry(const int row, const int column) const
  {
    return std::lower_bound(later.begin() + begin[row], later.begin() + begin[row + 1], column) -
           later.begin();
  }



  void BlockLu::load(const BlockMatrix &matrix)
  {
    const int n = matrix.n_blocks();
    diagonal.resize(n);
    inverse.resize(n);
    upper.assign(later.size(), Mat6::Zero());
    lower.assign(later.size(), Mat6::Zero());
    for (int p = 0; p < n; ++p)
      diagonal[p] = matrix.diagonal[block[p]];
    for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
      {
        if (matrix.is_zero(s))
          continue;
        const int         i = place[matrix.pairs[s][0]], j = place[matrix.pairs[s][1]];
        const std::size_t e = entry(std::min(i, j), std::max(i, j));
        upper[e]            = i < j ? matrix.off_diagonal[s] : matrix.lower[s];
        lower[e]            = i < j ? matrix.lower[s] : matrix.off_diagonal[s];
      }
  }



  void BlockLu::update_later(const int p)
  {
    for (int a = begin[p]; a < begin[p + 1]; ++a)
      {
        const int q = later[a];
        diagonal[q].noalias() -= lower[a] * upper[a];
        for (int b = a + 1, e = begin[q]; b < begin[p + 1]; ++b)
          {
            while (later[e] != later[b])
              ++e;
            upper[e].noalias() -= lower[a] * upper[b];
            lower[e].noalias() -= lower[b] * upper[a];
          }
      }
  }



  bool BlockLu::factorize(const BlockMatrix &matrix)
  {
    load(matrix);
    for (int p = 0; p < matrix.n_blocks(); ++p)
      {
        const double start = matrix.diagonal[block[p]].cwiseAbs().maxCoeff();
        inverse[p]         = block_inverse(diagonal[p]);
        if (!(condition(inverse[p], diagonal[p]) <= 6. * worst_condition_of_inverse) ||
            !(diagonal[p].cwiseAbs().maxCoeff() <= max_growth * start))
          return false;
        for (int a = begin[p]; a < begin[p + 1]; ++a)
          lower[a] = lower[a] * inverse[p];
        update_later(p);
      }
    return true;
  }



  void BlockLu::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) const
  {
    const int  n    = static_cast<int>(block.size());
    const auto part = [&](const int p) { return Eigen::Map<Vec6>(x.data() + 6 * block[p]); };
    x.head(6 * n)   = b.head(6 * n);
    for (int p = 0; p < n; ++p)
      for (int a = begin[p]; a < begin[p + 1]; ++a)
        part(later[a]).noalias() -= lower[a] * part(p);
    for (int p = n - 1; p >= 0; --p)
      {
        Vec6 rest = part(p);
        for (int a = begin[p]; a < begin[p + 1]; ++a)
          rest.noalias() -= upper[a] * part(later[a]);
        part(p).noalias() = inverse[p] * rest;
      }
  }



  void BlockLu::serialize(restart::Archive &archive)
  {
    archive(place, block, begin, later, upper, lower, inverse);
    if (archive.is_reading())
      n_analyzed = -1;
  }
} // namespace hybrid::dda
