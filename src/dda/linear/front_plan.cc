// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_plan.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    /// Largest part of all products that is eliminated in a row while others are.
    constexpr double largest_part = 1. / 16.;



    /// Entries that a front leaves.
    std::size_t left_by(const FrontTree &tree, const int f)
    {
      return 36 * static_cast<std::size_t>(tree.later(f)) * tree.later(f);
    }
  } // namespace



  void FrontPlan::Largest::take(const FrontTree &tree, const int f)
  {
    own   = std::max(own, tree.own(f));
    panel = std::max(panel, static_cast<std::size_t>(tree.own(f)) * tree.later(f));
  }



  FrontPlan::FrontPlan(const FrontTree   &tree,
                       const bool         is_shared,
                       const FrontOwners &of_processes,
                       const int          rank)
    : owners(of_processes)
    , me(rank)
  {
    for (int f = 0; f < tree.n_fronts(); ++f)
      if (is_mine(f))
        largest.take(tree, f);
    list_children(tree);
    list_handed_over(tree);
    if (is_shared)
      find_subtrees(tree);
    else
      for (int f = 0; f < tree.n_fronts(); ++f)
        if (is_mine(f) && !is_of_all(f))
          above.push_back(f);
    for (const Subtrees &of_thread : shared)
      for (int f = of_thread.first; f < of_thread.last; ++f)
        largest_shared.take(tree, f);
    find_places(tree);
  }



  void FrontPlan::list_handed_over(const FrontTree &tree)
  {
    for (int f = 0; f < tree.n_fronts() && is_of_processes(); ++f)
      {
        if (is_of_all(f))
          of_all.push_back(f);
        else if (owners.is_handed_over(tree, f))
          handed_over.push_back(f);
      }
    std::stable_sort(handed_over.begin(), handed_over.end(), [this](const int f, const int g) {
      return owners.of[f] < owners.of[g];
    });
    handed_by.assign(owners.processes + 1, 0);
    for (const int f : handed_over)
      ++handed_by[owners.of[f] + 1];
    std::partial_sum(handed_by.begin(), handed_by.end(), handed_by.begin());
  }



  void FrontPlan::list_children(const FrontTree &tree)
  {
    const int n = tree.n_fronts();
    child_begin.assign(n + 1, 0);
    for (const int parent : tree.parent)
      if (parent >= 0)
        ++child_begin[parent + 1];
    for (int f = 0; f < n; ++f)
      child_begin[f + 1] += child_begin[f];
    child.resize(child_begin[n]);
    std::vector<int> at(child_begin.begin(), child_begin.end() - 1);
    for (int f = 0; f < n; ++f)
      if (tree.parent[f] >= 0)
        child[at[tree.parent[f]]++] = f;
  }



  void FrontPlan::find_subtrees(const FrontTree &tree)
  {
    const int           n = tree.n_fronts();
    std::vector<double> products(n); // of all below, too
    std::vector<int>    first(n);    // front of all below
    for (int f = 0; f < n; ++f)
      {
        products[f] = tree.products_of(f);
        first[f]    = f;
        for (int c = child_begin[f]; c < child_begin[f + 1]; ++c)
          {
            products[f] += products[child[c]];
            first[f] = std::min(first[f], first[child[c]]);
          }
      }
    const double most     = largest_part * tree.products;
    double       taken    = 0.; // by the last list of subtrees
    const auto   is_below = [&](const int f) { return products[f] <= most && !is_of_all(f); };
    for (int f = 0; f < n; ++f)
      {
        if (!is_mine(f) || is_of_all(f))
          continue;
        if (!is_below(f))
          {
            above.push_back(f);
            continue;
          }
        if (tree.parent[f] >= 0 && is_below(tree.parent[f]))
          continue;
        if (!shared.empty() && shared.back().last == first[f] && taken + products[f] <= most)
          taken += products[f];
        else
          {
            shared.push_back({first[f], f});
            taken = products[f];
          }
        shared.back().last = f + 1;
      }
  }



  void FrontPlan::find_places(const FrontTree &tree)
  {
    constexpr int of_others = -1; // lists: subtrees of this process, its fronts above, those of all
    const int     n = tree.n_fronts(), of_above = static_cast<int>(shared.size());
    std::vector<int> depth(n, 0), list(n, of_others);
    for (int f = n - 1; f >= 0; --f)
      depth[f] = tree.parent[f] < 0 ? 0 : 1 - depth[tree.parent[f]];
    for (std::size_t s = 0; s < shared.size(); ++s)
      std::fill(list.begin() + shared[s].first, list.begin() + shared[s].last, static_cast<int>(s));
    for (const int f : above)
      list[f] = of_above;
    for (const int f : of_all)
      list[f] = of_above + 1;
    place.assign(n, 0);
    for (const int f : handed_over) // at places of their own
      {
        list[f]  = of_others;
        place[f] = size;
        size += left_by(tree, f);
      }
    const auto stack = [&](const auto &fronts) {
      std::array<std::size_t, 2> top{0, 0}, highest{0, 0};
      int                        this_list = of_others;
      for (const int f : fronts)
        {
          if (list[f] != of_others)
            {
              this_list = list[f];
              place[f]  = top[depth[f]];
              top[depth[f]] += left_by(tree, f);
              highest[depth[f]] = std::max(highest[depth[f]], top[depth[f]]);
            }
          for (int c = child_begin[f]; c < child_begin[f + 1]; ++c)
            if (list[child[c]] != of_others && list[child[c]] == this_list)
              top[1 - depth[f]] -= left_by(tree, child[c]);
        }
      for (const int f : fronts)
        if (list[f] != of_others)
          place[f] += size + (depth[f] == 0 ? 0 : highest[0]);
      size += highest[0] + highest[1];
    };
    std::vector<int> fronts;
    for (const Subtrees &trees : shared)
      {
        fronts.clear();
        for (int f = trees.first; f < trees.last; ++f)
          fronts.push_back(f);
        stack(fronts);
      }
    stack(above);
    stack(of_all);
  }



  void FrontPlan::keep_all(const FrontTree &tree)
  {
    size                  = 0;
    const auto place_here = [&](const int f) {
      place[f] = size;
      size += left_by(tree, f);
    };
    for (int f = 0; f < tree.n_fronts(); ++f)
      if (is_mine(f))
        place_here(f);
    for (const int f : handed_over)
      if (!is_mine(f))
        place_here(f);
  }



  std::size_t FrontPlan::left_by_all(const FrontTree &tree)
  {
    std::size_t sum = 0;
    for (int f = 0; f < tree.n_fronts(); ++f)
      sum += left_by(tree, f);
    return sum;
  }
} // namespace hybrid::dda
