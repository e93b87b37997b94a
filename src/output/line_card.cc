// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/line_card.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace hybrid::output
{
  namespace
  {
    using scene::SceneParameters;
    using scene::SectionMesh;

    /// Lines that are the same.
    struct Row
    {
      std::string names;
      std::string role;
      double      length; ///< [m]
    };


    bool has_cells(const SceneParameters &scene)
    {
      return scene.bedrock.has_cells();
    }


    std::string role_of_plane(const std::string &name, const SceneParameters &scene)
    {
      const auto &names = scene.bedding.names;
      if (std::count(names.begin(), names.end(), name) == 0)
        return "welded, as Bedding planes/Names does not list it";
      return scene.bedding.slips ? "joint that slips and opens (Mohr-Coulomb)" : "elastic joint";
    }


    std::string role_of_sliding_surface(const SceneParameters &scene)
    {
      const scene::BlockParameters &blocks = scene.blocks;
      if (!blocks.enabled)
        return "free surface, as there are no blocks";
      if (blocks.belt_material.empty())
        return "unbonded contact with friction, as Blocks/Belt material is not set";
      const bool has_wet_belt =
        scene.environment.has_water() && !blocks.saturated_belt_material.empty();
      return "bonded to blocks that share its edges, belt material " + blocks.belt_material +
             (has_wet_belt ? " (below the water " + blocks.saturated_belt_material + ")" : "");
    }


    std::string role_of_base(const SceneParameters &scene)
    {
      const scene::BaseBoundary &base        = scene.continuum.base;
      const std::string         &if_it_moves = scene.bedrock.base_words;
      return base.takes_motion && !if_it_moves.empty() ? if_it_moves : base.words;
    }


    std::string role_of(const std::string &name, const SceneParameters &scene)
    {
      if (name == "mass_surface")
        return "only drawn";
      if (name == "sliding_surface" && (scene.blocks.enabled || has_cells(scene)))
        return role_of_sliding_surface(scene);
      if (!has_cells(scene))
        return name == "ground" ? "surface of the rigid base" : "not used, as the bedrock is rigid";
      if (name == "base")
        return role_of_base(scene);
      if (name == "left" || name == "right")
        return "side: " + scene.continuum.sides.words;
      if (name == "ground")
        return "free surface of the bedrock";
      return role_of_plane(name, scene);
    }


    double length_of(const SectionMesh &mesh, const std::vector<SectionMesh::Edge> &edges)
    {
      double length = 0.;
      for (const auto &edge : edges)
        length += (mesh.nodes[edge[1]] - mesh.nodes[edge[0]]).norm();
      return length;
    }
  } // namespace



  std::string describe_lines(const SectionMesh &mesh, const SceneParameters &scene)
  {
    std::vector<Row> rows;
    for (const auto &[name, edges] : mesh.lines)
      {
        const std::string role   = role_of(name, scene);
        const double      length = length_of(mesh, edges);
        const auto        same =
          std::find_if(rows.begin(), rows.end(), [&](const Row &row) { return row.role == role; });
        if (same == rows.end())
          rows.push_back({name, role, length});
        else
          {
            same->names += ", " + name;
            same->length += length;
          }
      }
    std::string text = rows.empty() ? "" : "Lines of the mesh";
    for (const Row &row : rows)
      {
        char length[40];
        std::snprintf(length, sizeof(length), "%.4g m  ", row.length);
        const std::string space(row.names.size() < 18 ? 18 - row.names.size() : 0, ' ');
        text += "\n  " + row.names + space + " " + length + row.role;
      }
    return text;
  }
} // namespace hybrid::output
