// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_owners.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    /// The tallest tops that are tried: so many fronts per process.
    constexpr int most_of_all = 16;

    using Subtree = std::pair<double, int>; ///< its products and its top front



    /// Give each subtree, the largest first, to the process that has least. @return what the one
    /// with most has
    double
    hand_out(std::vector<Subtree> subtrees, std::vector<double> load, std::vector<int> &owner)
    {
      std::sort(subtrees.begin(), subtrees.end(), [](const Subtree &a, const Subtree &b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
      });
      for (const auto &[products, top] : subtrees)
        {
          const auto least = std::min_element(load.begin(), load.end());
          *least += products;
          owner[top] = static_cast<int>(least - load.begin());
        }
      return *std::max_element(load.begin(), load.end());
    }
  } // namespace



  FrontOwners::FrontOwners(const FrontTree &tree, const int n_processes)
    : processes(n_processes)
    , of(tree.n_fronts(), processes > 1 ? all : 0)
    , largest(tree.products)
  {
    if (processes <= 1)
      return;
    const int                     n = tree.n_fronts();
    std::vector<double>           below(n); // products of the subtree
    std::vector<std::vector<int>> children(n);
    std::priority_queue<Subtree>  subtrees;
    for (int f = 0; f < n; ++f)
      {
        below[f] += tree.products_of(f);
        if (tree.parent[f] < 0)
          subtrees.push({below[f], f});
        else
          {
            below[tree.parent[f]] += below[f];
            children[tree.parent[f]].push_back(f);
          }
      }
    // Open the largest subtree, again and again, and keep the best mapping.
    double               of_all = 0.;
    std::vector<Subtree> list;
    std::vector<int>     owner(n, all);
    for (int opened = 0; opened <= most_of_all * processes && !subtrees.empty(); ++opened)
      {
        list.clear();
        for (auto copy = subtrees; !copy.empty(); copy.pop())
          list.push_back(copy.top());
        std::vector<int> now(n, all);
        const double     most = of_all + hand_out(list, std::vector<double>(processes, 0.), now);
        if (most < largest)
          {
            largest = most;
            owner   = now;
          }
        const int top = subtrees.top().second;
        subtrees.pop();
        of_all += tree.products_of(top);
        if (children[top].empty() || of_all >= largest)
          break;
        for (const int child : children[top])
          subtrees.push({below[child], child});
      }
    for (int f = n - 1; f >= 0; --f)
      of[f] = owner[f] == all && tree.parent[f] >= 0 ? of[tree.parent[f]] : owner[f];
  }
} // namespace hybrid::dda
