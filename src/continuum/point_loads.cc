// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/point_loads.h>

#include <cmath>

namespace hybrid::continuum
{
  PointLoads::PointLoads(const scene::PointLoadParameters &parameters)
    : frequency(parameters.frequency)
    , start(parameters.start)
  {}


  void PointLoads::add(const std::vector<int>    &nodes,
                       const std::vector<double> &weights,
                       const Vec2                &peak)
  {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (weights[k] != 0.)
        shares.push_back({nodes[k], weights[k] * peak});
  }


  PointLoads PointLoads::on_places(const std::function<int(int)> &place_of_node) const
  {
    PointLoads result = *this;
    for (Share &share : result.shares)
      share.node = place_of_node(share.node);
    return result;
  }


  double PointLoads::factor(const double time) const
  {
    if (time < start)
      return 0.;
    const double x = M_PI * (frequency * (time - start) - 1.5), s = x * x;
    return (1. - 2. * s) * std::exp(-s);
  }


  void PointLoads::add_forces(const double time, std::vector<double> &force) const
  {
    const double now = factor(time);
    for (const Share &share : shares)
      for (int c = 0; c < 2; ++c)
        force[2 * share.node + c] += now * share.peak[c];
  }


  double PointLoads::work_of_peak(const std::vector<double> &u0,
                                  const std::vector<double> &u1) const
  {
    double work = 0.;
    for (const Share &share : shares)
      for (int c = 0; c < 2; ++c)
        {
          const int i = 2 * share.node + c;
          work += share.peak[c] * (u1[i] - u0[i]);
        }
    return work;
  }
} // namespace hybrid::continuum
