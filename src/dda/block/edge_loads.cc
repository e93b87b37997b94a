// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/edge_loads.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <set>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    using Pair = std::pair<int, int>;

    bool is_in(const scene::EdgeTraction &load, const Vec2 &x)
    {
      return (x.array() >= load.lower.array()).all() && (x.array() <= load.upper.array()).all();
    }


    /// Edges of blocks as they run round them, and both ways those of the sliding surface.
    std::set<Pair> directed_edges(const scene::SectionMesh            &mesh,
                                  const std::vector<std::vector<int>> &outlines)
    {
      std::set<Pair> edges;
      for (const auto &nodes : outlines)
        for (std::size_t k = 0; k < nodes.size(); ++k)
          edges.insert({nodes[k], nodes[(k + 1) % nodes.size()]});
      const auto surface = mesh.lines.find("sliding_surface");
      if (surface != mesh.lines.end())
        for (const auto &edge : surface->second)
          {
            edges.insert({edge[0], edge[1]});
            edges.insert({edge[1], edge[0]});
          }
      return edges;
    }
  } // namespace



  double EdgeLoads::factor(const double time) const
  {
    if (time <= start)
      return 0.;
    return time >= start + rise_time ? 1. : (time - start) / rise_time;
  }



  EdgeLoads find_edge_loads(const scene::SectionMesh            &mesh,
                            const scene::EdgeLoadParameters     &parameters,
                            const std::vector<std::vector<int>> &outlines,
                            const Geometry                      &geometry)
  {
    EdgeLoads loads{{}, parameters.start, parameters.rise_time};
    if (parameters.tractions.empty())
      return loads;
    const std::set<Pair> edges = directed_edges(mesh, outlines);
    for (const scene::EdgeTraction &load : parameters.tractions)
      {
        const std::size_t before = loads.edges.size();
        for (std::size_t b = 0; b < outlines.size(); ++b)
          for (std::size_t k = 0; k < outlines[b].size(); ++k)
            {
              const int   from = outlines[b][k], to = outlines[b][(k + 1) % outlines[b].size()];
              const Vec2 &first = mesh.nodes[from], &second = mesh.nodes[to];
              if (is_in(load, first) && is_in(load, second) && edges.count({to, from}) == 0)
                loads.edges.push_back({static_cast<int>(b),
                                       geometry.offset[b] + static_cast<int>(k),
                                       (second - first).norm() * load.traction});
            }
        if (loads.edges.size() == before)
          throw InputError("Edge loads/Tractions: no free edge of a block lies in the box of '" +
                           load.name + "'");
      }
    return loads;
  }



  Vec6 edge_force(const EdgeLoads::Edge &edge,
                  const Geometry        &geometry,
                  const Vec2            *displacements,
                  const BlockMotion     &motion)
  {
    const int a = edge.vertex, b = geometry.next(a);
    Vec2      middle = 0.5 * (geometry.vertices[a] + geometry.vertices[b]);
    if (displacements != nullptr)
      middle += 0.5 * (displacements[a] + displacements[b]);
    return motion.gradient(middle, edge.force);
  }
} // namespace hybrid::dda
