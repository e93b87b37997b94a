// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/springs/springs_of_blocks.h>

#include <numeric>

namespace hybrid::dda
{
  void SpringsOfBlocks::sort(const std::vector<SpringBodies> &bodies, const int n_blocks)
  {
    ++sorted;
    foundation_springs.clear();
    for (std::size_t s = 0; s < bodies.size(); ++s)
      if (bodies[s].other == foundation_body)
        foundation_springs.push_back(static_cast<int>(s));
    block_begin.assign(n_blocks + 2, 0); // one place later while counting and filling
    const auto for_each = [&](const auto &act) {
      for (std::size_t s = 0; s < bodies.size(); ++s)
        {
          act(bodies[s].block, 2 * static_cast<int>(s));
          if (bodies[s].other != foundation_body)
            act(bodies[s].other, 2 * static_cast<int>(s) + 1);
        }
    };
    for_each([&](const int block, int) { ++block_begin[block + 2]; });
    std::partial_sum(block_begin.begin(), block_begin.end(), block_begin.begin());
    block_springs.resize(block_begin.back());
    for_each(
      [&](const int block, const int entry) { block_springs[block_begin[block + 1]++] = entry; });
  }
} // namespace hybrid::dda
