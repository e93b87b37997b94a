// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/overburden.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::scene
{
  namespace
  {
    constexpr double inwards = 1e-6; ///< that a place on an outline is moved, of the way [-]

    std::vector<Vec2> polygon_of(const SectionMesh &mesh, const int *nodes, const std::size_t n)
    {
      std::vector<Vec2> polygon;
      for (std::size_t k = 0; k < n; ++k)
        polygon.push_back(mesh.nodes[nodes[k]]);
      return polygon;
    }



    Vec2 centroid_of(const std::vector<Vec2> &polygon)
    {
      double area = 0.;
      Vec2   moment(0., 0.);
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const Vec2 a   = polygon[k] - polygon[0],
                     b   = polygon[(k + 1) % polygon.size()] - polygon[0];
          const double c = cross(a, b);
          area += c / 2.;
          moment += c * (a + b) / 6.;
        }
      return polygon[0] + moment / area;
    }



    double nudged(const double x, const double inside)
    {
      return x + inwards * (inside - x);
    }
  } // namespace



  Overburden::Overburden(const SectionMesh &mesh, const SceneParameters &scene)
    : around(scene.environment)
  {
    const double g = around.gravity;
    if (around.water_method != WaterMethod::paper)
      {
        water_weight    = around.water_density * g;
        presses_on_rock = around.water_method == WaterMethod::pressures && !scene.has_wet_planes();
      }
    const BlockParameters &blocks = scene.blocks;
    for (std::size_t b = 0; b < mesh.blocks.size() && blocks.enabled; ++b)
      {
        std::vector<Vec2>  polygon = polygon_of(mesh, mesh.blocks[b].data(), mesh.blocks[b].size());
        const Vec2         centroid = centroid_of(polygon);
        const bool         is_wet   = centroid.y() < around.water_at(centroid.x());
        const std::string &region   = mesh.block_region_names[mesh.block_region[b]];
        const double       weight   = g * scene.mass_material(region, is_wet).weighing_density();
        add(mass, std::move(polygon), weight, weight - water_weight);
      }
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      {
        const std::string &region = mesh.bedrock_region_names[mesh.bedrock_region[c]];
        if (!scene.has_continuum() && !scene.has_bedrock_blocks())
          break;
        const double weight = g * scene.bedrock_material(region).weighing_density();
        add(rock,
            polygon_of(mesh, mesh.bedrock_cells[c].data(), 4),
            weight,
            weight - (scene.has_wet_planes() ? water_weight : 0.));
      }
    double right = -std::numeric_limits<double>::infinity();
    left         = std::numeric_limits<double>::infinity();
    for (const Vec2 &corner : corners)
      {
        left  = std::min(left, corner.x());
        right = std::max(right, corner.x());
      }
    const auto n   = mass.solids.size() + rock.solids.size();
    const int  all = 1 + static_cast<int>(2. * std::sqrt(static_cast<double>(n)));
    width          = n > 0 ? (right - left) / all : 1.;
    sort_into_strips(mass, all);
    sort_into_strips(rock, all);
  }



  void Overburden::add(Strips                 &strips,
                       const std::vector<Vec2> polygon,
                       const double            weight,
                       const double            submerged)
  {
    Solid solid{static_cast<int>(corners.size()),
                static_cast<int>(polygon.size()),
                weight,
                submerged,
                polygon[0].x(),
                polygon[0].x(),
                polygon[0].y()};
    for (const Vec2 &corner : polygon)
      {
        solid.left    = std::min(solid.left, corner.x());
        solid.right   = std::max(solid.right, corner.x());
        solid.highest = std::max(solid.highest, corner.y());
        corners.push_back(corner);
      }
    strips.solids.push_back(solid);
  }



  void Overburden::sort_into_strips(Strips &strips, const int n_strips) const
  {
    strips.of_strip.resize(n_strips);
    const auto strip = [&](const double x) {
      return std::clamp(static_cast<int>((x - left) / width), 0, n_strips - 1);
    };
    for (std::size_t s = 0; s < strips.solids.size(); ++s)
      for (int k = strip(strips.solids[s].left); k <= strip(strips.solids[s].right); ++k)
        strips.of_strip[k].push_back(static_cast<int>(s));
  }



  double Overburden::level(const double x) const
  {
    return water_weight > 0. ? around.water_at(x) : -1e300;
  }



  Overburden::Column Overburden::above(const Strips &strips, const double x, const double y) const
  {
    Column       column{0., y};
    const double surface = level(x);
    const int    last    = static_cast<int>(strips.of_strip.size()) - 1;
    for (const int s : strips.of_strip[std::clamp(static_cast<int>((x - left) / width), 0, last)])
      {
        const Solid &solid = strips.solids[s];
        if (x < solid.left || x > solid.right || solid.highest <= y)
          continue;
        crossings.clear();
        for (int k = 0; k < solid.size; ++k)
          {
            const Vec2 &a = corners[solid.first + k],
                       &b = corners[solid.first + (k + 1) % solid.size];
            if ((a.x() <= x) != (b.x() <= x))
              crossings.push_back(a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
          }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
          {
            const double low = std::max(crossings[k], y), high = crossings[k + 1];
            if (high <= low)
              continue;
            const double wet = std::clamp(surface - low, 0., high - low);
            column.weight += solid.unit_weight * (high - low - wet) + solid.submerged_weight * wet;
            column.top = std::max(column.top, high);
          }
      }
    return column;
  }



  double Overburden::in_mass(const Vec2 &place, const Vec2 &inside) const
  {
    return above(mass, nudged(place.x(), inside.x()), place.y()).weight;
  }



  double Overburden::in_bedrock(const Vec2 &place, const Vec2 &inside) const
  {
    const double x       = nudged(place.x(), inside.x());
    const Column of_rock = above(rock, x, place.y());
    const double water = presses_on_rock ? water_weight * std::max(0., level(x) - of_rock.top) : 0.;
    return of_rock.weight + above(mass, x, place.y()).weight + water;
  }
} // namespace hybrid::scene
