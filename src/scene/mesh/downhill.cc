// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/downhill.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Sign of x towards the lower one of a line's two ends, 0 if they are level or there is no
    /// such line. @param foot: where it ends in a wall, the wall's foot is the end, else its top
    double sign_along(const SectionMesh &mesh, const std::string &name, const bool foot)
    {
      const auto line = mesh.lines.find(name);
      if (line == mesh.lines.end() || line->second.empty())
        return 0.;
      const double up   = foot ? 1. : -1.;
      Vec2         left = mesh.nodes[line->second.front()[0]], right = left;
      for (const auto &edge : line->second)
        for (const int node : edge)
          {
            const Vec2 &x = mesh.nodes[node];
            if (x.x() < left.x() || (x.x() == left.x() && up * x.y() < up * left.y()))
              left = x;
            if (x.x() > right.x() || (x.x() == right.x() && up * x.y() < up * right.y()))
              right = x;
          }
      const double fall = left.y() - right.y();
      if (std::abs(fall) <= 1e-6 * (right.x() - left.x()))
        return 0.;
      return fall > 0. ? 1. : -1.;
    }



    bool has(const SectionMesh &mesh, const std::string &name)
    {
      const auto line = mesh.lines.find(name);
      return line != mesh.lines.end() && !line->second.empty();
    }
  } // namespace



  double downhill_sign(const SectionMesh &mesh)
  {
    const double sign =
      sign_along(mesh, has(mesh, "sliding_surface") ? "sliding_surface" : "ground", true);
    return sign != 0. ? sign : sign_along(mesh, "mass_surface", false);
  }
} // namespace hybrid::scene
