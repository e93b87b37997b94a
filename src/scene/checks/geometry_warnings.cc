// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/geometry_warnings.h>
#include <hybrid/scene/checks/locked_foot.h>
#include <hybrid/scene/checks/shared_edge_check.h>
#include <hybrid/scene/mesh/block_edges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    constexpr double touching    = 1e-3; ///< gap over block size that rounding explains [-]
    constexpr double sliver      = 1e-3; ///< thickness over length of a doubtful block [-]
    constexpr double no_distance = std::numeric_limits<double>::infinity();

    std::string at(const Vec2 &x)
    {
      std::ostringstream text;
      text << "(" << x.x() << ", " << x.y() << ") m";
      return text.str();
    }


    double distance(const Vec2 &x, const Vec2 &a, const Vec2 &b)
    {
      const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0., 1.);
      return (x - a - t * (b - a)).norm();
    }


    /// A block, or an edge of what blocks stand on.
    struct Piece
    {
      std::vector<Vec2> outline;
      Vec2              low, high; ///< bounding box [m]
      double            size;      ///< of the block [m]; infinite for the base
      bool              is_base;

      std::size_t n_edges() const
      {
        return is_base ? 1 : outline.size();
      }
    };


    Piece make_piece(std::vector<Vec2> outline, const bool is_base)
    {
      Piece  piece{std::move(outline), {}, {}, no_distance, is_base};
      double area = 0.;
      piece.low = piece.high = piece.outline[0];
      for (std::size_t i = 0; i < piece.outline.size(); ++i)
        {
          const Vec2 &a = piece.outline[i], &b = piece.outline[(i + 1) % piece.outline.size()];
          piece.low  = piece.low.cwiseMin(a);
          piece.high = piece.high.cwiseMax(a);
          area += 0.5 * cross(a - piece.outline[0], b - piece.outline[0]);
        }
      if (!is_base)
        piece.size = std::sqrt(std::max(area, 0.));
      return piece;
    }


    /// Distance of pieces that do not overlap: from the corners of one to the edges of the other.
    double gap(const Piece &a, const Piece &b)
    {
      double smallest = no_distance;
      for (const auto &[from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const Vec2 &x : from->outline)
          for (std::size_t i = 0; i < to->n_edges(); ++i)
            smallest =
              std::min(smallest,
                       distance(x, to->outline[i], to->outline[(i + 1) % to->outline.size()]));
      return smallest;
    }


    std::vector<Piece> pieces_of(const SectionMesh &mesh)
    {
      std::vector<Piece> pieces;
      for (const auto &block : mesh.blocks)
        {
          std::vector<Vec2> outline;
          for (const int node : block)
            outline.push_back(mesh.nodes[node]);
          pieces.push_back(make_piece(outline, false));
        }
      for (const char *const name : {"sliding_surface", "ground"})
        if (mesh.lines.count(name) > 0)
          for (const auto &edge : mesh.lines.at(name))
            pieces.push_back(make_piece({mesh.nodes[edge[0]], mesh.nodes[edge[1]]}, true));
      return pieces;
    }


    /// Pieces that touch, directly or through others, have the same number.
    std::vector<int> groups_of(const std::vector<Piece> &pieces)
    {
      const int        n = pieces.size();
      std::vector<int> group(n), order(n), open;
      std::iota(group.begin(), group.end(), 0);
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const int a, const int b) {
        return pieces[a].low.x() < pieces[b].low.x();
      });
      double reach = 0.; // the largest gap that counts as none
      for (const Piece &piece : pieces)
        if (!piece.is_base)
          reach = std::max(reach, touching * piece.size);
      const auto root = [&](int k) {
        while (group[k] != k)
          k = group[k] = group[group[k]];
        return k;
      };
      for (const int k : order)
        {
          const Piece &a         = pieces[k];
          const auto   is_behind = [&](const int j) {
            return pieces[j].high.x() + reach < a.low.x();
          };
          open.erase(std::remove_if(open.begin(), open.end(), is_behind), open.end());
          for (const int j : open)
            {
              const Piece &b     = pieces[j];
              const double slack = touching * std::min(a.size, b.size);
              if (!(a.is_base && b.is_base) && root(k) != root(j) &&
                  b.high.y() + slack >= a.low.y() && a.high.y() + slack >= b.low.y() &&
                  gap(a, b) <= slack)
                group[root(k)] = root(j);
            }
          open.push_back(k);
        }
      for (int &g : group)
        g = root(g);
      return group;
    }


    /// Blocks that nothing holds: how many, and where the first is.
    void look_at_support(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      const std::vector<Piece> pieces = pieces_of(mesh);
      const std::vector<int>   group  = groups_of(pieces);
      std::vector<bool>        is_held(pieces.size(), false);
      bool                     has_base = false;
      for (std::size_t k = 0; k < pieces.size(); ++k)
        if (pieces[k].is_base)
          has_base = is_held[group[k]] = true;
      int count = 0, first = -1;
      for (std::size_t k = 0; k < mesh.blocks.size(); ++k)
        if (!is_held[group[k]] && ++count > 0 &&
            (first < 0 || pieces[k].low.y() < pieces[first].low.y()))
          first = k;
      if (count == 0)
        return;
      double nearest = no_distance;
      for (std::size_t k = 0; k < pieces.size(); ++k)
        for (std::size_t j = 0; j < pieces.size(); ++j)
          if (group[k] == group[first] && group[j] != group[first])
            nearest = std::min(nearest, gap(pieces[k], pieces[j]));
      Vec2 lowest = pieces[first].outline[0];
      for (const Vec2 &x : pieces[first].outline)
        if (x.y() < lowest.y())
          lowest = x;
      std::ostringstream text;
      text << (count == 1 ? "a block" : std::to_string(count) + " blocks")
           << " with nothing below: the lowest begins at " << at(lowest);
      if (!has_base)
        text
          << ", and there is no base: the mesh has neither of the lines sliding_surface and ground";
      else if (nearest < no_distance)
        text << ", and " << nearest << " m are between it and what is next";
      text << "; it falls, as the static stage looks for an equilibrium (to drop blocks, set "
              "Gravity/Static stage = none)";
      warnings.push_back(text.str());
    }


    /// The thinnest block, if it is doubtful.
    void look_at_slivers(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      double thinnest = sliver, thickness = 0., length = 0.;
      Vec2   where = Vec2::Zero();
      for (const auto &block : mesh.blocks)
        {
          const Vec2 &x0      = mesh.nodes[block[0]];
          double      longest = 0., area = 0.;
          for (std::size_t i = 0; i < block.size(); ++i)
            {
              const Vec2 &a = mesh.nodes[block[i]], &b = mesh.nodes[block[(i + 1) % block.size()]];
              longest = std::max(longest, (b - a).norm());
              area += 0.5 * cross(a - x0, b - x0);
            }
          if (area / (longest * longest) >= thinnest)
            continue;
          thinnest  = area / (longest * longest);
          thickness = area / longest;
          length    = longest;
          where     = x0;
        }
      if (length == 0.)
        return;
      std::ostringstream text;
      text << "the block at " << at(where) << " is a sliver, " << length << " m long and "
           << thickness << " m thick on average: it makes steps small and results doubtful";
      warnings.push_back(text.str());
    }



    /// Blocks strain as a whole, so a mass of polygons that yield has few ways to shear.
    void look_at_yielding_polygons(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      constexpr double few = 0.05;
      const int        n   = std::count_if(mesh.blocks.begin(),
                                  mesh.blocks.end(),
                                  [](const std::vector<int> &block) { return block.size() > 3; });
      if (n <= few * mesh.blocks.size())
        return;
      warnings.push_back(std::to_string(n) + " of " + std::to_string(mesh.blocks.size()) +
                         " blocks that yield have more than three corners: such a mass is too "
                         "strong, by a third with a dozen over its height; make them triangles");
    }



    double area_of(const SectionMesh &mesh, const std::vector<int> &block)
    {
      double area = 0.;
      for (std::size_t i = 0; i < block.size(); ++i)
        area += 0.5 * cross(mesh.nodes[block[i]] - mesh.nodes[block[0]],
                            mesh.nodes[block[(i + 1) % block.size()]] - mesh.nodes[block[0]]);
      return area;
    }


    /// Corners of two blocks that are all but in one place, so that edges there are not bonded. The
    /// ends of a short edge are none.
    void look_at_near_corners(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      const std::set<std::pair<int, int>> edges = edges_of_blocks(mesh);
      std::vector<double> size(mesh.nodes.size(), 0.); // of the smallest block there [m]
      for (const auto &block : mesh.blocks)
        {
          const double of_block = std::sqrt(area_of(mesh, block));
          for (const int node : block)
            size[node] = size[node] > 0. ? std::min(size[node], of_block) : of_block;
        }
      std::vector<int> corners;
      for (std::size_t n = 0; n < size.size(); ++n)
        if (size[n] > 0.)
          corners.push_back(static_cast<int>(n));
      std::sort(corners.begin(), corners.end(), [&](const int a, const int b) {
        return mesh.nodes[a].x() < mesh.nodes[b].x();
      });
      int    count = 0;
      double apart = 0.;
      Vec2   where = Vec2::Zero();
      for (std::size_t k = 0; k < corners.size(); ++k)
        for (std::size_t j = k + 1; j < corners.size(); ++j)
          {
            const Vec2  &a = mesh.nodes[corners[k]], &b = mesh.nodes[corners[j]];
            const double reach = touching * std::min(size[corners[k]], size[corners[j]]);
            if (b.x() - a.x() > touching * size[corners[k]])
              break;
            if (a == b || (b - a).norm() > reach) // a notch has two nodes in one place
              continue;
            if (edges.count(std::minmax(corners[k], corners[j])) > 0)
              continue;
            if (count++ == 0)
              {
                apart = (b - a).norm();
                where = a;
              }
          }
      if (count == 0)
        return;
      std::ostringstream text;
      text << "corners of blocks are next to each other, not in one place: " << apart
           << " m apart at " << at(where);
      if (count > 1)
        text << " and in " << count - 1 << (count == 2 ? " other place" : " other places");
      text << "; edges there are not bonded";
      warnings.push_back(text.str());
    }


    /// Round-off of places grows with the distance from the origin, and motion that is chaotic
    /// with it.
    void look_at_origin(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      constexpr double far = 100.; ///< sizes of the section
      if (mesh.nodes.empty())
        return;
      Vec2 low = mesh.nodes.front(), high = low;
      for (const Vec2 &node : mesh.nodes)
        {
          low  = low.cwiseMin(node);
          high = high.cwiseMax(node);
        }
      const double away = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
      if (!(away > far * (high - low).norm()))
        return;
      std::ostringstream text;
      text.precision(7);
      text << "the section lies " << away << " m from the origin and is " << (high - low).norm()
           << " m across: digits of small motions are lost, and blocks that rattle end elsewhere; "
              "draw it near the origin";
      warnings.push_back(text.str());
    }
  } // namespace


  std::vector<std::string> geometry_warnings(const SectionMesh &mesh, const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    if (!scene.blocks.enabled)
      return warnings;
    if (scene.environment.gravity > 0. &&
        (scene.environment.static_stage == StaticStage::equilibrium ||
         scene.environment.static_stage == StaticStage::move))
      look_at_support(mesh, warnings);
    look_at_slivers(mesh, warnings);
    if (scene.blocks.bonded)
      {
        look_at_near_corners(mesh, warnings);
        if (const std::string text = partly_shared_edges(mesh); !text.empty())
          warnings.push_back(text);
      }
    if (scene.blocks.yielding)
      look_at_yielding_polygons(mesh, warnings);
    if (const std::string text = locked_foot(mesh); !text.empty())
      warnings.push_back(text);
    look_at_origin(mesh, warnings);
    return warnings;
  }
} // namespace hybrid::scene
