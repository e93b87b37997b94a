// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/block_owners.h>

#include <algorithm>
#include <numeric>

namespace hybrid::dda
{
  void BlockOwners::cut(const std::vector<Vec2> &centres, const int n_processes)
  {
    const int n = static_cast<int>(centres.size());
    order.resize(n);
    owner.resize(n);
    std::iota(order.begin(), order.end(), 0);
    share_out(centres, 0, n, 0, n_processes);
  }



  void BlockOwners::share_out(const std::vector<Vec2> &centres,
                              const int                begin,
                              const int                end,
                              const int                first,
                              const int                n)
  {
    if (n == 1 || begin == end)
      {
        for (int k = begin; k < end; ++k)
          owner[order[k]] = first;
        return;
      }
    Vec2 lower = centres[order[begin]], upper = lower;
    for (int k = begin; k < end; ++k)
      {
        lower = lower.cwiseMin(centres[order[k]]);
        upper = upper.cwiseMax(centres[order[k]]);
      }
    const int axis   = upper.x() - lower.x() >= upper.y() - lower.y() ? 0 : 1;
    const int half   = n / 2;
    const int middle = begin + static_cast<int>(static_cast<long>(end - begin) * half / n);
    std::nth_element(order.begin() + begin,
                     order.begin() + middle,
                     order.begin() + end,
                     [&](const int a, const int b) {
                       return centres[a][axis] != centres[b][axis]
                                ? centres[a][axis] < centres[b][axis]
                                : a < b;
                     });
    share_out(centres, begin, middle, first, half);
    share_out(centres, middle, end, first + half, n - half);
  }
} // namespace hybrid::dda
