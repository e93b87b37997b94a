// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/sole_slip.h>
#include <hybrid/restart/archive.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// The point of a sole that slides.
    Vec2 point_of(const dda::Geometry &g, const dda::Sole &sole)
    {
      return (1. - sole.fraction) * g.vertices[sole.first] +
             sole.fraction * g.vertices[sole.second];
    }



    /// Along a sole, from its first to its second vertex.
    Vec2 direction_of(const dda::Geometry &g, const dda::Sole &sole)
    {
      return (g.vertices[sole.second] - g.vertices[sole.first]).normalized();
    }
  } // namespace



  SoleSlip::SoleSlip(const dda::Model *blocks)
    : model(blocks)
  {
    if (blocks == nullptr || blocks->soles.empty())
      return;
    lines = dda::ground_lines(*blocks);
    std::vector<int> count(lines.size(), 0);
    mean_length.assign(lines.size(), 0.);
    for (const dda::Sole &sole : blocks->soles)
      {
        soles.push_back({sole});
        const int line    = dda::line_below(lines, sole.ground);
        soles.back().line = line;
        ++count[line];
        mean_length[line] += (sole.length - mean_length[line]) / count[line];
      }
  }



  Vec2 SoleSlip::ground_of(const dda::DdaState &state, const Sole &sole)
  {
    const dda::SoleGround &g = sole.ground;
    if (!g.base)
      return (1. - g.fraction) * state.geometry.vertices[g.first] +
             g.fraction * state.geometry.vertices[g.second];
    const auto &u = state.foundation_displacement;
    return (1. - g.fraction) * u.segment<2>(2 * g.first) + g.fraction * u.segment<2>(2 * g.second);
  }



  double SoleSlip::way(const dda::DdaState &state, const Sole &sole) const
  {
    const Vec2 along = direction_of(state.geometry, sole), normal(-along.y(), along.x());
    return surface[sole.line].way_to(point_of(state.geometry, sole) + sole.glued.x() * along +
                                     sole.glued.y() * normal -
                                     (ground_of(state, sole) - sole.rest));
  }



  void SoleSlip::make_surface()
  {
    surface.clear();
    for (std::size_t k = 0; k < lines.size(); ++k)
      surface.emplace_back(at_rest[k], lines[k].closed);
  }



  double SoleSlip::downhill(const dda::Sole &sole) const
  {
    return model->downhill.sign_of(model->initial.block_of[sole.first]);
  }



  void SoleSlip::set_reference(const dda::DdaState &state)
  {
    std::vector<Vec2> nodes = model->initial.foundation_nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nodes[k] += state.foundation_displacement.segment<2>(2 * k);
    at_rest.clear();
    for (std::size_t k = 0; k < lines.size(); ++k)
      at_rest.push_back(
        dda::without_dips(lines[k].places(state.geometry.vertices, nodes), mean_length[k]));
    make_surface();
    for (Sole &sole : soles)
      {
        const dda::SurfaceLine &below = surface[sole.line];
        const Vec2 along = direction_of(state.geometry, sole), normal(-along.y(), along.x()),
                   point = point_of(state.geometry, sole),
                   down  = below.point_at(below.way_to(point)) - point;
        sole.glued       = {down.dot(along), down.dot(normal)};
        sole.rest        = ground_of(state, sole);
        sole.first_way   = way(state, sole);
      }
  }



  std::vector<double> SoleSlip::values(const dda::DdaState &state) const
  {
    std::vector<double> slip;
    slip.reserve(soles.size());
    for (const Sole &sole : soles) // the block is on the other side of the line: it goes against it
      slip.push_back((downhill(sole) < 0. ? 1. : -1.) *
                     surface[sole.line].between(sole.first_way, way(state, sole)));
    return slip;
  }



  double SoleSlip::mean(const std::vector<double> &slip) const
  {
    double sum = 0., width = 0.;
    for (std::size_t k = 0; k < soles.size(); ++k)
      {
        sum += soles[k].length * slip[k];
        width += soles[k].length;
      }
    return width > 0. ? sum / width : 0.;
  }



  double SoleSlip::part_beyond(const std::vector<double> &slip, const double threshold) const
  {
    double beyond = 0., width = 0.;
    for (std::size_t k = 0; k < soles.size(); ++k)
      {
        beyond += std::abs(slip[k]) > threshold ? soles[k].length : 0.;
        width += soles[k].length;
      }
    return width > 0. ? beyond / width : 0.;
  }



  int SoleSlip::farthest(const std::vector<double> &slip)
  {
    int found = 0;
    for (std::size_t k = 0; k < slip.size(); ++k)
      if (std::abs(slip[k]) > std::abs(slip[found]))
        found = static_cast<int>(k);
    return found;
  }



  void SoleSlip::serialize(restart::Archive &archive)
  {
    std::vector<double> reference;
    for (const Sole &sole : soles)
      reference.insert(
        reference.end(),
        {sole.glued.x(), sole.glued.y(), sole.rest.x(), sole.rest.y(), sole.first_way});
    archive(reference, at_rest);
    if (!archive.is_reading())
      return;
    for (std::size_t k = 0; k < soles.size(); ++k)
      {
        const auto of      = [&](const int i) { return reference.at(5 * k + i); };
        soles[k].glued     = {of(0), of(1)};
        soles[k].rest      = {of(2), of(3)};
        soles[k].first_way = of(4);
      }
    if (at_rest.size() == lines.size())
      make_surface();
  }
} // namespace hybrid::output
