// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/boundary_springs.h>

namespace hybrid::continuum
{
  void BoundarySprings::add_stiffness(const NodeMatrices     &matrices,
                                      const std::vector<int> &nodes,
                                      std::vector<double>    &blocks) const
  {
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        for (std::size_t j = 0; j < face.nodes.size(); ++j)
          {
            const int entry = matrices.entry(nodes[face.nodes[i]], nodes[face.nodes[j]]);
            for (int k = 0; k < 4; ++k)
              blocks[4 * entry + k] +=
                face.length * line.mass()(i, j) * face.stiffness(k / 2, k % 2);
          }
  }


  Vec2 BoundarySprings::relative(const Face &face, const int i, const Displacement &u) const
  {
    const double free = face.follows_free ? 1. : 0.;
    Vec2         sum(0., 0.);
    for (std::size_t j = 0; j < face.nodes.size(); ++j)
      {
        const int k = 2 * face.nodes[j];
        sum += face.length * line.mass()(i, j) *
               Vec2(u.model[k] - free * u.free[k], u.model[k + 1] - free * u.free[k + 1]);
      }
    return sum;
  }


  void BoundarySprings::add_forces(const Displacement &u, std::vector<double> &force) const
  {
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        {
          const Vec2 f = face.stiffness * relative(face, static_cast<int>(i), u);
          force[2 * face.nodes[i]] -= f.x();
          force[2 * face.nodes[i] + 1] -= f.y();
        }
  }


  double BoundarySprings::product(const Displacement &a, const Displacement &b) const
  {
    double sum = 0.;
    for (const auto &face : faces)
      {
        const double free = face.follows_free ? 1. : 0.;
        for (std::size_t i = 0; i < face.nodes.size(); ++i)
          {
            const int  k = 2 * face.nodes[i];
            const Vec2 moved(a.model[k] - free * a.free[k], a.model[k + 1] - free * a.free[k + 1]);
            sum += moved.dot(face.stiffness * relative(face, static_cast<int>(i), b));
          }
      }
    return sum;
  }
} // namespace hybrid::continuum
