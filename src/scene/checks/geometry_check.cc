// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/geometry_check.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/unit_check.h>
#include <hybrid/scene/parameters/parameter_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    using Outline = std::vector<Vec2>;
    using Edge    = SectionMesh::Edge;

    constexpr double allowed_depth = 1e-3; // overlap over block size that rounding explains


    std::string at(const Vec2 &x)
    {
      std::ostringstream text;
      text << "(" << x.x() << ", " << x.y() << ") m";
      return text.str();
    }


    /// An outline with what the search for overlaps asks again and again.
    struct Shape
    {
      Outline outline;
      Vec2    low, high; ///< bounding box [m]
      double  size;      ///< square root of the area [m]
      bool    is_convex;
      bool    is_cell; ///< of the bedrock
      Vec2    centre;  ///< mean of the vertices [m]
    };


    Shape make_shape(const SectionMesh &mesh, const std::vector<int> &nodes, const bool is_cell)
    {
      Shape shape;
      for (const int node : nodes)
        shape.outline.push_back(mesh.nodes[node]);
      const Outline    &v = shape.outline;
      const std::size_t n = v.size();
      shape.low = shape.high = v[0];
      shape.centre           = Vec2::Zero();
      shape.is_convex        = true;
      shape.is_cell          = is_cell;
      double area            = 0.;
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vec2 &a = v[i], &b = v[(i + 1) % n], &c = v[(i + 2) % n];
          shape.low  = shape.low.cwiseMin(a);
          shape.high = shape.high.cwiseMax(a);
          shape.centre += a / double(n);
          area += 0.5 * cross(a - v[0], b - v[0]);
          if (cross(b - a, c - b) < 0.)
            shape.is_convex = false;
        }
      shape.size = std::sqrt(std::max(area, 0.));
      return shape;
    }


    /// @return whether an edge of convex @p a has all of @p b on its outer side, but for @p depth.
    bool is_separated_by_edge(const Shape &a, const Shape &b, const double depth)
    {
      const std::size_t n = a.outline.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vec2 &from = a.outline[i];
          const Vec2  edge = (a.outline[(i + 1) % n] - from).normalized();
          if (std::all_of(b.outline.begin(), b.outline.end(), [&](const Vec2 &x) {
                return cross(edge, x - from) <= depth; // left of the edge is inside
              }))
            return true;
        }
      return false;
    }


    double distance(const Vec2 &x, const Vec2 &a, const Vec2 &b)
    {
      const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
      return (x - a - t * (b - a)).norm();
    }


    /// @return whether @p x lies in @p shape, at least @p depth from its outline.
    bool is_inside(const Vec2 &x, const Shape &shape, const double depth)
    {
      bool              inside = false;
      const std::size_t n      = shape.outline.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vec2 &a = shape.outline[i], &b = shape.outline[(i + 1) % n];
          if (distance(x, a, b) < depth)
            return false;
          if ((a.y() > x.y()) != (b.y() > x.y()) && (cross(b - a, x - a) > 0.) == (b.y() > a.y()))
            inside = !inside;
        }
      return inside;
    }


    /// Points that tell whether @p a enters @p b: the middle of every piece into which b's outline
    /// cuts the edges of a.
    Outline pieces(const Shape &a, const Shape &b)
    {
      Outline           result;
      const std::size_t n = a.outline.size(), m = b.outline.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vec2         &p = a.outline[i];
          const Vec2          d = a.outline[(i + 1) % n] - p;
          std::vector<double> cuts{0., 1.};
          for (std::size_t j = 0; j < m; ++j)
            {
              const Vec2  &q     = b.outline[j];
              const Vec2   e     = b.outline[(j + 1) % m] - q;
              const double turn  = cross(d, e);
              const double place = cross(q - p, e) / turn;
              if (turn != 0. && place > 0. && place < 1.)
                cuts.push_back(place);
            }
          std::sort(cuts.begin(), cuts.end());
          for (std::size_t k = 1; k < cuts.size(); ++k)
            result.push_back(p + 0.5 * (cuts[k - 1] + cuts[k]) * d);
        }
      return result;
    }


    /// @return whether two outlines have more than a rim of @p depth in common.
    bool overlap(const Shape &a, const Shape &b, const double depth)
    {
      if ((a.is_convex && is_separated_by_edge(a, b, depth)) ||
          (b.is_convex && is_separated_by_edge(b, a, depth)))
        return false;
      if (a.is_convex && b.is_convex)
        return true;
      for (const Vec2 &x : pieces(a, b))
        if (is_inside(x, b, depth))
          return true;
      for (const Vec2 &x : pieces(b, a))
        if (is_inside(x, a, depth))
          return true;
      return (a.centre - b.centre).norm() < depth && std::abs(a.size - b.size) < depth; // the same
    }


    /// Throw for the first two shapes that overlap: blocks, or a block and a cell of the bedrock.
    void check_overlaps(const SectionMesh &mesh, const bool has_cells)
    {
      std::vector<Shape> shapes;
      for (const auto &block : mesh.blocks)
        shapes.push_back(make_shape(mesh, block, false));
      if (has_cells)
        for (const auto &cell : mesh.bedrock_cells)
          shapes.push_back(make_shape(mesh, {cell.begin(), cell.end()}, true));
      std::sort(shapes.begin(), shapes.end(), [](const Shape &a, const Shape &b) {
        return a.low.x() < b.low.x();
      });

      std::vector<const Shape *> open; // whose x range the sweep is in
      for (const Shape &shape : shapes)
        {
          open.erase(std::remove_if(open.begin(),
                                    open.end(),
                                    [&](const Shape *s) { return s->high.x() <= shape.low.x(); }),
                     open.end());
          for (const Shape *other : open)
            if (!(shape.is_cell && other->is_cell) && other->high.y() > shape.low.y() &&
                other->low.y() < shape.high.y() &&
                overlap(shape, *other, allowed_depth * std::min(shape.size, other->size)))
              {
                const Shape &block = shape.is_cell ? *other : shape;
                const Shape &rest  = shape.is_cell ? shape : *other;
                throw InputError("The block at " + at(block.centre) +
                                 (rest.is_cell ? " lies inside the bedrock, in its cell at "
                                               : " overlaps the block at ") +
                                 at(rest.centre) + ".");
              }
          open.push_back(&shape);
        }
    }


    /// The base must be one polyline: blocks would fall through a gap.
    void check_base_is_one(const SectionMesh &mesh, const std::vector<Edge> &base)
    {
      std::map<int, int> ends; // node -> edges there
      for (const Edge &edge : base)
        for (const int node : edge)
          ++ends[node];
      std::vector<Vec2> open;
      for (const auto &[node, edges] : ends)
        if (edges == 1)
          open.push_back(mesh.nodes[node]);
      if (open.size() <= 2)
        return;
      std::sort(open.begin(), open.end(), [](const Vec2 &a, const Vec2 &b) {
        return a.x() < b.x();
      });
      throw InputError("The base has a gap between " + at(open[1]) + " and " + at(open[2]) +
                       ": sliding_surface and ground must be one polyline.");
    }


    /// Under an edge of the base, and on none: the foot of a vertical wall is under the end of its
    /// upper edge.
    bool is_below(const Vec2              &x,
                  const SectionMesh       &mesh,
                  const std::vector<Edge> &base,
                  const double             depth)
    {
      bool below = false;
      for (const Edge &edge : base)
        {
          const Vec2 &a = mesh.nodes[edge[0]], &b = mesh.nodes[edge[1]];
          if (distance(x, a, b) <= depth)
            return false;
          if (x.x() > a.x() && x.x() <= b.x())
            below = below || x.y() < a.y() + (x.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        }
      return below;
    }



    /// Blocks must not lie under the polyline of a rigid base.
    void check_rigid_base(const SectionMesh &mesh)
    {
      std::vector<Edge> base;
      for (const char *const name : {"sliding_surface", "ground"})
        if (mesh.lines.count(name) > 0)
          base.insert(base.end(), mesh.lines.at(name).begin(), mesh.lines.at(name).end());
      check_base_is_one(mesh, base);
      for (const auto &nodes : mesh.blocks)
        {
          const Shape  block = make_shape(mesh, nodes, false);
          const double depth = allowed_depth * block.size;
          for (const Edge &edge : base)
            {
              const Vec2 &a = mesh.nodes[edge[0]], &b = mesh.nodes[edge[1]];
              for (const Vec2 &x : {a, b})
                if (is_inside(x, block, depth))
                  throw InputError("The block at " + at(block.centre) +
                                   " has the point of the base at " + at(x) + " inside.");
            }
          for (const Vec2 &x : block.outline)
            if (is_below(x, mesh, base, depth))
              throw InputError("The block at " + at(block.centre) + " has its vertex " + at(x) +
                               " below the base.");
        }
    }


    /// The bedrock must be one piece: cells hang together by edges.
    void check_connected(const SectionMesh &mesh)
    {
      const int        n = mesh.bedrock_cells.size();
      std::vector<int> parent(n);
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&](int c) {
        while (parent[c] != c)
          c = parent[c] = parent[parent[c]];
        return c;
      };
      std::map<Edge, int> cell_at;
      for (int c = 0; c < n; ++c)
        for (int i = 0; i < 4; ++i)
          {
            const int a = mesh.bedrock_cells[c][i], b = mesh.bedrock_cells[c][(i + 1) % 4];
            const auto [found, is_new] = cell_at.emplace(Edge{std::min(a, b), std::max(a, b)}, c);
            if (!is_new)
              parent[root(c)] = root(found->second);
          }
      for (int c = 1; c < n; ++c)
        if (root(c) != root(0))
          throw InputError("The bedrock is not one piece: its cells at " +
                           at(mesh.nodes[mesh.bedrock_cells[0][0]]) + " and " +
                           at(mesh.nodes[mesh.bedrock_cells[c][0]]) +
                           " are not connected by cells with common edges.");
    }


    /// Two bedding planes may meet at the end of one of them but not cross.
    void check_bedding_planes(const SectionMesh &mesh)
    {
      std::map<int, std::pair<std::string, int>> first; // node -> plane, its edges there
      for (const auto &[name, edges] : mesh.lines)
        {
          if (name.rfind("bedding_", 0) != 0)
            continue;
          std::map<int, int> count;
          for (const Edge &edge : edges)
            for (const int node : edge)
              ++count[node];
          for (const auto &[node, number] : count)
            {
              const auto [found, is_new] = first.emplace(node, std::make_pair(name, number));
              if (!is_new && number > 1 && found->second.second > 1)
                throw InputError("The bedding planes " + found->second.first + " and " + name +
                                 " cross at " + at(mesh.nodes[node]) +
                                 "; a plane may end on another but not go through it.");
            }
        }
    }


    /// Along the sliding surface every edge of a meshed mass must have its block.
    void check_gaps(const SectionMesh &mesh)
    {
      const auto surface = mesh.lines.find("sliding_surface");
      if (surface == mesh.lines.end() || mesh.blocks.empty())
        return;
      std::map<Edge, int> block_edges;
      for (const auto &block : mesh.blocks)
        for (std::size_t i = 0; i < block.size(); ++i)
          {
            const int a = block[i], b = block[(i + 1) % block.size()];
            ++block_edges[{std::min(a, b), std::max(a, b)}];
          }
      for (const Edge &edge : surface->second)
        if (block_edges.count({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}) == 0)
          throw InputError("There is a gap above the sliding surface at " +
                           at(0.5 * (mesh.nodes[edge[0]] + mesh.nodes[edge[1]])) +
                           ": no block has this edge; where the bedrock is bare it belongs to the "
                           "line ground.");
    }
    /// The wave enters all of a compliant base at the same instant, which only suits one that is
    /// level, or upright below a bar that lies.
    void check_level_base(const SectionMesh &mesh, const SceneParameters &scene)
    {
      constexpr double level = 1e-3; // smaller over larger extent
      const auto       base  = mesh.lines.find("base");
      if (base == mesh.lines.end() || base->second.empty() || scene.motion.type == "none" ||
          !scene.continuum.base.is_compliant || !scene.continuum.base.takes_motion)
        return;
      Vec2 lower = mesh.nodes[base->second.front()[0]], upper = lower;
      for (const Edge &edge : base->second)
        for (const int node : edge)
          {
            lower = lower.cwiseMin(mesh.nodes[node]);
            upper = upper.cwiseMax(mesh.nodes[node]);
          }
      const Vec2 extent = upper - lower;
      if (extent.minCoeff() > level * extent.maxCoeff())
        throw InputError(
          "Continuum/Base = compliant needs a level base, as the wave enters all of it "
          "at the same instant; this one lies between y = " +
          number_text(lower.y()) + " and " + number_text(upper.y()) +
          " m. Draw it level (the rock may be layered as it likes above), or set "
          "Continuum/Base = rigid.");
    }
  } // namespace


  void check_geometry(const SectionMesh &mesh, const SceneParameters &scene)
  {
    check_unit(mesh, scene);
    const bool has_cells = scene.bedrock.has_cells();
    if (has_cells)
      {
        check_connected(mesh);
        check_bedding_planes(mesh);
        check_level_base(mesh, scene);
      }
    if (!scene.blocks.enabled)
      return;
    if (has_cells && scene.mesh.polygons_file.empty())
      check_gaps(mesh);
    check_overlaps(mesh, has_cells);
    if (!has_cells)
      check_rigid_base(mesh);
  }
} // namespace hybrid::scene
