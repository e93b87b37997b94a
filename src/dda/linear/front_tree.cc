// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/front_tree.h>

#include <algorithm>
#include <cholmod.h>
#include <cstring>
#include <mutex>

namespace hybrid::dda
{
  namespace
  {
    /// Nested dissection is tried from here on: its order takes longer to find.
    constexpr int many_blocks = 1000;

    /// How CHOLMOD orders, and when it merges a front with its parent. Its limits are counted in
    /// columns, here of blocks.
    void choose_methods(cholmod_common &common, const int n_blocks)
    {
      common.print              = 0;
      common.supernodal         = CHOLMOD_SUPERNODAL;
      common.nmethods           = n_blocks < many_blocks ? 1 : 2;
      common.method[0].ordering = CHOLMOD_AMD;
      common.method[1].ordering = CHOLMOD_METIS;
      common.nrelax[0]          = 1;
      common.nrelax[1]          = 2;
      common.nrelax[2]          = 4;
    }



    /// The pairs as the upper triangle of a pattern.
    struct Pattern
    {
      std::vector<int> start, rows;
      cholmod_sparse   view;

      Pattern(const int n_blocks, const std::vector<BlockMatrix::Pair> &pairs)
        : start(n_blocks + 1, 0)
        , rows(pairs.size())
      {
        for (const auto &pair : pairs)
          ++start[pair[1] + 1];
        for (int j = 0; j < n_blocks; ++j)
          start[j + 1] += start[j];
        std::vector<int> at(start.begin(), start.end() - 1);
        for (const auto &pair : pairs)
          rows[at[pair[1]]++] = pair[0];

        std::memset(&view, 0, sizeof(view));
        view.nrow = view.ncol = n_blocks;
        view.nzmax            = rows.size();
        view.p                = start.data();
        view.i                = rows.data();
        view.stype            = 1;
        view.itype            = CHOLMOD_INT;
        view.xtype            = CHOLMOD_PATTERN;
        view.dtype            = CHOLMOD_DOUBLE;
        view.sorted = view.packed = 1;
      }
    };
  } // namespace



  FrontTree::FrontTree(const int n_blocks, const std::vector<BlockMatrix::Pair> &pairs)
  {
    if (n_blocks == 0)
      return;
    order(n_blocks, pairs);
    find_parents();
    count();
  }



  void FrontTree::order(const int n_blocks, const std::vector<BlockMatrix::Pair> &pairs)
  {
    Pattern        pattern(n_blocks, pairs);
    cholmod_common common;
    cholmod_start(&common);
    choose_methods(common, n_blocks);
    cholmod_factor *factor = nullptr;
    {
      static std::mutex                 mutex; // METIS draws from std::rand, which threads share
      const std::lock_guard<std::mutex> lock(mutex);
      factor = cholmod_analyze(&pattern.view, &common);
    }
    const auto *perm  = static_cast<const int *>(factor->Perm);
    const auto *super = static_cast<const int *>(factor->super);
    const auto *first = static_cast<const int *>(factor->pi);
    const auto *rows  = static_cast<const int *>(factor->s);
    const int   n     = static_cast<int>(factor->nsuper);

    block.assign(perm, perm + n_blocks);
    place.resize(n_blocks);
    for (int p = 0; p < n_blocks; ++p)
      place[block[p]] = p;
    begin.assign(super, super + n + 1);
    front.resize(n_blocks);
    later_begin.assign(1, 0);
    for (int f = 0; f < n; ++f)
      {
        std::fill(front.begin() + begin[f], front.begin() + begin[f + 1], f);
        later_places.insert(later_places.end(), rows + first[f] + own(f), rows + first[f + 1]);
        later_begin.push_back(static_cast<int>(later_places.size()));
      }
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }



  int FrontTree::position(const int f, const int p) const
  {
    if (p < begin[f + 1])
      return p - begin[f];
    const auto first = later_places.begin() + later_begin[f];
    return own(f) + static_cast<int>(std::lower_bound(first, first + later(f), p) - first);
  }



  void FrontTree::find_parents()
  {
    const int n = static_cast<int>(begin.size()) - 1;
    parent.assign(n, -1);
    in_parent.resize(later_places.size());
    for (int f = 0; f < n; ++f)
      {
        if (later(f) == 0)
          continue;
        parent[f] = front[later_places[later_begin[f]]];
        for (int k = later_begin[f]; k < later_begin[f + 1]; ++k)
          in_parent[k] = position(parent[f], later_places[k]);
      }
  }



  void FrontTree::count()
  {
    for (int f = 0; f < n_fronts(); ++f)
      {
        const double p = own(f), u = later(f);
        entries += p * p + 2. * p * u;
        products += products_of(f);
      }
  }
} // namespace hybrid::dda
