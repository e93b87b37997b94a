// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/downhill.h>

#include <cmath>

namespace hybrid::scene
{
  double downhill_sign(const SectionMesh &mesh)
  {
    auto surface = mesh.lines.find("sliding_surface");
    if (surface == mesh.lines.end() || surface->second.empty())
      surface = mesh.lines.find("ground");
    if (surface == mesh.lines.end() || surface->second.empty())
      return 0.;
    // Where the surface ends in a wall, its foot is the end.
    Vec2 left = mesh.nodes[surface->second.front()[0]], right = left;
    for (const auto &edge : surface->second)
      for (const int node : edge)
        {
          const Vec2 &x = mesh.nodes[node];
          if (x.x() < left.x() || (x.x() == left.x() && x.y() < left.y()))
            left = x;
          if (x.x() > right.x() || (x.x() == right.x() && x.y() < right.y()))
            right = x;
        }
    const double fall = left.y() - right.y();
    if (std::abs(fall) <= 1e-6 * (right.x() - left.x()))
      return 0.;
    return fall > 0. ? 1. : -1.;
  }
} // namespace hybrid::scene
