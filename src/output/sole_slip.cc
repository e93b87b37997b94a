// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/sole_slip.h>
#include <hybrid/restart/archive.h>

#include <cmath>

namespace hybrid::output
{
  SoleSlip::SoleSlip(const dda::Model *blocks)
    : model(blocks)
  {
    if (blocks == nullptr)
      return;
    for (const dda::Sole &sole : blocks->soles)
      soles.push_back({sole});
  }



  Vec2 SoleSlip::place(const dda::DdaState &state, const Sole &sole)
  {
    const std::vector<Vec2> &v = state.geometry.vertices;
    const dda::SoleGround   &g = sole.ground;
    const Vec2 x = (1. - sole.fraction) * v[sole.first] + sole.fraction * v[sole.second];
    if (!g.base)
      return x - (1. - g.fraction) * v[g.first] - g.fraction * v[g.second];
    const auto &u = state.foundation_displacement;
    return x - (1. - g.fraction) * u.segment<2>(2 * g.first) -
           g.fraction * u.segment<2>(2 * g.second);
  }



  double SoleSlip::downhill(const dda::Sole &sole) const
  {
    return model->downhill.sign_of(model->initial.block_of[sole.first]);
  }



  void SoleSlip::set_reference(const dda::DdaState &state)
  {
    for (Sole &sole : soles)
      {
        const Vec2 edge =
          state.geometry.vertices[sole.second] - state.geometry.vertices[sole.first];
        sole.start = place(state, sole);
        sole.along = (downhill(sole) < 0. ? -1. : 1.) / edge.norm() * edge;
      }
  }



  std::vector<double> SoleSlip::values(const dda::DdaState &state) const
  {
    std::vector<double> slip;
    slip.reserve(soles.size());
    for (const Sole &sole : soles)
      slip.push_back((place(state, sole) - sole.start).dot(sole.along));
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
    std::vector<Vec2> reference;
    for (const Sole &sole : soles)
      {
        reference.push_back(sole.start);
        reference.push_back(sole.along);
      }
    archive(reference);
    for (std::size_t k = 0; archive.is_reading() && k < soles.size(); ++k)
      {
        soles[k].start = reference.at(2 * k);
        soles[k].along = reference.at(2 * k + 1);
      }
  }
} // namespace hybrid::output
