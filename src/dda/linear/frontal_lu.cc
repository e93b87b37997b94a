// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <malloc.h>
#include <omp.h>

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

    /// Part of all products up to which it pays to keep what fronts hand on, and how many entries
    /// of it are kept at most (256 MB).
    constexpr double      small_part = 0.7;
    constexpr std::size_t most_kept  = std::size_t{1} << 25;

    void set_zero(const DenseView &matrix) // columns without gaps
    {
      std::fill_n(matrix.data, static_cast<std::size_t>(matrix.rows) * matrix.columns, 0.);
    }



    void copy_lower_to_upper(const DenseView &matrix)
    {
      for (int j = 0; j < matrix.columns / 6; ++j)
        for (int i = j + 1; i < matrix.rows / 6; ++i)
          matrix.block(j, i) = matrix.block(i, j).transpose();
    }



    /// @return true if that changed a bit.
    bool replace(Mat6 &old, const Mat6 &now)
    {
      if (std::memcmp(old.data(), now.data(), sizeof(double) * 36) == 0)
        return false;
      old = now;
      return true;
    }



    std::vector<BlockMatrix::Pair> pairs_not_zero(const BlockMatrix &matrix)
    {
      std::vector<BlockMatrix::Pair> list;
      for (std::size_t s = 0; s < matrix.pairs.size(); ++s)
        if (!matrix.is_zero(s))
          list.push_back(matrix.pairs[s]);
      return list;
    }



    /// Room for so many numbers, whatever they were: not beside the old ones while it grows, which
    /// may be the largest part of the memory.
    void make_room(std::vector<double> &numbers, const std::size_t n)
    {
      if (n > numbers.capacity())
        {
          std::vector<double>().swap(numbers);
          malloc_trim(0);
          numbers.reserve(n + n / 16); // other fronts follow, a little larger
        }
      numbers.resize(n);
    }
  } // namespace



  void FrontalLu::analyze(std::vector<BlockMatrix::Pair> now, const int n_blocks)
  {
    pairs               = std::move(now);
    size                = n_blocks;
    tree                = FrontTree(n_blocks, pairs);
    const bool is_large = is_worth_sharing(size);
    plan =
      FrontPlan(tree,
                omp_get_max_threads() > 1 && is_large,
                group != nullptr && is_large ? FrontOwners(tree, group->count()) : FrontOwners(),
                group != nullptr ? group->rank() : 0);
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
                            tree.position(f, std::max(i, j))};
      }

    regular = keeps = false;
    is_due.assign(n, 1);
    diagonal.resize(n_blocks);
    below_diagonal.resize(pairs.size());
    pivots.resize(6 * static_cast<std::size_t>(n_blocks));
    rest.resize(6 * n_blocks);
    ordered.resize(6 * n_blocks);
    handed.resize(6 * static_cast<Eigen::Index>(tree.later_places.size()));
    for (Work &of_thread : work)
      of_thread = Work();
    if (shares_fronts())
      list_places();
  }



  void FrontalLu::bring_order_up_to_date(const BlockMatrix &matrix)
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
    if (covered && !too_many(pairs.size()))
      return;
    std::vector<BlockMatrix::Pair> now = pairs_not_zero(matrix), both;
    if (size == matrix.n_blocks())
      std::set_union(now.begin(), now.end(), pairs.begin(), pairs.end(), std::back_inserter(both));
    analyze(both.empty() || too_many(both.size()) ? std::move(now) : std::move(both),
            matrix.n_blocks());
  }



  void FrontalLu::load(const BlockMatrix &matrix)
  {
    bring_order_up_to_date(matrix);
    if (!regular || symmetric != matrix.symmetric)
      std::fill(is_due.begin(), is_due.end(), 1);
    else
      std::fill(is_due.begin(), is_due.end(), 0);
    symmetric = matrix.symmetric;
    if (!symmetric)
      right_of_diagonal.resize(pairs.size());
    for (int b = 0; b < size; ++b)
      if (replace(diagonal[b], matrix.diagonal[b]))
        is_due[tree.front[tree.place[b]]] = 1;
    const Mat6 zero = Mat6::Zero();
    for (std::size_t a = 0, s = 0; a < pairs.size(); ++a)
      {
        while (s < matrix.pairs.size() && matrix.pairs[s] < pairs[a])
          ++s;
        const bool  there = s < matrix.pairs.size() && matrix.pairs[s] == pairs[a];
        const int   i = tree.place[pairs[a][0]], j = tree.place[pairs[a][1]];
        const auto &of_first = i < j ? matrix.lower : matrix.off_diagonal,
                   &to_first = i < j ? matrix.off_diagonal : matrix.lower;
        bool is_new          = replace(below_diagonal[a], there ? of_first[s] : zero);
        if (!symmetric)
          is_new = replace(right_of_diagonal[a], there ? to_first[s] : zero) || is_new;
        if (is_new)
          is_due[tree.front[std::min(i, j)]] = 1;
      }
  }



  FrontalLu::Cost FrontalLu::cost_of_due() const
  {
    Cost sum;
    for (int f = 0; f < tree.n_fronts(); ++f)
      if (is_due[f] != 0)
        {
          sum.products += tree.products_of(f);
          sum.fronts += 1.;
        }
    return sum;
  }



  void FrontalLu::choose_fronts()
  {
    for (int f = 0; f < tree.n_fronts(); ++f)
      if (is_due[f] != 0 && tree.parent[f] >= 0)
        is_due[tree.parent[f]] = 1;
    cost = cost_of_due();
    if (keeps)
      return;
    keeps = cost.products <= small_part * tree.products && kept_entries(tree) > 0;
    if (keeps)
      {
        plan.keep_all(tree);
      }
    std::fill(is_due.begin(), is_due.end(), 1);
    cost = {tree.products, static_cast<double>(tree.n_fronts())};
  }



  std::size_t FrontalLu::kept_entries(const FrontTree &tree)
  {
    const std::size_t all = FrontPlan::left_by_all(tree);
    return all <= most_kept ? all : 0;
  }



  void FrontalLu::place_factors()
  {
    factor_begin.assign(1, 0);
    for (int f = 0; f < tree.n_fronts(); ++f)
      {
        const std::size_t p = tree.own(f), u = tree.later(f);
        factor_begin.push_back(factor_begin.back() +
                               (plan.is_mine(f) ? 36 * p * (p + (symmetric ? 1 : 2) * u) : 0));
      }
    make_room(factors, factor_begin.back());
  }



  bool FrontalLu::factorize(const BlockMatrix &matrix)
  {
    load(matrix);
    return factorize_loaded();
  }



  bool FrontalLu::factorize_loaded()
  {
    choose_fronts();
    return eliminate();
  }



  void FrontalLu::give_back_work()
  {
    std::vector<Work>().swap(work);
    if (!keeps)
      std::vector<double>().swap(waiting);
  }



  void FrontalLu::reserve_work()
  {
    make_room(waiting, plan.size);
    work.resize(
      std::max<std::size_t>(work.size(), plan.shared.empty() ? 1 : omp_get_max_threads()));
    for (std::size_t t = 0; t < work.size(); ++t)
      {
        const FrontPlan::Largest &largest = t == 0 ? plan.largest : plan.largest_shared;
        work[t].below.resize(36 * largest.panel);
        work[t].largest.resize(largest.own);
        work[t].inverse.reserve(6 * largest.own);
      }
  }



  double *FrontalLu::kept_of(const int f)
  {
    const std::size_t p = tree.own(f);
    return factors.data() + factor_begin[f] + 36 * p * p;
  }



  std::ptrdiff_t FrontalLu::entries_of_panel(const int f) const
  {
    return 36 * static_cast<std::ptrdiff_t>(tree.own(f)) * tree.later(f);
  }



  FrontalLu::Front FrontalLu::front_of(const int f, Work &of_thread)
  {
    const int p = 6 * tree.own(f), u = 6 * tree.later(f);
    double   *kept  = kept_of(f);
    double   *right = symmetric ? nullptr : kept + entries_of_panel(f);
    return {{factors.data() + factor_begin[f], p, p, p},
            {right, p, u, p},
            {of_thread.below.data(), u, p, u},
            {kept, u, p, u},
            {waiting.data() + plan.place[f], u, u, u}};
  }



  DenseDivisor FrontalLu::divisor(const int f, const DenseView &own)
  {
    return {own, pivots.data() + 6 * static_cast<std::ptrdiff_t>(tree.begin[f])};
  }



  void FrontalLu::fill(const int f, const Front &front) const
  {
    const int own = tree.own(f);
    for (const DenseView &part : {front.own, front.below, front.later})
      set_zero(part);
    if (!symmetric)
      set_zero(front.right);
    for (int k = 0; k < own; ++k)
      front.own.block(k, k) = diagonal[tree.block[tree.begin[f] + k]];
    for (int e = entry_begin[f]; e < entry_begin[f + 1]; ++e)
      {
        const Entry &entry = entries[e];
        const bool   inner = entry.second < own;
        (inner ? front.own : front.below).block(entry.second - (inner ? 0 : own), entry.first) =
          below_diagonal[entry.pair];
        if (!symmetric)
          (inner ? front.own : front.right).block(entry.first, entry.second - (inner ? 0 : own)) =
            right_of_diagonal[entry.pair];
      }
  }



  void FrontalLu::add_child(const int child, const Front &front) const
  {
    const int       n = tree.later(child), own = front.own.rows / 6;
    const int      *place = tree.in_parent.data() + tree.later_begin[child];
    const DenseView left  = {const_cast<double *>(waiting.data()) + plan.place[child],
                             6 * n,
                             6 * n,
                             6 * n};
    const int       inner = static_cast<int>(std::lower_bound(place, place + n, own) - place);
    for (int j = 0; j < n; ++j)
      {
        const bool      is_own = j < inner;
        const int       column = place[j] - (is_own ? 0 : own);
        const DenseView above  = is_own ? front.own : front.right,
                        after  = is_own ? front.below : front.later;
        for (int i = symmetric ? j : 0; i < inner; ++i)
          above.block(place[i], column) += left.block(i, j);
        for (int i = std::max(inner, symmetric ? j : 0); i < n; ++i)
          after.block(place[i] - own, column) += left.block(i, j);
      }
  }



  bool FrontalLu::eliminate(const int f, Work &of_thread)
  {
    const Front front = front_of(f, of_thread);
    fill(f, front);
    for (int c = plan.child_begin[f]; c < plan.child_begin[f + 1]; ++c)
      add_child(plan.child[c], front);
    if (symmetric)
      copy_lower_to_upper(front.own);
    for (int k = 0; k < tree.own(f); ++k)
      of_thread.largest[k] =
        max_front_growth * diagonal[tree.block[tree.begin[f] + k]].cwiseAbs().maxCoeff();
    const DenseDivisor own = divisor(f, front.own);
    if (!of_thread.inverse.invert(own, of_thread.largest.data()))
      return false;
    if (tree.later(f) == 0)
      return true;
    divide(front.below, own, front.kept);
    if (symmetric)
      subtract_lower(front.kept, front.below, front.later);
    else
      multiply(-1., front.kept, front.right, 1., front.later);
    return true;
  }



  bool FrontalLu::eliminate()
  {
    place_factors();
    reserve_work();
    bool      served   = true;
    const int n_shared = static_cast<int>(plan.shared.size());
#pragma omp parallel for schedule(dynamic) reduction(&& : served) if (is_worth_sharing(size))
    for (int s = 0; s < n_shared; ++s)
      for (int f = plan.shared[s].first; served && f < plan.shared[s].last; ++f)
        served = is_due[f] == 0 || eliminate(f, work[omp_get_thread_num()]);
    for (std::size_t k = 0; served && k < plan.above.size(); ++k)
      served = is_due[plan.above[k]] == 0 || eliminate(plan.above[k], work[0]);
    if (shares_fronts())
      served = hand_over_fronts(served);
    for (std::size_t k = 0; served && k < plan.of_all.size(); ++k)
      served = is_due[plan.of_all[k]] == 0 || eliminate(plan.of_all[k], work[0]);
    regular = served;
    return served;
  }



  void FrontalLu::serialize(restart::Archive &archive, bool is_used)
  {
    std::vector<BlockMatrix::Pair> stored = pairs;
    int                            blocks = size;
    bool                           kept   = keeps;
    archive(blocks, stored, symmetric, kept, cost.products, cost.fronts);
    if (archive.is_reading() && blocks > 0)
      {
        analyze(stored, blocks);
        keeps = kept;
        if (keeps)
          plan.keep_all(tree);
      }
    std::vector<Mat6> none;
    archive(is_used ? diagonal : none, is_used ? below_diagonal : none);
    archive(is_used && !symmetric ? right_of_diagonal : none);
    if (archive.is_reading() && is_used)
      eliminate();
  }
} // namespace hybrid::dda
