// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/stillness_cache.h>

#include <algorithm>

namespace hybrid::dda
{
  void StillnessCache::look(const Geometry &geometry, RestState &rest, const double tolerance)
  {
    // New places are the first ones: they count as moved.
    if (rest.vertices.size() != geometry.vertices.size() ||
        rest.foundation_nodes.size() != geometry.foundation_nodes.size())
      rest = {geometry.vertices,
              geometry.foundation_nodes,
              std::vector<char>(geometry.vertices.size(), 0),
              std::vector<char>(geometry.foundation_nodes.size(), 0)};

    const auto is_same = [tolerance](const Vec2 &now, const Vec2 &then) {
      return (now - then).squaredNorm() <= tolerance * tolerance; // false for NaN
    };
    is_resting.assign(geometry.n_blocks(), 1);
    for (int b = 0; b < geometry.n_blocks(); ++b)
      {
        const int first = geometry.offset[b], last = geometry.offset[b + 1];
        for (int v = first; v < last && is_resting[b]; ++v)
          is_resting[b] = is_same(geometry.vertices[v], rest.vertices[v]);
        if (!is_resting[b])
          std::copy(geometry.vertices.begin() + first,
                    geometry.vertices.begin() + last,
                    rest.vertices.begin() + first);
      }
    is_resting_node.assign(geometry.foundation_nodes.size(), 1);
    for (std::size_t k = 0; k < geometry.foundation_nodes.size(); ++k)
      if (!is_same(geometry.foundation_nodes[k], rest.foundation_nodes[k]))
        {
          is_resting_node[k]       = 0;
          rest.foundation_nodes[k] = geometry.foundation_nodes[k];
        }
  }



  bool StillnessCache::rests(const ContactCandidate &pair) const
  {
    const bool vertex_rests = pair.vertex_body == foundation_body ? is_resting_node[pair.vertex]
                                                                  : is_resting[pair.vertex_body];
    const bool edge_rests   = pair.edge_body == foundation_body
                                ? is_resting_node[pair.edge] && is_resting_node[pair.edge + 1]
                                : is_resting[pair.edge_body];
    return vertex_rests && edge_rests;
  }
} // namespace hybrid::dda
