// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/substitution_plan.h>

#include <algorithm>
#include <numeric>

namespace hybrid::continuum
{
  namespace
  {
    /// Largest part of all numbers that one thread reads in a row while others read theirs.
    constexpr double largest_part = 1. / 16.;



    int rows_of(const SupernodalPattern &pattern, const int k)
    {
      return pattern.row_begin[k + 1] - pattern.row_begin[k];
    }

    /// Of the interior.
    int columns_of(const SupernodalPattern &pattern, const int k)
    {
      return std::min(pattern.first_column[k + 1], pattern.n_interior) - pattern.first_column[k];
    }



    /// The elimination tree of the supernodes, children before parents.
    struct SupernodeTree
    {
      std::vector<int>    parent; ///< -1: none but the surface is above
      std::vector<int>    order;  ///< with all descendants right before each
      std::vector<double> weight; ///< numbers of each and its descendants
      std::vector<int>    size;   ///< of each with its descendants

      explicit SupernodeTree(const SupernodalPattern &pattern);
    };



    SupernodeTree::SupernodeTree(const SupernodalPattern &pattern)
      : parent(pattern.n_supernodes, -1)
      , weight(pattern.n_supernodes, 0.)
      , size(pattern.n_supernodes, 1)
    {
      const int        n = pattern.n_supernodes;
      std::vector<int> supernode(pattern.n_interior);
      for (int k = 0; k < n; ++k)
        std::fill_n(supernode.begin() + pattern.first_column[k], columns_of(pattern, k), k);
      std::vector<std::vector<int>> children(n);
      std::vector<int>              open; // the next to be visited last
      for (int k = 0; k < n; ++k)
        {
          const int columns = columns_of(pattern, k), rows = rows_of(pattern, k);
          weight[k] += static_cast<double>(rows) * columns;
          const int above =
            columns < rows ? pattern.row[pattern.row_begin[k] + columns] : pattern.n_interior;
          if (above >= pattern.n_interior)
            continue;
          parent[k] = supernode[above];
          weight[parent[k]] += weight[k]; // children have smaller numbers
          size[parent[k]] += size[k];
          children[parent[k]].push_back(k);
        }
      for (int k = 0; k < n; ++k)
        if (parent[k] < 0)
          open.push_back(k);
      while (!open.empty()) // parents before children, backwards
        {
          const int k = open.back();
          open.pop_back();
          order.push_back(k);
          open.insert(open.end(), children[k].begin(), children[k].end());
        }
      std::reverse(order.begin(), order.end());
    }
  } // namespace



  SubstitutionPlan::SubstitutionPlan(const SupernodalPattern &pattern)
  {
    const SupernodeTree tree(pattern);
    double              all = 0.;
    for (int k = 0; k < pattern.n_supernodes; ++k)
      all += tree.parent[k] < 0 ? tree.weight[k] : 0.;
    const double                  most = largest_part * all;
    std::vector<int>              above;
    std::vector<std::vector<int>> lists;
    double                        taken = 0.; // by the last list
    for (int i = 0; i < pattern.n_supernodes; ++i)
      {
        const int k = tree.order[i];
        if (tree.weight[k] > most)
          {
            above.push_back(k);
            continue;
          }
        if (tree.parent[k] >= 0 && tree.weight[tree.parent[k]] <= most)
          continue;
        if (lists.empty() || taken + tree.weight[k] > most)
          {
            lists.emplace_back();
            taken = 0.;
          }
        taken += tree.weight[k];
        lists.back().insert(lists.back().end(),
                            tree.order.begin() + i + 1 - tree.size[k],
                            tree.order.begin() + i + 1);
      }
    std::vector<int> surface(pattern.n_surface);
    std::iota(surface.begin(), surface.end(), pattern.n_interior);
    place_above.assign(pattern.n_interior + pattern.n_surface, -1);
    int place = 0;
    for (const int k : above)
      for (int j = 0; j < columns_of(pattern, k); ++j)
        place_above[pattern.first_column[k] + j] = place++;
    for (const int s : surface)
      place_above[s] = place++;
    place_in_part.assign(place_above.size(), -1);
    for (const auto &list : lists)
      add_part(pattern, list, beyond(pattern, list));
    add_part(pattern, above, surface);
    place_in_part = place_above = {};
  }



