// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/ground_lines.h>
#include <hybrid/dda/model/model.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    constexpr double shallow = 0.05; ///< depth of a dip over its width that soles lie in [-]
    constexpr double above   = 1e-9; ///< of what is not below a chord, over its length [-]



    /// The surface of the bedrock's blocks from an edge on; edges that it takes are @p taken.
    GroundLine line_from(const Geometry &g, const int edge, std::vector<char> &taken)
    {
      GroundLine line;
      int        last = edge, next = edge;
      for (; next >= 0 && !taken[next]; next = g.bedrock.next[last])
        {
          last        = next;
          taken[last] = 1;
          line.points.push_back(last);
        }
      line.closed = next == edge;
      if (!line.closed)
        line.points.push_back(g.next(last));
      return line;
    }



    /// A piece of a line between two of its points.
    struct Dip
    {
      std::size_t begin, end;
      double      depth; ///< below the straight line between them [m]
    };



    /// Depth of the piece between points @p i and @p j; 0 if it is no dip: see without_dips().
    double depth_of_dip(const std::vector<Vec2> &line, const std::size_t i, const std::size_t j)
    {
      const Vec2   chord = line[j] - line[i];
      const double width = chord.norm();
      double       depth = 0.;
      for (std::size_t k = i + 1; k < j; ++k)
        {
          const double below = cross(chord, line[k] - line[i]) / width;
          if (below < -above * width)
            return 0.;
          depth = std::max(depth, below);
        }
      return depth > shallow * width ? depth : 0.;
    }



    /// Box round points of a line, along one of its pieces.
    class BoxAlong
    {
    public:
      /// @param along unit vector
      BoxAlong(const Vec2 &first, const Vec2 &along)
        : origin(first)
        , axes((Eigen::Matrix2d() << along, Vec2(-along.y(), along.x())).finished())
      {}

      void add(const Vec2 &point)
      {
        const Vec2 r = axes.transpose() * (point - origin);
        lower        = lower.cwiseMin(r);
        upper        = upper.cwiseMax(r);
      }

      /// At most so deep do points in it lie below a straight line from the first one [m].
      double most_below(const Vec2 &chord) const
      {
        const Vec2 down = axes.transpose() * Vec2(-chord.y(), chord.x()).normalized();
        return (down.cwiseProduct(lower)).cwiseMax(down.cwiseProduct(upper)).sum();
      }

    private:
      Vec2            origin;
      Eigen::Matrix2d axes;
      Vec2            lower = Vec2::Zero(), upper = Vec2::Zero();
    };



    /// All dips no wider than @p width [m], the deepest first; they may overlap.
    std::vector<Dip> find_dips(const std::vector<Vec2> &line, const double width)
    {
      std::vector<Dip> dips;
      for (std::size_t i = 0; i + 2 < line.size(); ++i)
        {
          BoxAlong between(line[i], (line[i + 1] - line[i]).normalized());
          for (std::size_t j = i + 2;
               j < line.size() && std::abs(line[j].x() - line[i].x()) <= width;
               ++j)
            {
              between.add(line[j - 1]);
              const Vec2 chord = line[j] - line[i];
              if (chord.norm() > width || between.most_below(chord) <= shallow * chord.norm())
                continue;
              if (const double depth = depth_of_dip(line, i, j); depth > 0.)
                dips.push_back({i, j, depth});
            }
        }
      std::stable_sort(dips.begin(), dips.end(), [](const Dip &a, const Dip &b) {
        return a.depth > b.depth;
      });
      return dips;
    }
  } // namespace



  std::vector<Vec2> GroundLine::places(const std::vector<Vec2> &vertices,
                                       const std::vector<Vec2> &nodes) const
  {
    std::vector<Vec2> found;
    found.reserve(points.size());
    for (const int point : points)
      found.push_back(base ? nodes[point] : vertices[point]);
    return found;
  }



  std::vector<GroundLine> ground_lines(const Model &model)
  {
    std::vector<GroundLine> lines;
    const Geometry         &g = model.initial;
    if (model.n_bedrock > 0)
      {
        std::vector<char> taken(g.vertices.size(), 0);
        for (const bool is_open :
             {true, false}) // a line that is open begins where nothing is before
          for (int v = g.offset[model.n_mass()]; v < static_cast<int>(g.vertices.size()); ++v)
            if (g.bedrock.next[v] != BedrockSurface::inside && !taken[v] &&
                (!is_open || g.bedrock.previous[v] == BedrockSurface::none))
              lines.push_back(line_from(g, v, taken));
      }
    if (const int n = model.n_foundation_nodes(); n > 1)
      {
        lines.push_back({true, false, {}});
        for (int k = n - 1; k >= 0; --k)
          lines.back().points.push_back(k);
      }
    return lines;
  }



  int line_below(const std::vector<GroundLine> &lines, const SoleGround &ground)
  {
    const auto has = [&](const GroundLine &line) {
      return line.base == ground.base &&
             (line.base ||
              std::find(line.points.begin(), line.points.end(), ground.first) != line.points.end());
    };
    return static_cast<int>(std::find_if(lines.begin(), lines.end(), has) - lines.begin());
  }



  std::vector<Vec2> without_dips(const std::vector<Vec2> &line, const double width)
  {
    std::vector<char> is_inside(line.size(), 0), is_taken(line.size(), 0); // piece from each point
    for (const Dip &dip : find_dips(line, width))
      if (std::count(is_taken.begin() + dip.begin, is_taken.begin() + dip.end, 1) == 0)
        {
          std::fill(is_taken.begin() + dip.begin, is_taken.begin() + dip.end, 1);
          std::fill(is_inside.begin() + dip.begin + 1, is_inside.begin() + dip.end, 1);
        }
    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < line.size(); ++k)
      if (!is_inside[k])
        kept.push_back(line[k]);
    return kept;
  }
} // namespace hybrid::dda
