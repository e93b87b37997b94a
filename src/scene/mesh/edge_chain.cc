// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/edge_chain.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    using Edge = SectionMesh::Edge;

    std::map<int, std::vector<int>> edges_at_nodes(const std::vector<Edge> &edges,
                                                   const std::vector<Vec2> &nodes,
                                                   const std::string       &name)
    {
      std::map<int, std::vector<int>> at_node;
      for (unsigned int e = 0; e < edges.size(); ++e)
        for (const int node : edges[e])
          {
            at_node[node].push_back(e);
            if (at_node[node].size() > 2)
              {
                std::ostringstream sentence;
                sentence << "The line " << name << " branches at (" << nodes[node].x() << ", "
                         << nodes[node].y() << ") m; a line must be one or more separate paths.";
                throw InputError(sentence.str());
              }
          }
      return at_node;
    }
  } // namespace


  std::vector<Edge> chain_edges(const std::vector<Edge> &edges,
                                const std::vector<Vec2> &nodes,
                                const std::string       &name)
  {
    const auto at_node = edges_at_nodes(edges, nodes, name);

    // ends of open paths first, then any node (closed paths); each from left to right
    std::vector<int> starts;
    for (const auto &[node, list] : at_node)
      starts.push_back(node);
    std::sort(starts.begin(), starts.end(), [&](const int a, const int b) {
      return std::make_pair(nodes[a].x(), nodes[a].y()) <
             std::make_pair(nodes[b].x(), nodes[b].y());
    });
    std::stable_partition(starts.begin(), starts.end(), [&](const int node) {
      return at_node.at(node).size() == 1;
    });

    std::vector<bool> used(edges.size(), false);
    std::vector<Edge> chained;
    for (const int start : starts)
      for (int node = start, next = -1;; node = next)
        {
          next = -1;
          for (const int e : at_node.at(node))
            if (!used[e] && next < 0)
              {
                used[e] = true;
                next    = edges[e][0] == node ? edges[e][1] : edges[e][0];
              }
          if (next < 0)
            break;
          chained.push_back({node, next});
        }
    return chained;
  }
} // namespace hybrid::scene
