// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/held_neighbours.h>

#include <algorithm>
#include <map>

namespace hybrid::dda
{
  namespace
  {
    bool is_bonded(const int a, const int b, const std::vector<std::pair<int, int>> &bonded)
    {
      return std::binary_search(bonded.begin(),
                                bonded.end(),
                                std::make_pair(std::min(a, b), std::max(a, b)));
    }



    /// Number each block around a node by its chain of bonded pairs: blocks of one chain have the
    /// same number.
    std::vector<int> chains_of(const std::vector<int>                 &blocks,
                               const std::vector<std::pair<int, int>> &bonded)
    {
      const int        n = static_cast<int>(blocks.size());
      std::vector<int> chain(n), waiting;
      int              n_chains = 0;
      for (int start = 0; start < n; ++start)
        {
          if (chain[start] != 0)
            continue;
          chain[start] = ++n_chains;
          waiting      = {start};
          while (!waiting.empty())
            {
              const int i = waiting.back();
              waiting.pop_back();
              for (int j = 0; j < n; ++j)
                if (chain[j] == 0 && is_bonded(blocks[i], blocks[j], bonded))
                  {
                    chain[j] = n_chains;
                    waiting.push_back(j);
                  }
            }
        }
      return chain;
    }
  } // namespace



  std::vector<std::vector<int>> held_neighbours(const std::vector<std::vector<int>>    &outlines,
                                                const std::vector<std::pair<int, int>> &bonded)
  {
    std::map<int, std::vector<int>> blocks_at;
    for (std::size_t b = 0; b < outlines.size(); ++b)
      for (const int node : outlines[b])
        blocks_at[node].push_back(static_cast<int>(b));

    std::vector<std::map<int, bool>> is_held(outlines.size()); // of the blocks that share a node
    for (const auto &[node, blocks] : blocks_at)
      {
        const std::vector<int> chain = chains_of(blocks, bonded);
        for (std::size_t i = 0; i < blocks.size(); ++i)
          for (std::size_t j = 0; j < blocks.size(); ++j)
            if (i != j)
              {
                bool &held = is_held[blocks[i]].emplace(blocks[j], true).first->second;
                held       = held && chain[i] == chain[j];
              }
      }

    std::vector<std::vector<int>> neighbours(outlines.size());
    for (std::size_t b = 0; b < outlines.size(); ++b)
      for (const auto &[other, held] : is_held[b])
        if (held)
          neighbours[b].push_back(other);
    return neighbours;
  }
} // namespace hybrid::dda
