// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/water.h>

#include <cmath>

namespace hybrid::dda
{
  namespace
  {
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


    /// Moments of the submerged part of a polygon about a point on the water's line. The closing
    /// edges lie on the line and add nothing (simplex integration).
    struct SubmergedPart
    {
      double area = 0., x = 0., y = 0.; ///< [m2], [m3]

      void add_edge(const Vec2 &a, const Vec2 &b)
      {
        const double c = a.x() * b.y() - a.y() * b.x();
        area += c / 2.;
        x += c * (a.x() + b.x()) / 6.;
        y += c * (a.y() + b.y()) / 6.;
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
                       const Vec2        &origin,
                       const Vec2        &a,
                       const Vec2        &b)
    {
      const Vec2   inward(-(b - a).y(), (b - a).x()); // times the length
      const double gauss = 0.5 / std::sqrt(3.);
      Vec6         force = Vec6::Zero();
      for (const double s : {0.5 - gauss, 0.5 + gauss})
        {
          const Vec2 x = a + s * (b - a);
          force += motion.gradient(origin + x, (-0.5 * unit_weight * x.y()) * inward);
        }
      return force;
    }
  } // namespace


  WaterLoad water_load(const Water        &water,
                       const double        first_area,
                       const BlockMotion  &motion,
                       const MovedOutline &outline)
  {
    WaterLoad    load;
    const Vec2   origin(motion.centroid.x(), water.level);
    const double w = water.unit_weight;

    double highest = -1e300, lowest = 1e300;
    for (int k = 0; k < outline.n; ++k)
      {
        const double y = outline.at(k).y();
        highest        = std::max(highest, y);
        lowest         = std::min(lowest, y);
      }
    if (lowest >= water.level)
      return load;
    load.full = highest <= water.level;
    if (load.full && water.action == Water::Action::buoyancy)
      {
        load.force[1]  = w * first_area;
        load.potential = w * first_area * (water.level - motion.centroid.y());
        return load;
      }

    SubmergedPart part;
    const bool    by_faces = water.action == Water::Action::pressures;
    for (int k = 0; k < outline.n; ++k)
      {
        Vec2 a = outline.at(k) - origin, b = outline.at((k + 1) % outline.n) - origin;
        if (!clip_to_water(a, b))
          continue;
        part.add_edge(a, b);
        if (by_faces)
          load.force += edge_pressure(w, motion, origin, a, b);
      }
    const double scale = first_area / polygon_area(outline);
    load.potential     = -scale * w * part.y;
    if (by_faces)
      {
        const double pore = -w * part.y; // int p dA
        load.force[3] += pore * motion.ixx;
        load.force[4] += pore * motion.iyy;
        load.force[5] += pore * motion.ixy;
        load.force *= scale;
      }
    else if (part.area > 0.)
      load.force =
        motion.gradient(origin + Vec2(part.x, part.y) / part.area, Vec2(0., scale * w * part.area));
    return load;
  }


  double potential_change(const WaterLoad &before, const WaterLoad &after, const double rise)
  {
    // fully submerged: the same force before and after, as the centroid moves
    if (before.full && after.full)
      return -after.force[1] * rise;
    return after.potential - before.potential;
  }


  Eigen::VectorXd water_on_surface(const Water &water, const std::vector<Vec2> &nodes)
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(nodes.size()));
    if (water.action != Water::Action::pressures)
      return force;
    const double gauss = 0.5 / std::sqrt(3.);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
      {
        const Vec2   origin(nodes[k].x(), water.level);
        const Vec2   first = nodes[k] - origin, edge = nodes[k + 1] - nodes[k];
        const double length2 = edge.squaredNorm();
        Vec2         a = first, b = nodes[k + 1] - origin;
        if (!clip_to_water(a, b))
          continue;
        const Vec2 into_rock((b - a).y(), -(b - a).x()); // times the length
        for (const double s : {0.5 - gauss, 0.5 + gauss})
          {
            const Vec2   x      = a + s * (b - a);
            const double second = (x - first).dot(edge) / length2;
            const Vec2   part   = (-0.5 * water.unit_weight * x.y()) * into_rock;
            force.segment<2>(2 * k) += (1. - second) * part;
            force.segment<2>(2 * k + 2) += second * part;
          }
      }
    return force;
  }
} // namespace hybrid::dda
