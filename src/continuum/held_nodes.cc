// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/held_nodes.h>

#include <algorithm>
#include <cassert>

namespace hybrid::continuum
{
  HeldNodes::HeldNodes(std::vector<int> own)
    : n_own(own.size())
    , mine(std::move(own))
  {}



  void HeldNodes::add(const std::vector<int> &nodes)
  {
    std::vector<int> added;
    for (const int node : nodes)
      if (slot(node) < 0)
        added.push_back(node);
    std::sort(added.begin(), added.end());
    added.erase(std::unique(added.begin(), added.end()), added.end());
    for (const int node : added)
      {
        slot_of_further.emplace_back(node, static_cast<int>(size()));
        further.push_back(node);
      }
    std::sort(slot_of_further.begin(), slot_of_further.end());
  }



  int HeldNodes::slot(const int node) const
  {
    if (has_all)
      return node;
    if (const auto own = std::lower_bound(mine.begin(), mine.end(), node);
        own != mine.end() && *own == node)
      return static_cast<int>(own - mine.begin());
    const auto other =
      std::lower_bound(slot_of_further.begin(), slot_of_further.end(), std::pair(node, 0));
    return other != slot_of_further.end() && other->first == node ? other->second : -1;
  }



  std::vector<int> HeldNodes::slots(const std::vector<int> &nodes) const
  {
    std::vector<int> result;
    for (const int node : nodes)
      {
        result.push_back(slot(node));
        assert(result.back() >= 0);
      }
    return result;
  }
} // namespace hybrid::continuum
