// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/water_on_bedrock.h>

namespace hybrid::coupling
{
  std::unique_ptr<WaterOnBedrock> WaterOnBedrock::make(const dda::Model &blocks)
  {
    if (!blocks.water.changes() || blocks.water.action != dda::Water::Action::pressures)
      return nullptr;
    return std::make_unique<WaterOnBedrock>(blocks);
  }



  WaterOnBedrock::WaterOnBedrock(const dda::Model &blocks)
    : water(blocks.water)
    , nodes(blocks.initial.foundation_nodes)
    , degree(blocks.initial.foundation_degree)
    , gamma(blocks.newmark.gamma)
    , at_rest(water_on_surface(water, nodes, degree))
  {}



  void
  WaterOnBedrock::begin(const double time, const double dt, const Eigen::VectorXd &displacement)
  {
    water_on_surface(water.at(time), nodes, degree, at_start);
    water_on_surface(water.at(time + dt), nodes, degree, at_end);
    at_start -= at_rest;
    at_end -= at_rest;
    moved = displacement;
  }



  double WaterOnBedrock::work(const Eigen::VectorXd &displacement) const
  {
    return (displacement - moved).dot((1. - gamma) * at_start + gamma * at_end);
  }
} // namespace hybrid::coupling
