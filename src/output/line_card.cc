// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>
#include <hybrid/output/line_card.h>
#include <hybrid/scene/mesh/block_edges.h>
#include <hybrid/scene/mesh/joint_lines.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
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


    /// "clay (phi 12 deg, c 0 Pa, tensile strength 0 Pa)"
    std::string with_strength(const Material &m)
    {
      return m.name + formatted(" (phi %g deg, c %g Pa, tensile strength %g Pa)",
                                m.friction_angle,
                                m.cohesion,
                                m.tensile_strength);
    }


    /// After slip [deg].
    double residual_angle(const Material &material)
    {
      return material.residual_friction_angle < 0. ? material.friction_angle
                                                   : material.residual_friction_angle;
    }


    /// Of contacts, which have what is left after slip: "clay (phi 12 deg, no cohesion)"
    std::string with_friction(const Material &m)
    {
      return m.name + formatted(" (phi %g deg, ", residual_angle(m)) +
             (m.residual_cohesion > 0. ? formatted("c %g Pa while pressed)", m.residual_cohesion)
                                       : "no cohesion)");
    }


    std::string role_of_joints(const std::string &line, const SceneParameters &scene)
    {
      const scene::BlockParameters &blocks = scene.blocks;
      if (!blocks.enabled)
        return "not used, as there are no blocks";
      const Material *dry = scene.joint_material(line, false);
      if (dry == nullptr)
        return "like all other edges of blocks, as Blocks/Joint materials does not list it";
      const Material &wet      = *scene.joint_material(line, true);
      const auto      in_words = [&blocks](const Material &m) {
        return blocks.bonded ? with_strength(m) : with_friction(m);
      };
      return (blocks.bonded ? "joints of " : "contacts of ") + in_words(*dry) +
             (scene.environment.has_water() && &wet != dry ? ", below the water of " + in_words(wet)
                                                           : "");
    }


    /// " (rock: 30 deg)"
    std::string with_angle(const std::string &name, const Material &material)
    {
      return " (" + name + formatted(": %g deg)", residual_angle(material));
    }


    /// A belt has other friction than a contact of blocks of the material, or has cohesion besides.
    bool differs(const Material &belt, const Material &blocks)
    {
      const double cohesion = belt.residual_cohesion < 0. ? belt.cohesion : belt.residual_cohesion;
      return residual_angle(belt) != residual_angle(blocks) || cohesion > 0.;
    }


    /// What holds a block that has left the part of the surface that a belt bonded, where it is not
    /// what the belt has after slip; else nothing.
    std::string off_the_belt(const SceneParameters &scene)
    {
      const scene::BlockParameters &blocks  = scene.blocks;
      bool                          is_said = false;
      double                        largest = 0.; // [deg]
      std::string words = "; blocks that have slid beyond the bonded part have the friction of "
                          "Blocks/Material";
      for (const std::string &name : blocks.material.names())
        {
          const Material &dry = scene.material(name, "Blocks/Material");
          is_said             = is_said || differs(scene.belt_material(false), dry);
          largest             = std::max(largest, residual_angle(dry));
          words += with_angle(name, dry);
        }
      if (scene.environment.has_water())
        {
          std::string below;
          for (const std::string &name : blocks.saturated_material.names())
            below += with_angle(name, scene.material(name, "Blocks/Saturated material"));
          for (const std::string &name : scene.mass_materials())
            is_said = is_said || differs(scene.belt_material(true),
                                         scene.material(name, "Blocks/Saturated material"));
          if (!below.empty())
            words += ", below the water of" + below;
        }
      std::string of_ground;
      for (const std::string &name : scene.continuum.region_material.names())
        {
          const Material   &ground      = scene.material(name, "Continuum/Materials");
          const std::string words_of_it = with_angle(name, ground);
          if (has_cells(scene) && ground.friction_is_given() && residual_angle(ground) < largest &&
              of_ground.find(words_of_it) == std::string::npos)
            of_ground += words_of_it;
        }
      if (!of_ground.empty())
        words += ", or of the ground where that is less" + of_ground;
      return is_said ? words : "";
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
      if (scene::is_joint_line(name))
        return role_of_joints(name, scene);
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


    /// " (8 of its 10 edges)" of a line that blocks share in part, else nothing.
    std::string shared_part(const std::set<std::pair<int, int>>  &of_blocks,
                            const std::vector<SectionMesh::Edge> &line)
    {
      const auto shared =
        std::count_if(line.begin(), line.end(), [&](const SectionMesh::Edge &edge) {
          return of_blocks.count(std::minmax(edge[0], edge[1])) > 0;
        });
      if (static_cast<std::size_t>(shared) == line.size())
        return "";
      return " (" + std::to_string(shared) + " of its " + std::to_string(line.size()) + " edges)";
    }


    /// Edges of blocks that lie on an edge of another one, but with nodes of their own.
    Row cut_edges(const SectionMesh &mesh, const std::set<std::pair<int, int>> &of_blocks)
    {
      using Place = std::tuple<double, double, double, double>;
      std::map<Place, int> count;
      Row                  row{"", "", 0.};
      int                  n_edges = 0;
      for (const auto &[a, b] : of_blocks)
        {
          const Vec2 &x = mesh.nodes[a], &y = mesh.nodes[b];
          const bool  in_order = std::make_pair(x.x(), x.y()) < std::make_pair(y.x(), y.y());
          const Vec2 &first = in_order ? x : y, &last = in_order ? y : x;
          if (++count[{first.x(), first.y(), last.x(), last.y()}] != 2)
            continue;
          ++n_edges;
          row.length += (y - x).norm();
        }
      row.names = "between blocks";
      row.role  = "cut: " + std::to_string(n_edges) + (n_edges == 1 ? " edge has" : " edges have") +
                 " two nodes in one place at both ends, so nothing bonds them";
      return row;
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
    const bool is_bonded = scene.blocks.enabled && scene.blocks.bonded;
    const auto of_blocks =
      is_bonded ? scene::edges_of_blocks(mesh) : std::set<std::pair<int, int>>();
    std::vector<Row> rows;
    for (const auto &[name, edges] : mesh.lines)
      {
        std::string role = role_of(name, scene);
        if (is_bonded && name == "sliding_surface" && !scene.blocks.belt_material.empty())
          role += shared_part(of_blocks, edges) + off_the_belt(scene);
        const double length = length_of(mesh, edges);
        const auto   same =
          std::find_if(rows.begin(), rows.end(), [&](const Row &row) { return row.role == role; });
        if (same == rows.end())
          rows.push_back({name, role, length});
        else
          {
            same->names += ", " + name;
            same->length += length;
          }
      }
    if (const Row cut = cut_edges(mesh, of_blocks); cut.length > 0.)
      rows.push_back(cut);
    std::string text = rows.empty() ? "" : "Lines of the mesh";
    for (const Row &row : rows)
      {
        const std::string length = formatted("%.4g m  ", row.length);
        const std::string space(row.names.size() < 18 ? 18 - row.names.size() : 0, ' ');
        text += "\n  " + row.names + space + " " + length + row.role;
      }
    return text;
  }
} // namespace hybrid::output