  std::vector<int> SubstitutionPlan::beyond(const SupernodalPattern &pattern,
                                            const std::vector<int>  &supernodes) const
  {
    std::vector<int> list;
    for (const int k : supernodes)
      for (int i = pattern.row_begin[k] + columns_of(pattern, k); i < pattern.row_begin[k + 1]; ++i)
        if (place_above[pattern.row[i]] >= 0)
          list.push_back(pattern.row[i]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }



  void SubstitutionPlan::add_part(const SupernodalPattern &pattern,
                                  const std::vector<int>  &supernodes,
                                  const std::vector<int>  &unknowns_outside)
  {
    Part part;
    part.first_panel   = static_cast<int>(panels.size());
    part.first_own     = static_cast<int>(own.size());
    part.first_outside = static_cast<int>(outside.size());
    part.begin         = n_numbers;
    int place          = 0;
    for (const int k : supernodes)
      for (int j = pattern.first_column[k]; j < pattern.first_column[k] + columns_of(pattern, k);
           ++j)
        {
          place_in_part[j] = place++;
          own.push_back(pattern.permutation[j]);
        }
    for (const int unknown : unknowns_outside)
      {
        place_in_part[unknown] = place++;
        outside.push_back(place_above[unknown]);
      }
    for (const int k : supernodes)
      add_panels(pattern, k, place);
    part.last_panel   = static_cast<int>(panels.size());
    part.last_own     = static_cast<int>(own.size());
    part.last_outside = static_cast<int>(outside.size());
    n_numbers += place + 1;
    parts.push_back(part);
  }



  void SubstitutionPlan::add_panels(const SupernodalPattern &pattern,
                                    const int                supernode,
                                    const int                no_one)
  {
    const int *rows    = pattern.row + pattern.row_begin[supernode];
    const int  columns = columns_of(pattern, supernode), n_rows = rows_of(pattern, supernode);
    const int  n_panels  = (columns + widest - 1) / widest;
    const auto row_begin = static_cast<int>(row.size());
    for (int i = 0; i < n_rows; ++i)
      row.push_back(place_in_part[rows[i]]);
    row.insert(row.end(), rows_at_once - 1, no_one);
    for (int p = 0; p < n_panels; ++p)
      {
        const int first = p * columns / n_panels, last = (p + 1) * columns / n_panels;
        Panel     panel;
        panel.place     = place_in_part[rows[first]];
        panel.columns   = last - first;
        panel.n_fours   = (n_rows - last + rows_at_once - 1) / rows_at_once;
        panel.row_begin = row_begin + last;
        panel.begin     = n_values;
        panel.supernode = supernode;
        panel.column    = first;
        n_values += panel.columns * (panel.columns + 1) / 2 +
                    static_cast<std::size_t>(rows_at_once) * panel.n_fours * panel.columns;
        panels.push_back(panel);
      }
  }



  std::vector<double> SubstitutionPlan::pack(const SupernodalPattern &pattern,
                                             const double            *values) const
  {
    std::vector<double> packed(n_values);
    for (const Panel &panel : panels)
      {
        const int     n_rows = rows_of(pattern, panel.supernode);
        const double *from   = values + pattern.value_begin[panel.supernode] +
                             static_cast<std::ptrdiff_t>(panel.column) * n_rows;
        const auto entry = [&](const int i, const int j) { // counted from the panel's first
          return from[static_cast<std::ptrdiff_t>(j) * n_rows + panel.column + i];
        };
        double *to = packed.data() + panel.begin;
        for (int i = 0; i < panel.columns; ++i)
          {
            for (int j = 0; j < i; ++j)
              *to++ = entry(i, j);
            *to++ = 1. / entry(i, i);
          }
        const int below = n_rows - panel.column - panel.columns;
        for (int i = 0; i < panel.n_fours * rows_at_once; i += rows_at_once)
          for (int j = 0; j < panel.columns; ++j)
            for (int k = i; k < i + rows_at_once; ++k)
              *to++ = k < below ? entry(panel.columns + k, j) : 0.;
      }
    return packed;
  }
} // namespace hybrid::continuum
