// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/water.h>
#include <hybrid/dda/block/water_pieces.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    /// Coordinates about a point on a piece of the surface, sheared so that this piece is y = 0:
    /// the pressure is then -rho_w g y, areas are as before.
    struct PieceFrame
    {
      Vec2   origin; ///< [m]
      double slope;  ///< [-]

      PieceFrame(const WaterPiece &piece, const double x)
        : origin(x, piece.height(x))
        , slope(piece.slope)
      {}

      Vec2 to(const Vec2 &place) const
      {
        const Vec2 r = place - origin;
        return {r.x(), r.y() - slope * r.x()};
      }

      /// A vector from the origin.
      Vec2 back(const Vec2 &r) const
      {
        return {r.x(), r.y() + slope * r.x()};
      }
    };


    /// Part of the edge from a to b with y <= 0; false if there is none.
    bool clip_to_water(Vec2 &a, Vec2 &b)
    {
      if (a.y() > 0. && b.y() > 0.)
        return false;
      if (a.y() > 0. || b.y() > 0.)
        {
          const double fraction = a.y() / (a.y() - b.y());
          const Vec2   line(a.x() + fraction * (b.x() - a.x()), 0.);
          (a.y() > 0. ? a : b) = line;
        }
      return true;
    }


    Vec2 at_x(const Vec2 &a, const Vec2 &b, const double x)
    {
      return {x, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y())};
    }


    /// Part of the edge from a to b below a piece; false if there is none. A vertical edge where
    /// two pieces meet is below the second. @param last end of the pieces that are looked at [m]
    bool clip_to_piece(const WaterPiece &piece, const double last, Vec2 &a, Vec2 &b)
    {
      const Vec2 from = a, to = b;
      if (from.x() == to.x() && from.x() == piece.right && piece.right < last)
        return false;
      for (Vec2 *end : {&a, &b})
        {
          const double x = std::clamp(end->x(), piece.left, piece.right);
          if (x != end->x() && from.x() == to.x())
            return false;
          if (x != end->x())
            *end = at_x(from, to, x);
        }
      return a != b;
    }


    constexpr int highest_degree = 8; ///< of elements

    /// Points and weights of Gauss's rule on [0, 1], exact up to the degree 2 n - 1.
    struct GaussRule
    {
      static constexpr int most = (highest_degree + 3) / 2;
      int                  n;
      double               point[most], weight[most];
    };

    /// @param n 2..5
    const GaussRule &gauss_rule(const int n)
    {
      static const auto rule = [](const std::initializer_list<std::pair<double, double>> &half) {
        GaussRule r{};
        for (const auto &[x, w] : half)
          for (const double side : {-1., 1.})
            if (x != 0. || side > 0.)
              {
                r.point[r.n]    = 0.5 + 0.5 * side * x;
                r.weight[r.n++] = 0.5 * w;
              }
        return r;
      };
      static const GaussRule rules[] = {
        rule({{1. / std::sqrt(3.), 1.}}),
        rule({{std::sqrt(0.6), 5. / 9.}, {0., 8. / 9.}}),
        rule({{std::sqrt(3. / 7. + 2. / 7. * std::sqrt(1.2)), (18. - std::sqrt(30.)) / 36.},
              {std::sqrt(3. / 7. - 2. / 7. * std::sqrt(1.2)), (18. + std::sqrt(30.)) / 36.}}),
        rule({{std::sqrt(5. + 2. * std::sqrt(10. / 7.)) / 3., (322. - 13. * std::sqrt(70.)) / 900.},
              {std::sqrt(5. - 2. * std::sqrt(10. / 7.)) / 3., (322. + 13. * std::sqrt(70.)) / 900.},
              {0., 128. / 225.}})};
      return rules[n - 2];
    }


    /// Adds the force of the water on a face of the rock to those of its nodes [N/m].
    /// @param nodes degree + 1 on a straight line, rock to the right of it. @param force two per
    /// node
    void add_water_on_face(const Water &water, const Vec2 *nodes, const int degree, double *force)
    {
      const Vec2       edge    = nodes[degree] - nodes[0];
      const double     length2 = edge.squaredNorm();
      const double     right   = std::max(nodes[0].x(), nodes[degree].x());
      const GaussRule &rule    = gauss_rule((degree + 3) / 2);
      double           at[highest_degree + 1];
      for (int i = 0; i <= degree; ++i)
        at[i] = (nodes[i] - nodes[0]).dot(edge) / length2;
      WaterPieces pieces(water, std::min(nodes[0].x(), nodes[degree].x()), right);
      while (const std::optional<WaterPiece> piece = pieces.next())
        {
          const PieceFrame frame(*piece, nodes[0].x());
          Vec2             a = nodes[0], b = nodes[degree];
          if (!clip_to_piece(*piece, right, a, b))
            continue;
          a = frame.to(a);
          b = frame.to(b);
          if (!clip_to_water(a, b))
            continue;
          const Vec2 part = frame.back(b - a);
          const Vec2 into_rock(part.y(), -part.x()); // times the length
          const Vec2 first = nodes[0] - frame.origin;
          for (int q = 0; q < rule.n; ++q)
            {
              const Vec2   x    = a + rule.point[q] * (b - a);
              const double s    = (frame.back(x) - first).dot(edge) / length2;
              const Vec2   load = (-rule.weight[q] * water.unit_weight * x.y()) * into_rock;
              for (int i = 0; i <= degree; ++i)
                {
                  double shape = 1.;
                  for (int j = 0; j <= degree; ++j)
                    if (j != i)
                      shape *= (s - at[j]) / (at[i] - at[j]);
                  force[2 * i] += shape * load.x();
                  force[2 * i + 1] += shape * load.y();
                }
            }
        }
    }


    /// Moments of the submerged part of a polygon about a point on the water's line. The closing
    /// edges lie on the line and add nothing.
    struct SubmergedPart
    {
      double area = 0., x = 0., y = 0.; ///< [m2], [m3]

      /// Simplex integration (Shi 1988).
      void add_edge(const Vec2 &a, const Vec2 &b)
      {
        const double c = a.x() * b.y() - a.y() * b.x();
        area += c / 2.;
        x += c * (a.x() + b.x()) / 6.;
        y += c * (a.y() + b.y()) / 6.;
      }

      /// Of the part below a piece: integrals over x, to which the vertical cuts at its ends add
      /// nothing (Green's theorem: - int y dx, - int x y dx, - int y^2/2 dx).
      void add_cut_edge(const Vec2 &a, const Vec2 &b)
      {
        const Vec2 d = b - a;
        area -= d.x() * (a.y() + b.y()) / 2.;
        x -= d.x() * (a.x() * a.y() + (a.x() * d.y() + a.y() * d.x()) / 2. + d.x() * d.y() / 3.);
        y -= d.x() * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 6.;
      }
    };


    double polygon_area(const MovedOutline &outline)
    {
      const Vec2 origin = outline.at(0);
      double     area   = 0.;
      for (int k = 1; k + 1 < outline.n; ++k)
        {
          const Vec2 a = outline.at(k) - origin, b = outline.at(k + 1) - origin;
          area += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
      return area;
    }


    /// - int p n . du ds over one submerged edge, exact: both factors are linear.
    Vec6 edge_pressure(const double       unit_weight,
                       const BlockMotion &motion,
                       const PieceFrame  &frame,
                       const Vec2        &a,
                       const Vec2        &b)
    {
      const Vec2   edge = frame.back(b - a);
      const Vec2   inward(-edge.y(), edge.x()); // times the length
      const double gauss = 0.5 / std::sqrt(3.);
      Vec6         force = Vec6::Zero();
      for (const double s : {0.5 - gauss, 0.5 + gauss})
        {
          const Vec2 x = a + s * (b - a);
          force +=
            motion.gradient(frame.origin + frame.back(x), (-0.5 * unit_weight * x.y()) * inward);
        }
      return force;
    }


    /// Sums of the water's load below the pieces of its surface, of a block that has its first
    /// area.
    struct LoadBelow
    {
      const Water       &water;
      const BlockMotion &motion;
      double             scale; ///< first area over area [-]
      Vec6               faces    = Vec6::Zero();
      Vec6               buoyancy = Vec6::Zero();
      double             moment   = 0.; ///< int y dA in the frames [m3]

      /// The part of an outline, which ends at x = @p right, below a piece, or all of it.
      void add(const WaterPiece   &piece,
               const PieceFrame   &frame,
               const MovedOutline &outline,
               const double        right,
               const bool          whole)
      {
        SubmergedPart part;
        const bool    by_faces = water.action == Water::Action::pressures;
        for (int k = 0; k < outline.n; ++k)
          {
            Vec2 a = outline.at(k), b = outline.at((k + 1) % outline.n);
            if (!whole && !clip_to_piece(piece, right, a, b))
              continue;
            a = frame.to(a);
            b = frame.to(b);
            if (!clip_to_water(a, b))
              continue;
            if (whole)
              part.add_edge(a, b);
            else
              part.add_cut_edge(a, b);
            if (by_faces) // water on the cuts is within the block
              faces += edge_pressure(water.unit_weight, motion, frame, a, b);
          }
        moment += part.y;
        if (!by_faces && part.area > 0.)
          {
            const double weight = scale * water.unit_weight * part.area;
            buoyancy += motion.gradient(frame.origin + frame.back(Vec2(part.x, part.y) / part.area),
                                        Vec2(-frame.slope * weight, weight));
          }
      }
    };


    /// Extent of an outline [m].
    struct Extent
    {
      double left = 1e300, right = -1e300;

      explicit Extent(const MovedOutline &outline)
      {
        for (int k = 0; k < outline.n; ++k)
          {
            const double x = outline.at(k).x();
            left           = std::min(left, x);
            right          = std::max(right, x);
          }
      }
    };


    /// Highest and lowest corner above a piece's line [m].
    struct HeightAbove
    {
      double lowest = 1e300, highest = -1e300;

      HeightAbove(const PieceFrame &frame, const MovedOutline &outline)
      {
        for (int k = 0; k < outline.n; ++k)
          {
            const double y = frame.to(outline.at(k)).y();
            highest        = std::max(highest, y);
            lowest         = std::min(lowest, y);
          }
      }
    };
  } // namespace


  Water Water::at(const double time) const
  {
    Water now = *this;
    if (changes())
      now.level = (*history)(std::max(time, 0.));
    return now;
  }


  WaterLoad water_load(const Water        &water,
                       const double        first_area,
                       const BlockMotion  &motion,
                       const MovedOutline &outline)
  {
    WaterLoad    load;
    const double w = water.unit_weight;
    const Extent extent(outline);
    LoadBelow    below{water, motion, 0.};
    WaterPieces  pieces(water, extent.left, extent.right);
    while (const std::optional<WaterPiece> piece = pieces.next())
      {
        const PieceFrame  frame(*piece, std::clamp(motion.centroid.x(), piece->left, piece->right));
        const HeightAbove height(frame, outline);
        if (height.lowest >= 0.)
          continue;
        const bool whole = piece->left <= extent.left && piece->right >= extent.right;
        load.full        = whole && height.highest <= 0.;
        load.piece       = piece->number;
        if (load.full && water.action == Water::Action::buoyancy)
          {
            load.force[0]  = -frame.slope * w * first_area;
            load.force[1]  = w * first_area;
            load.potential = -w * first_area * frame.to(motion.centroid).y();
            return load;
          }
        if (below.scale == 0.)
          below.scale = first_area / polygon_area(outline);
        below.add(*piece, frame, outline, extent.right, whole);
      }
    load.potential = -below.scale * w * below.moment;
    if (water.action == Water::Action::pressures)
      {
        load.force        = below.faces;
        const double pore = -w * below.moment; // int p dA
        load.force[3] += pore * motion.ixx;
        load.force[4] += pore * motion.iyy;
        load.force[5] += pore * motion.ixy;
        load.force *= below.scale;
      }
    else
      load.force = below.buoyancy;
    return load;
  }


  double potential_change(const WaterLoad &before, const WaterLoad &after, const Vec2 &moved)
  {
    if (!before.full || !after.full || before.piece != after.piece)
      return after.potential - before.potential;
    // fully submerged: the same force before and after, as the centroid moves
    if (after.piece == WaterPiece::of_level)
      return -after.force[1] * moved.y();
    return -after.force.head<2>().dot(moved);
  }


  void water_on_surface(const Water             &water,
                        const std::vector<Vec2> &nodes,
                        const int                degree,
                        Eigen::VectorXd         &force)
  {
    force.setZero(2 * static_cast<Eigen::Index>(nodes.size()));
    if (water.action != Water::Action::pressures)
      return;
    for (std::size_t k = 0; k + 1 < nodes.size();)
      if (nodes[k] == nodes[k + 1])
        ++k;
      else
        {
          add_water_on_face(water, &nodes[k], degree, force.data() + 2 * k);
          k += degree;
        }
  }


  Water Water::as_pressures() const
  {
    Water water = *this;
    if (action == Action::buoyancy)
      water.action = Action::pressures;
    return water;
  }



  double pore_pressure(const Water &water, const Vec2 &place)
  {
    if (water.action == Water::Action::none)
      return 0.;
    const double height =
      water.line == nullptr ? water.level : std::max(water.level, (*water.line)(place.x()));
    return water.unit_weight * std::max(0., height - place.y());
  }



  Eigen::VectorXd
  water_on_surface(const Water &water, const std::vector<Vec2> &nodes, const int degree)
  {
    Eigen::VectorXd force;
    water_on_surface(water, nodes, degree, force);
    return force;
  }
} // namespace hybrid::dda
