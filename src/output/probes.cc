// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/output/probes.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace hybrid::output
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double allowed  = 1e-3; ///< distance from everything over the size of the section [-]
    constexpr double rounding = 1e-9; ///< distance from an outline over the size of the section [-]



    double size_of(const dda::Model *blocks, const continuum::Continuum *bedrock)
    {
      Vec2       low = Vec2::Constant(infinity), high = -low;
      const auto add = [&](const std::vector<Vec2> &points) {
        for (const Vec2 &x : points)
          {
            low  = low.cwiseMin(x);
            high = high.cwiseMax(x);
          }
      };
      if (blocks != nullptr)
        {
          add(blocks->initial.vertices);
          add(blocks->initial.foundation_nodes);
        }
      if (bedrock != nullptr)
        add(bedrock->corners());
      return low.x() <= high.x() ? (high - low).maxCoeff() : 0.;
    }
  } // namespace



  Probes::Probes(const dda::Model           *blocks,
                 const continuum::Continuum *bedrock,
                 const coupling::Foundation *of_blocks)
    : model(blocks)
    , continuum(bedrock)
    , foundation(of_blocks)
    , section(size_of(blocks, bedrock))
  {}



  int Probes::block_at(const Vec2 &x) const
  {
    int nearest = -1;
    if (model == nullptr)
      return nearest;
    const dda::Geometry &g    = model->initial;
    double               rank = infinity; // the lowest one's block is taken
    for (int b = 0; b < g.n_blocks(); ++b)
      {
        const Vec2 *outline = &g.vertices[g.offset[b]];
        const int   n       = g.offset[b + 1] - g.offset[b];
        if (!dda::contains(outline, n, x) &&
            dda::distance_to_outline(outline, n, x) > rounding * section)
          continue;
        if (nearest >= 0 && model->is_bedrock(b) && !model->is_bedrock(nearest))
          break; // the mass comes first, in the list too
        // Of the mass the nearest block, of the bedrock the upper one: on a plane the rock above
        // it.
        const Vec2   centroid = dda::polygon_moments(outline, n).centroid;
        const double of_block = model->is_bedrock(b) ? -centroid.y() : (centroid - x).norm();
        if (of_block < rank)
          {
            rank    = of_block;
            nearest = b;
          }
      }
    return nearest;
  }



  std::pair<int, double> Probes::nearest_block(const Vec2 &x) const
  {
    std::pair<int, double> nearest{-1, infinity};
    for (int b = 0; model != nullptr && b < model->n_blocks(); ++b)
      {
        const dda::Geometry &g = model->initial;
        const double         d =
          dda::distance_to_outline(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b], x);
        if (d < nearest.second)
          nearest = {b, d};
      }
    return nearest;
  }



  void Probes::attach(Probe &probe, const int block, const Vec2 &x) const
  {
    const dda::Geometry &g = model->initial;
    probe.block            = block;
    // The three vertices that span most with the first; a block stays an affine image of itself.
    const int first = g.offset[block], end = g.offset[block + 1];
    double    max_area = 0.;
    for (int v = first + 1; v < end; ++v)
      for (int w = v + 1; w < end; ++w)
        {
          const double area =
            cross(g.vertices[v] - g.vertices[first], g.vertices[w] - g.vertices[first]);
          if (std::abs(area) <= max_area)
            continue;
          max_area          = std::abs(area);
          probe.vertices[0] = first;
          probe.vertices[1] = v;
          probe.vertices[2] = w;
        }
    const Vec2 p = x - g.vertices[first], a = g.vertices[probe.vertices[1]] - g.vertices[first],
               b      = g.vertices[probe.vertices[2]] - g.vertices[first];
    const double area = cross(a, b), wa = cross(p, b) / area, wb = cross(a, p) / area;
    probe.weights[0] = 1. - wa - wb;
    probe.weights[1] = wa;
    probe.weights[2] = wb;
  }



  double Probes::height_above_base(const Vec2 &x) const
  {
    if (continuum != nullptr || model == nullptr || model->n_foundation_nodes() == 0)
      return infinity;
    const std::vector<Vec2> &nodes = model->initial.foundation_nodes;
    // Beside the base it goes on level.
    const Vec2 *left = &nodes.front(), *right = &nodes.front();
    for (const Vec2 &node : nodes)
      {
        left  = node.x() < left->x() ? &node : left;
        right = node.x() > right->x() ? &node : right;
      }
    double surface = x.x() <= left->x() ? left->y() : x.x() >= right->x() ? right->y() : -infinity;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
      {
        const Vec2 &a = nodes[k], &b = nodes[k + 1];
        if (x.x() < std::min(a.x(), b.x()) || x.x() > std::max(a.x(), b.x()))
          continue;
        const double fraction = b.x() != a.x() ? (x.x() - a.x()) / (b.x() - a.x()) : 1.;
        surface               = std::max(surface, a.y() + fraction * (b.y() - a.y()));
      }
    return x.y() - surface;
  }



  void Probes::attach_to_nearest(Probe &probe, const Vec2 &x, const std::string &name) const
  {
    const auto   block = nearest_block(x);
    const double rock = probe.point.outside, height = height_above_base(x);
    const double nearest = std::min({block.second, rock, height});
    if (nearest > allowed * section)
      {
        std::ostringstream text;
        text << "the point '" << name << "' at (" << x.x() << ", " << x.y()
             << ") m lies in no part of the section:";
        if (!std::isfinite(nearest))
          text << " neither bedrock nor a block is there,";
        if (std::isfinite(block.second))
          text << ' ' << block.second << " m from the nearest block,";
        if (std::isfinite(rock))
          text << ' ' << rock << " m from the bedrock,";
        if (std::isfinite(height))
          text << ' ' << height << " m above the base,";
        text << " where " << allowed * section << " m, a thousandth of the section, is allowed";
        throw InputError(text.str());
      }
    if (block.second == nearest)
      attach(probe, block.first, x);
    else if (height == nearest)
      probe.point = {};
  }



  void Probes::check_distance_from_base(const Vec2 &x, const std::string &name) const
  {
    double nearest = infinity;
    for (const Vec2 &node : model->initial.foundation_nodes)
      nearest = std::min(nearest, (node - x).norm());
    const double most = 1e3 * section;
    if (nearest <= most)
      return;
    std::ostringstream text;
    text << "the point '" << name << "' at (" << x.x() << ", " << x.y()
         << ") m belongs to the rigid base, but is " << nearest
         << " m from its surface; allowed is " << most << " m, a thousand times the section";
    throw InputError(text.str());
  }



  int Probes::add(const Vec2 &x, const std::string &name)
  {
    Probe     probe;
    const int block = block_at(x);
    if (continuum != nullptr)
      probe.point = continuum->point(x, allowed * section);
    else
      probe.point.outside = infinity;
    if (block >= 0)
      attach(probe, block, x);
    else if (height_above_base(x) <= 0.)
      {
        check_distance_from_base(x, name);
        probe.point = {};
      }
    else if (probe.point.outside > rounding * section)
      attach_to_nearest(probe, x, name);
    probes.push_back(probe);
    return static_cast<int>(probes.size()) - 1;
  }



  std::pair<int, double> Probes::block_beside(const Vec2 &x, const Vec2 &direction) const
  {
    constexpr double       least = 0.9; // cosine of 25 degrees
    const double           reach = rounding * section;
    std::pair<int, double> best{-1, least};
    for (int b = 0; model != nullptr && b < model->n_blocks(); ++b)
      for (int v = model->initial.offset[b]; v < model->initial.offset[b + 1]; ++v)
        {
          const Vec2  &a     = model->initial.vertices[v];
          const Vec2   along = model->initial.vertices[model->initial.next(v)] - a, from = x - a;
          const double length = along.norm(), at = from.dot(along) / length;
          if (at < -reach || at > length + reach || std::abs(cross(along, from)) > reach * length)
            continue;
          const double cosine = along.dot(direction) / length; // the block is to the left
          if (cosine > best.second)
            best = {b, cosine};
        }
    return best;
  }



  int Probes::add_beside(const Vec2 &x, const Vec2 &direction)
  {
    Probe      probe;
    const auto block = block_beside(x, direction);
    double     rock  = 0.;
    if (continuum != nullptr)
      probe.point = continuum->point_beside(x, direction, rounding * section, rock);
    if (block.first >= 0 && block.second >= rock)
      attach(probe, block.first, x);
    else if (probe.point.cell < 0 &&
             (direction.x() > 0. || height_above_base(x) > rounding * section))
      return -1;
    probes.push_back(probe);
    return static_cast<int>(probes.size()) - 1;
  }



  Vec2 Probes::position(const dda::DdaState &state, const Probe &probe) const
  {
    Vec2 x = Vec2::Zero();
    for (int k = 0; k < 3; ++k)
      x += probe.weights[k] * state.geometry.vertices[probe.vertices[k]];
    return x;
  }



  void Probes::set_reference(const coupling::CoupledState &state)
  {
    for (Probe &probe : probes)
      if (probe.block >= 0)
        probe.reference = position(state.blocks, probe);
  }



  PointMotion Probes::sample(const coupling::CoupledState &state, const int number) const
  {
    const Probe &probe = probes[number];
    PointMotion  motion;
    if (probe.block < 0 && probe.point.cell >= 0)
      {
        const auto s        = continuum->sample(state.continuum, probe.point);
        motion.displacement = s.displacement;
        motion.velocity     = s.velocity;
        motion.acceleration = s.acceleration;
      }
    else if (probe.block >= 0)
      {
        const dda::BlockState &block = state.blocks.blocks[probe.block];
        const Vec2             x     = position(state.blocks, probe);
        const dda::BlockMotion at_rest(block.centroid, dda::Vec6::Zero());
        const dda::Vec6        gx = at_rest.gradient(x, Vec2::UnitX()),
                        gy        = at_rest.gradient(x, Vec2::UnitY());
        motion.displacement       = x - probe.reference;
        motion.velocity           = {gx.dot(block.velocity), gy.dot(block.velocity)};
        motion.acceleration       = {gx.dot(block.acceleration), gy.dot(block.acceleration)};
      }
    else if (state.blocks.foundation_displacement.size() > 0)
      {
        motion.displacement = state.blocks.foundation_displacement.head<2>();
        if (foundation != nullptr)
          {
            const coupling::PrescribedMotion prescribed = foundation->prescribed_motion(state.time);
            motion.velocity                             = prescribed.velocity;
            motion.acceleration                         = prescribed.acceleration;
          }
      }
    return motion;
  }



  std::vector<continuum::Continuum::Point> Probes::points_of_bedrock() const
  {
    std::vector<continuum::Continuum::Point> points;
    for (const Probe &probe : probes)
      if (probe.block < 0 && probe.point.cell >= 0)
        points.push_back(probe.point);
    return points;
  }



  void Probes::serialize(restart::Archive &archive)
  {
    std::vector<Vec2> references;
    for (const Probe &probe : probes)
      references.push_back(probe.reference);
    archive(references);
    for (std::size_t k = 0; archive.is_reading() && k < probes.size(); ++k)
      probes[k].reference = references.at(k);
  }
} // namespace hybrid::output
