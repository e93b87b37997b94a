// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_motion.h>
#include <hybrid/dda/polygon.h>
#include <hybrid/output/probes.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace hybrid::output
{
  Probes::Probes(const dda::Model *blocks, continuum::Continuum *bedrock)
    : model(blocks)
    , continuum(bedrock)
  {}



  int Probes::block_at(const Vec2 &x) const
  {
    if (model == nullptr)
      return -1;
    const dda::Geometry &g = model->initial;
    for (int b = 0; b < g.n_blocks(); ++b)
      if (dda::contains(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b], x))
        return b;
    return -1;
  }



  int Probes::nearest_block(const Vec2 &x) const
  {
    int    nearest  = -1;
    double distance = std::numeric_limits<double>::infinity();
    if (model == nullptr)
      return nearest;
    const dda::Geometry &g = model->initial;
    for (int b = 0; b < g.n_blocks(); ++b)
      {
        const double d =
          dda::distance_to_outline(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b], x);
        if (d < distance && d < 0.5 * model->blocks[b].size)
          {
            distance = d;
            nearest  = b;
          }
      }
    return nearest;
  }



  void Probes::attach(Probe &probe, const int block, const Vec2 &x) const
  {
    const dda::Geometry &g = model->initial;
    probe.block            = block;
    // The three vertices that span most with the first; a block stays an affine image of itself.
    const int first = g.offset[block], end = g.offset[block + 1];
    double    most = 0.;
    for (int v = first + 1; v < end; ++v)
      for (int w = v + 1; w < end; ++w)
        {
          const double area =
            cross(g.vertices[v] - g.vertices[first], g.vertices[w] - g.vertices[first]);
          if (std::abs(area) <= most)
            continue;
          most              = std::abs(area);
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
    const double infinity = std::numeric_limits<double>::infinity();
    if (model == nullptr || model->n_base_nodes() == 0)
      return infinity;
    const std::vector<Vec2> &nodes = model->initial.base_nodes;
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
        const double part = b.x() != a.x() ? (x.x() - a.x()) / (b.x() - a.x()) : 1.;
        surface           = std::max(surface, a.y() + part * (b.y() - a.y()));
      }
    return x.y() - surface;
  }



  int Probes::add(const Vec2 &x, const std::string &name)
  {
    Probe probe;
    int   block = block_at(x);
    if (block < 0 && continuum != nullptr)
      try
        {
          probe.point = continuum->add_point(x, name);
        }
      catch (const InputError &error)
        {
          block = nearest_block(x);
          if (block < 0)
            throw InputError(error.what() + std::string(model != nullptr ? " and the blocks" : ""));
        }
    else if (block < 0)
      block = nearest_block(x);
    if (block >= 0)
      attach(probe, block, x);
    else if (probe.point < 0)
      {
        const double height = height_above_base(x);
        double       size   = 0.; // of a block: a point on the surface may be rounded
        for (int b = 0; model != nullptr && b < model->n_blocks(); ++b)
          size = std::max(size, model->blocks[b].size);
        if (height > 0.5 * size)
          {
            std::ostringstream text;
            text << "the point '" << name << "' at (" << x.x() << ", " << x.y()
                 << ") m is in no block and ";
            if (std::isfinite(height))
              text << height << " m above the base";
            else
              text << "there is no bedrock";
            throw InputError(text.str());
          }
      }
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
    if (probe.point >= 0)
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
    else if (state.blocks.base_displacement.size() > 0)
      motion.displacement = state.blocks.base_displacement.head<2>();
    return motion;
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
