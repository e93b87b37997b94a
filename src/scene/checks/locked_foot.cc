// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/locked_foot.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace hybrid::scene
{
  namespace
  {
    constexpr double degree   = 3.14159265358979323846 / 180.;
    constexpr double bend     = 3. * degree;   ///< least that is told
    constexpr double steepest = 89. * degree;  ///< on which blocks rest
    constexpr double wall     = -30. * degree; ///< what rises more is meant to hold
    constexpr double near     = 1e-3;          ///< of an edge's length: in one place [-]

    /// Where the ground comes to a node and where it goes on, downhill.
    struct Kink
    {
      Vec2   above, corner, below;                     ///< [m]
      double flattens;                                 ///< by this angle [rad]
      bool   bears_above = false, bears_below = false; ///< an edge of a block, from the corner on
    };


    /// Angle by which the way from @p a to @p b falls [rad].
    double fall(const Vec2 &a, const Vec2 &b)
    {
      return std::atan2(a.y() - b.y(), std::abs(b.x() - a.x()));
    }


    /// Of the lines that blocks lie on, along x and against it, by the x of their corners.
    std::vector<Kink> kinks_of(const SectionMesh &mesh)
    {
      std::map<int, std::vector<int>> beside; // nodes at the other ends of a node's edges
      for (const char *const name : {"sliding_surface", "ground"})
        if (mesh.lines.count(name) > 0)
          for (const auto &[a, b] : mesh.lines.at(name))
            {
              beside[a].push_back(b);
              beside[b].push_back(a);
            }
      std::vector<Kink> kinks;
      for (const auto &[node, others] : beside)
        for (const int from : others)
          for (const int to : others)
            {
              const Vec2 &above = mesh.nodes[from], &corner = mesh.nodes[node],
                         &below = mesh.nodes[to];
              const double into = corner.x() - above.x(), out = below.x() - corner.x();
              if (!(into * out > 0.))
                continue;
              const double before = fall(above, corner), after = fall(corner, below);
              if (before > 0. && before < steepest && after > wall && before - after >= bend)
                kinks.push_back({above, corner, below, before - after, false, false});
            }
      std::sort(kinks.begin(), kinks.end(), [](const Kink &a, const Kink &b) {
        return a.corner.x() < b.corner.x();
      });
      return kinks;
    }


    /// Tell each kink what lies on it.
    void look_at_block(const std::vector<Vec2> &outline, std::vector<Kink> &kinks)
    {
      for (std::size_t k = 0; k < outline.size(); ++k)
        for (const std::size_t step : {std::size_t(1), outline.size() - 1})
          {
            const Vec2  &corner = outline[k];
            const Vec2   edge   = outline[(k + step) % outline.size()] - corner;
            const double size   = near * edge.norm();
            auto         kink =
              std::lower_bound(kinks.begin(),
                               kinks.end(),
                               corner.x() - size,
                               [](const Kink &a, const double x) { return a.corner.x() < x; });
            for (; kink != kinks.end() && kink->corner.x() <= corner.x() + size; ++kink)
              {
                if ((kink->corner - corner).norm() > size)
                  continue;
                const auto is_along = [&](const Vec2 &way) {
                  return std::abs(cross(way, edge)) < size * way.norm() && way.dot(edge) > 0.;
                };
                kink->bears_above = kink->bears_above || is_along(kink->above - kink->corner);
                kink->bears_below = kink->bears_below || is_along(kink->below - kink->corner);
              }
          }
    }
  } // namespace


  std::string locked_foot(const SectionMesh &mesh)
  {
    std::vector<Kink> kinks = kinks_of(mesh);
    std::vector<Vec2> outline;
    for (const auto &block : mesh.blocks)
      {
        outline.clear();
        for (const int node : block)
          outline.push_back(mesh.nodes[node]);
        look_at_block(outline, kinks);
      }
    const Kink *sharpest = nullptr;
    for (const Kink &kink : kinks)
      if (kink.bears_above && !kink.bears_below &&
          (sharpest == nullptr || kink.flattens > sharpest->flattens))
        sharpest = &kink;
    if (sharpest == nullptr)
      return "";
    std::ostringstream text;
    const Vec2         corner = sharpest->corner + Vec2::Zero(); // no -0
    text << "the mass ends at (" << corner.x() << ", " << corner.y()
         << ") m on ground that falls by " << std::round(sharpest->flattens / degree)
         << " degrees less than the surface below the mass: its foot cannot leave without "
            "climbing, so that it stands too firmly, whatever its strength; let the surface come "
            "out above that kink";
    return text.str();
  }
} // namespace hybrid::scene
