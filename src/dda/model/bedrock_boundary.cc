// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/bedrock_boundary.h>

#include <algorithm>
#include <map>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    using Edge = std::pair<int, int>;

    Edge ordered(const int a, const int b)
    {
      return {std::min(a, b), std::max(a, b)};
    }
  } // namespace



  std::vector<BoundaryEdge> boundary_edges(const scene::SectionMesh     &mesh,
                                           const scene::SceneParameters &scene,
                                           const Geometry               &geometry,
                                           const JointedBlocks          &blocks)
  {
    std::map<Edge, BoundaryPart> part_of;
    for (const auto &[name, part] : {std::make_pair("left", BoundaryPart::left),
                                     std::make_pair("right", BoundaryPart::right),
                                     std::make_pair("base", BoundaryPart::base)})
      for (const auto &edge : mesh.lines.at(name))
        part_of[ordered(edge[0], edge[1])] = part;
    const bool                 compliant  = scene.has_compliant_base();
    const std::string         &half_space = scene.continuum.half_space_material;
    const scene::SideBoundary &sides      = scene.continuum.sides;

    std::vector<BoundaryEdge> edges;
    for (std::size_t b = blocks.n_mass; b < blocks.outlines.size(); ++b)
      for (std::size_t k = 0; k < blocks.outlines[b].size(); ++k)
        {
          const auto &nodes = blocks.outlines[b];
          const int   from = nodes[k], to = nodes[(k + 1) % nodes.size()];
          const auto  found = part_of.find(ordered(from, to));
          if (found == part_of.end() || (found->second == BoundaryPart::base && !compliant))
            continue;
          const bool      is_base = found->second == BoundaryPart::base;
          const Material &m       = blocks.materials[b];
          const Material &beyond  = is_base && !half_space.empty()
                                      ? scene.material(half_space, "Continuum/Half space material")
                                      : m;
          const double    normal  = is_base ? 1. : sides.normal_dashpots;
          const double    shear   = is_base ? 1. : sides.shear_dashpots;
          edges.push_back({found->second,
                           static_cast<int>(b),
                           geometry.offset[b] + static_cast<int>(k),
                           {mesh.nodes[from], mesh.nodes[to]},
                           m.density,
                           m.lame_lambda(),
                           m.shear_modulus(),
                           normal * beyond.density * beyond.p_wave_speed(),
                           shear * beyond.density * beyond.s_wave_speed()});
        }
    return edges;
  }
} // namespace hybrid::dda
