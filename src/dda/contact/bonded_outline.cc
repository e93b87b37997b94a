// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/bonded_outline.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  int BondedOutline::root(int vertex) const
  {
    while (node[vertex] != vertex)
      vertex = node[vertex];
    return vertex;
  }



  void BondedOutline::unite(const int vertex, const int other)
  {
    const int a = root(vertex), b = root(other);
    node[std::max(a, b)] = std::min(a, b);
  }



  void BondedOutline::bond(const Geometry &geometry, const int edge, const int other)
  {
    is_bonded[edge] = is_bonded[other] = 1;
    unite(edge, geometry.next(other));
    unite(geometry.next(edge), other);
  }



  double BondedOutline::step(const Geometry &geometry,
                             const int       edge,
                             const int       other,
                             const Vec2     &normal) const
  {
    if (node.empty())
      return 0.;
    const std::pair<int, int> ends[]{{geometry.next(edge), other}, {edge, geometry.next(other)}};
    for (const auto &[v, w] : ends)
      if (v != w && root(v) == root(w))
        return std::abs(normal.dot(geometry.vertices[v] - geometry.vertices[w]));
    return 0.;
  }
} // namespace hybrid::dda
