// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/cell_grid.h>
#include <hybrid/dda/geometry/overlap.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/geometry/surface_line.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hybrid::dda
{
  namespace
  {
    /// The foundation's line, as seen from below.
    class GroundLine
    {
    public:
      /// @param nodes at least two
      explicit GroundLine(const std::vector<Vec2> &nodes)
        : line(nodes, false)
        , points(nodes)
      {
        left  = points[0].x();
        right = left;
        for (const Vec2 &p : points)
          {
            left  = std::min(left, p.x());
            right = std::max(right, p.x());
          }
        columns.resize(points.size());
        for (int k = 0; k + 1 < static_cast<int>(points.size()); ++k)
          {
            const auto [a, b] =
              std::minmax({column_of(points[k].x()), column_of(points[k + 1].x())});
            for (int c = a; c <= b; ++c)
              columns[c].push_back(k);
          }
      }

      /// The line is crossed an odd number of times on the way up from @p place, first nearer than
      /// the line's ends are: below these nothing is, and what has fallen beside one may drift
      /// under it.
      bool is_above(const Vec2 &place) const
      {
        const double to_end = std::min(place.x() - left, right - place.x());
        if (!(to_end >= 0.))
          return false;
        bool   crossed = false;
        double nearest = std::numeric_limits<double>::infinity(); // crossing [m]
        for (const int k : columns[column_of(place.x())])
          {
            const Vec2 &a = points[k], &b = points[k + 1];
            if ((a.x() > place.x()) == (b.x() > place.x()))
              continue;
            const double t      = (place.x() - a.x()) / (b.x() - a.x());
            const double height = a.y() + t * (b.y() - a.y()) - place.y();
            if (height > 0.)
              {
                crossed = !crossed;
                nearest = std::min(nearest, height);
              }
          }
        return crossed && nearest <= to_end;
      }

      double distance(const Vec2 &place) const
      {
        return (line.point_at(line.way_to(place)) - place).norm();
      }

    private:
      SurfaceLine                   line;
      const std::vector<Vec2>      &points;
      double                        left, right; ///< ends [m]
      std::vector<std::vector<int>> columns;     ///< segments over equal parts of its width

      int column_of(const double x) const
      {
        const double width = right - left;
        const double part  = width > 0. ? (x - left) / width : 0.;
        const int    n     = static_cast<int>(columns.size());
        return std::clamp(static_cast<int>(part * n), 0, n - 1);
      }
    };



    bool has_line(const std::vector<Vec2> &nodes)
    {
      return std::any_of(nodes.begin(), nodes.end(), [&](const Vec2 &p) { return p != nodes[0]; });
    }



    /// Blocks that places may be in, and the deepest place so far.
    class OverlapSearch
    {
    public:
      explicit OverlapSearch(const Geometry &geometry)
        : g(geometry)
      {
        std::vector<Box> boxes;
        for (int b = 0; b < g.n_blocks(); ++b)
          {
            Box box{g.vertices[g.offset[b]], g.vertices[g.offset[b]]};
            for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
              {
                box.lower = box.lower.cwiseMin(g.vertices[v]);
                box.upper = box.upper.cwiseMax(g.vertices[v]);
              }
            boxes.push_back(box);
            const PolygonMoments moments =
              polygon_moments(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b]);
            sizes.push_back(std::sqrt(std::abs(moments.area)));
            middles.push_back(moments.centroid);
          }
        grid.build(boxes);
        if (has_line(g.foundation_nodes))
          ground.emplace(g.foundation_nodes);
      }

      void look_at_block(const int block)
      {
        const int first = g.offset[block], n = g.offset[block + 1] - first;
        if (contains(&g.vertices[first], n, middles[block])) // not in a notch of its outline
          look_at(block, middles[block]);
        for (int v = g.offset[block]; v < g.offset[block + 1]; ++v)
          {
            look_at(block, g.vertices[v]);
            look_at(block, 0.5 * (g.vertices[v] + g.vertices[g.next(v)]));
          }
      }

      void look_at_foundation()
      {
        for (const Vec2 &node : g.foundation_nodes)
          look_in_blocks(foundation_body, node);
      }

      const Overlap &deepest() const
      {
        return found;
      }

    private:
      const Geometry           &g;
      std::vector<double>       sizes;   ///< of blocks [m]
      std::vector<Vec2>         middles; ///< [m]
      CellGrid                  grid;
      std::optional<GroundLine> ground;
      std::vector<int>          near;
      Overlap                   found;

      bool is_bedrock(const int block) const
      {
        return block >= g.bedrock.first_block;
      }

      void take(const int block, const int other, const Vec2 &place, const double depth)
      {
        double size = sizes[block];
        if (other != foundation_body)
          size = std::min(size, sizes[other]);
        if (depth > found.part * size)
          found = {depth / size, depth, size, block, other, place};
      }

      void look_at(const int block, const Vec2 &place)
      {
        look_in_blocks(block, place);
        if (ground && !is_bedrock(block) && ground->is_above(place))
          take(block, foundation_body, place, ground->distance(place));
      }

      /// @param body whose place it is
      void look_in_blocks(const int body, const Vec2 &place)
      {
        near.clear();
        grid.find(place, near);
        for (const int other : near)
          {
            const bool are_rock =
              is_bedrock(other) && (body == foundation_body || is_bedrock(body));
            const Vec2 *outline = &g.vertices[g.offset[other]];
            const int   n       = g.offset[other + 1] - g.offset[other];
            if (other == body || are_rock || !contains(outline, n, place))
              continue;
            const double depth = distance_to_outline(outline, n, place);
            if (body == foundation_body)
              take(other, foundation_body, place, depth);
            else
              take(body, other, place, depth);
          }
      }
    };
  } // namespace



  Overlap deepest_overlap(const Geometry &geometry)
  {
    OverlapSearch search(geometry);
    for (int b = 0; b < geometry.n_blocks(); ++b)
      search.look_at_block(b);
    search.look_at_foundation();
    return search.deepest();
  }
} // namespace hybrid::dda
