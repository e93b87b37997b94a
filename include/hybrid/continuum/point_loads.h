// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/scene_parameters.h>

#include <functional>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Forces at points of the bedrock, all with the time function of a Ricker wavelet,
   *   F(t) = F_0 (1 - 2 s^2) exp(-s^2),  s = pi f (t - t_0),  t_0 = start + 1.5 / f
   * (Ricker 1953), zero before the start. In plane strain a point is a line: F_0 in N per metre of
   * thickness.
   */
  class PointLoads
  {
  public:
    PointLoads() = default;

    explicit PointLoads(const scene::PointLoadParameters &parameters);

    /// A force @p peak [N/m] shared by the nodes of a cell with these shape function values.
    void add(const std::vector<int> &nodes, const std::vector<double> &weights, const Vec2 &peak);

    /// The same on other numbers of the nodes.
    PointLoads on_places(const std::function<int(int)> &place_of_node) const;

    bool empty() const
    {
      return shares.empty();
    }

    /// F(t) / F_0 [-].
    double factor(double time) const;

    /// Add the forces at @p time [N/m] to @p force (all unknowns).
    void add_forces(double time, std::vector<double> &force) const;

    /// Work of the peak forces F_0 on the displacements from @p u0 to @p u1 (all unknowns) [J/m].
    double work_of_peak(const std::vector<double> &u0, const std::vector<double> &u1) const;

  private:
    /// Part of a force on one node.
    struct Share
    {
      int  node;
      Vec2 peak; ///< [N/m]
    };

    double             frequency = 0., start = 0.;
    std::vector<Share> shares;
  };
} // namespace hybrid::continuum
