// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/cavern_check.h>
#include <hybrid/scene/checks/geometry_check.h>
#include <hybrid/scene/checks/mesh_check.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/joint_lines.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    using Edge = SectionMesh::Edge;

    /// Number of bedrock cells at each edge (nodes in ascending order).
    using EdgeCount = std::map<Edge, int>;


    std::string at(const Vec2 &x)
    {
      std::ostringstream text;
      text << "(" << x.x() << ", " << x.y() << ") m";
      return text.str();
    }


    Edge sorted(const Edge &edge)
    {
      return {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])};
    }


    Vec2 middle(const SectionMesh &mesh, const Edge &edge)
    {
      return 0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]]);
    }


    void require_line(const SectionMesh &mesh, const std::string &name, const std::string &why)
    {
      if (mesh.lines.count(name) == 0 || mesh.lines.at(name).empty())
        throw InputError("The mesh has no curve group '" + name + "', which " + why + " needs.");
    }


    /// The bedrock is made of the mesh's cells.
    bool needs_bedrock_cells(const SceneParameters &scene)
    {
      return scene.bedrock.has_cells();
    }


    void check_groups(const SectionMesh &mesh, const SceneParameters &scene)
    {
      const bool        has_cells = needs_bedrock_cells(scene);
      const std::string why =
        scene.has_bedrock_blocks() ? "a bedrock of blocks" : "the elastic continuum";
      if (has_cells)
        {
          if (mesh.bedrock_cells.empty())
            throw InputError("The mesh has no surface group 'bedrock' (or it is empty), which " +
                             why + " needs.");
          for (const char *const name : {"base", "left", "right"})
            require_line(mesh, name, why);
          for (const std::string &name : scene.bedding.names)
            require_line(mesh, name, "the section Bedding planes");
        }
      if (scene.blocks.enabled && mesh.blocks.empty())
        throw InputError(
          "The mesh has no surface group 'sliding_mass' (or it is empty), which blocks need.");
      if (has_cells && scene.blocks.enabled)
        require_line(mesh,
                     "sliding_surface",
                     scene.has_bedrock_blocks() ? "a sliding mass on " + why
                                                : "blocks on a continuum");
    }


    /// Every corner of a quadrilateral must turn left: then its mapping is invertible.
    void check_cells(const SectionMesh &mesh)
    {
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          {
            const Vec2  &x        = mesh.nodes[cell[i]];
            const Vec2   next     = mesh.nodes[cell[(i + 1) % 4]] - x;
            const Vec2   last     = mesh.nodes[cell[(i + 3) % 4]] - x;
            const double jacobian = cross(next, last);
            if (!(jacobian > 1e-6 * next.norm() * last.norm()))
              throw InputError("The bedrock cell at " + at(x) +
                               " is inverted or has no area: its corner there must be convex.");
          }
    }


    void check_blocks(const SectionMesh &mesh)
    {
      for (const auto &block : mesh.blocks)
        {
          const Vec2 &x0   = mesh.nodes[block[0]];
          double      area = 0., size2 = 0.;
          for (std::size_t i = 0; i < block.size(); ++i)
            {
              const Vec2 a = mesh.nodes[block[i]] - x0;
              area += 0.5 * cross(a, mesh.nodes[block[(i + 1) % block.size()]] - x0);
              size2 = std::max(size2, a.squaredNorm());
            }
          if (!(area > 1e-9 * size2))
            throw InputError("The block at " + at(x0) + " is inverted or has no area.");
        }
    }


    EdgeCount bedrock_edges(const SectionMesh &mesh)
    {
      EdgeCount count;
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          ++count[sorted({cell[i], cell[(i + 1) % 4]})];
      for (const auto &[edge, cells] : count)
        if (cells > 2)
          throw InputError("More than two bedrock cells meet at the edge at " +
                           at(middle(mesh, edge)) + ".");
      return count;
    }


    /// Edges of line @p name must have @p cells bedrock cells; @p where says that in words.
    void check_line(const SectionMesh &mesh,
                    const EdgeCount   &count,
                    const std::string &name,
                    const int          cells,
                    const std::string &where)
    {
      for (const Edge &edge : mesh.lines.at(name))
        {
          const auto found = count.find(sorted(edge));
          if (found == count.end() || found->second != cells)
            throw InputError("The line " + name + " at " + at(middle(mesh, edge)) +
                             " must run along cell edges " + where + " of the bedrock" +
                             (cells == 2 ? "; gmsh keeps no line within a recombined surface, so "
                                           "divide the surface along it, a Plane Surface on "
                                           "either side."
                                         : "."));
        }
    }


    void check_bedrock_lines(const SectionMesh &mesh, const SceneParameters &scene)
    {
      const EdgeCount             count = bedrock_edges(mesh);
      std::map<Edge, std::string> line_of_edge;
      for (const auto &[name, edges] : mesh.lines)
        {
          if (name.rfind("bedding_", 0) == 0)
            check_line(mesh, count, name, 2, "inside");
          else if (name != "mass_surface" && !is_joint_line(name))
            {
              check_line(mesh, count, name, 1, "on the boundary");
              for (const Edge &edge : edges)
                if (!line_of_edge.emplace(sorted(edge), name).second)
                  throw InputError("The boundary edge of the bedrock at " + at(middle(mesh, edge)) +
                                   " is on two lines, " + line_of_edge.at(sorted(edge)) + " and " +
                                   name + ".");
            }
        }
      check_caverns(mesh, scene);

      for (const auto &[edge, cells] : count)
        if (cells == 1 && line_of_edge.count(edge) == 0)
          throw InputError("The boundary edge of the bedrock at " + at(middle(mesh, edge)) +
                           " is on none of the lines base, left, right, ground, sliding_surface.");
    }


    /// Which way the bedrock is bounded by a line, on the whole.
    struct Side
    {
      const char *name;
      int         axis;    ///< 0: x, 1: y
      double      outward; ///< sign of the outward normal there
      const char *words;
    };

    constexpr Side sides[] = {{"base", 1, -1., "below"},
                              {"left", 0, -1., "on the left"},
                              {"right", 0, 1., "on the right"}};

    /// base, left and right must be where their names say.
    void check_sides(const SectionMesh &mesh)
    {
      std::map<Edge, Vec2> normal; // outward, of boundary edges, times their length
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          {
            const int  a = cell[i], b = cell[(i + 1) % 4];
            const Vec2 along       = mesh.nodes[b] - mesh.nodes[a];
            normal[sorted({a, b})] = Vec2(along.y(), -along.x());
          }
      for (const Side &side : sides)
        {
          Vec2        sum = Vec2::Zero(), centre = Vec2::Zero();
          const auto &edges = mesh.lines.at(side.name);
          for (const Edge &edge : edges)
            {
              sum += normal.at(sorted(edge));
              centre += middle(mesh, edge) / double(edges.size());
            }
          if (!(sum[side.axis] * side.outward >= std::abs(sum[1 - side.axis])))
            throw InputError("The line " + std::string(side.name) + ", centred at " + at(centre) +
                             ", does not bound the bedrock " + side.words +
                             ": look whether two lines are interchanged.");
        }
    }


    /// A region or line that only a parameter knows is misspelt.
    void check_names(const std::string              &what,
                     const std::vector<std::string> &known,
                     const RegionMaterials          &materials,
                     const std::string              &parameter)
    {
      std::string list;
      for (const std::string &name : known)
        list += (list.empty() ? "" : ", ") + name;
      for (const std::string &name : materials.regions())
        if (std::count(known.begin(), known.end(), name) == 0)
          throw InputError(parameter + ": the mesh has no " + what + " '" + name + "'; it has " +
                           (list.empty() ? "none" : list) + ".");
    }


    void check_regions_of_mass(const SectionMesh &mesh, const SceneParameters &scene)
    {
      const auto &known = mesh.block_region_names;
      check_names("region", known, scene.blocks.material, "Blocks/Material");
      check_names("region", known, scene.blocks.saturated_material, "Blocks/Saturated material");
    }


    /// Joints of the mass: edges of blocks, each on one line.
    void check_joint_lines(const SectionMesh &mesh, const SceneParameters &scene)
    {
      std::set<Edge> of_blocks;
      for (const auto &block : mesh.blocks)
        for (std::size_t k = 0; k < block.size(); ++k)
          of_blocks.insert(sorted({block[k], block[(k + 1) % block.size()]}));
      std::vector<std::string> known;
      for (const auto &[name, edges] : mesh.lines)
        {
          if (!is_joint_line(name))
            continue;
          known.push_back(name);
          for (const Edge &edge : edges)
            if (of_blocks.count(sorted(edge)) == 0)
              throw InputError("The line " + name + " at " + at(middle(mesh, edge)) +
                               " must run along edges of blocks of the sliding mass; within a "
                               "surface of gmsh that needs Curve{...} In Surface{...}.");
        }
      const JointLines each_edge_once(mesh);
      check_names("line", known, scene.blocks.joint_materials, "Blocks/Joint materials");
      check_names("line",
                  known,
                  scene.blocks.saturated_joint_materials,
                  "Blocks/Saturated joint materials");
      if (known.empty() && !scene.blocks.joint_materials.empty())
        throw InputError("Blocks/Joint materials: the mesh has no line joint_<suffix>.");
    }


    /// A bedrock node and another node of a block at the same place: the mesher did not join the
    /// two.
    void check_shared_nodes(const SectionMesh &mesh)
    {
      const auto surface = mesh.lines.find("sliding_surface");
      if (surface == mesh.lines.end())
        return;
      std::map<std::pair<double, double>, int> node_at;
      for (const Edge &edge : surface->second)
        for (const int node : edge)
          node_at[{mesh.nodes[node].x(), mesh.nodes[node].y()}] = node;
      for (const auto &block : mesh.blocks)
        for (const int node : block)
          {
            const Vec2 &x     = mesh.nodes[node];
            const auto  found = node_at.find({x.x(), x.y()});
            if (found != node_at.end() && found->second != node)
              throw InputError(
                "Bedrock and sliding mass have separate nodes on the sliding surface at " + at(x) +
                "; both surfaces must be bounded by the same curve.");
          }
    }
  } // namespace


  void check_section_mesh(const SectionMesh &mesh, const SceneParameters &scene)
  {
    check_groups(mesh, scene);
    check_blocks(mesh);
    if (scene.blocks.enabled)
      {
        check_regions_of_mass(mesh, scene);
        check_joint_lines(mesh, scene);
      }
    if (needs_bedrock_cells(scene))
      {
        check_cells(mesh);
        check_bedrock_lines(mesh, scene);
        if (scene.environment.gravity > 0.) // without it a column may lie on its side
          check_sides(mesh);
        check_names("region",
                    mesh.bedrock_region_names,
                    scene.continuum.region_material,
                    "Continuum/Materials");
        if (scene.mesh.polygons_file.empty())
          check_shared_nodes(mesh);
      }
    check_geometry(mesh, scene);
  }
} // namespace hybrid::scene
