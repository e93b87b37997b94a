// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/sweep_order.h>

#include <algorithm>
#include <numeric>

namespace hybrid::dda
{
  SweepOrder::SweepOrder(const int                              n_blocks,
                         const std::vector<int>                &part,
                         const std::vector<std::array<int, 2>> &pairs)
  {
    const int n_parts =
      part.empty() ? 1 : 1 + std::max(0, *std::max_element(part.begin(), part.end()));
    std::vector<int> group = part.empty() ? std::vector<int>(n_blocks, 0) : part;
    for (const auto &[i, j] : pairs)
      if (group[i] != group[j] && group[i] < n_parts && group[j] < n_parts)
        group[group[i] > group[j] ? i : j] = n_parts;

    begin.assign(n_parts + 2, 0);
    for (const int g : group)
      ++begin[g + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    block.resize(n_blocks);
    place.resize(n_blocks);
    for (int b = 0; b < n_blocks; ++b)
      {
        place[b]        = next[group[b]]++;
        block[place[b]] = b;
      }
  }



  std::vector<int> slices(const std::vector<Vec2> &centres)
  {
    constexpr int min_blocks = 128, max_parts = 8; // per part, in all
    const int n = static_cast<int>(centres.size()), n_parts = std::min(max_parts, n / min_blocks);
    if (n_parts < 2)
      return std::vector<int>(n, 0);
    Vec2 lower = centres[0], upper = centres[0];
    for (const Vec2 &c : centres)
      {
        lower = lower.cwiseMin(c);
        upper = upper.cwiseMax(c);
      }
    const int        axis = upper.x() - lower.x() >= upper.y() - lower.y() ? 0 : 1;
    std::vector<int> along(n), part(n);
    std::iota(along.begin(), along.end(), 0);
    std::stable_sort(along.begin(), along.end(), [&](const int a, const int b) {
      return centres[a][axis] < centres[b][axis];
    });
    for (int k = 0; k < n; ++k)
      part[along[k]] = static_cast<int>(static_cast<long>(k) * n_parts / n);
    return part;
  }
} // namespace hybrid::dda
