// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/settled_islands.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hybrid::dda
{
  void SettledIslands::begin(const int n_blocks)
  {
    working.resize(n_blocks);
    std::iota(working.begin(), working.end(), 0);
    settled.assign(n_blocks, 0);
    is_split = false;
  }



  int SettledIslands::find(int block)
  {
    while (root[block] != block)
      block = root[block] = root[root[block]];
    return block;
  }



  void SettledIslands::split(const Springs &springs)
  {
    const int n = static_cast<int>(settled.size());
    root.resize(n);
    left.resize(n);
    std::iota(root.begin(), root.end(), 0);
    n_islands = n;
    for (const Springs::Bodies &bodies : springs.bodies)
      {
        if (bodies.other == foundation_body)
          continue;
        const int a = find(bodies.block), b = find(bodies.other);
        n_islands -= a == b ? 0 : 1;
        root[std::max(a, b)] = std::min(a, b);
      }
    for (int b = 0; b < n; ++b) // each root is the least of its island
      root[b] = root[root[b]];
    is_split = true;
  }



  bool SettledIslands::settle(const Balance &balance, const double tolerance, Springs &springs)
  {
    if (!is_split)
      split(springs);
    if (n_islands < 2)
      return false;
    for (const int b : working)
      left[root[b]] = 0.;
    for (const int b : working)
      {
        const auto r = balance.residual.segment<6>(6 * b);
        left[root[b]] += r.cwiseQuotient(balance.scale.segment<6>(6 * b)).squaredNorm() -
                         std::pow(tolerance * balance.forces[b], 2);
      }
    const auto stays = [&](const int b) {
      settled[b] = left[root[b]] <= 0. ? 1 : 0;
      return settled[b] != 0;
    };
    const auto end = std::remove_if(working.begin(), working.end(), stays);
    if (end == working.end())
      return false;
    working.erase(end, working.end());
    for (Springs::Spring &spring : springs.springs)
      spring.settled = is_settled(spring.block);
    return true;
  }



  void SettledIslands::narrow(const std::vector<int> &blocks)
  {
    std::swap(wide, working);
    working.assign(blocks.begin(), blocks.end());
    for (const int b : wide)
      settled[b] = 1;
    for (const int b : working)
      settled[b] = 0;
  }



  void SettledIslands::widen()
  {
    std::swap(wide, working);
    for (const int b : working)
      settled[b] = 0;
  }



  void SettledIslands::wake(Springs &springs)
  {
    if (working.size() == settled.size())
      return;
    begin(static_cast<int>(settled.size()));
    for (Springs::Spring &spring : springs.springs)
      spring.settled = false;
  }
} // namespace hybrid::dda
