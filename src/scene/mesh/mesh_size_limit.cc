// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/mesh_size_limit.h>
#include <hybrid/scene/types.h>

#include <gmsh.h>

#include <cmath>
#include <map>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    constexpr double max_cells = 2e6;


    /// Boundary of a surface, curve by curve.
    struct Boundary
    {
      double edges  = 0.;
      double length = 0.; ///< [m]
      double area   = 0.; ///< within, signed [m2]
    };


    void add_curve(const int curve, const double sign, Boundary &boundary)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      x, parameters;
      gmsh::model::mesh::getNodes(tags, x, parameters, 1, curve, true);
      std::map<std::size_t, Vec2> node;
      for (std::size_t i = 0; i < tags.size(); ++i)
        node[tags[i]] = Vec2(x[3 * i], x[3 * i + 1]);

      std::vector<std::size_t> elements, ends;
      gmsh::model::mesh::getElementsByType(1, elements, ends, curve); // two-node lines
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
        {
          const Vec2 &a = node[ends[i]], &b = node[ends[i + 1]];
          boundary.edges += 1.;
          boundary.length += (b - a).norm();
          boundary.area += 0.5 * sign * cross(a, b);
        }
    }
  } // namespace


  double check_mesh_size(const std::string &file)
  {
    double           cells = 0., edges = 0., length = 0.;
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto &surface : surfaces)
      {
        gmsh::vectorpair curves;
        gmsh::model::getBoundary({surface}, curves, true, true, false);
        Boundary boundary;
        for (const auto &[dim, curve] : curves)
          add_curve(std::abs(curve), curve < 0 ? -1. : 1., boundary);
        if (boundary.length > 0.)
          cells += 2. * std::abs(boundary.area) * std::pow(boundary.edges / boundary.length, 2);
        edges += boundary.edges;
        length += boundary.length;
      }
    if (!(cells > max_cells))
      return cells;
    std::ostringstream text;
    text.precision(2);
    text << "the mesh would have about " << cells << " cells: the edges on the boundaries of its "
         << "surfaces are " << length / edges << " m long on average; at most " << max_cells
         << " cells are allowed, so coarsen it by " << std::sqrt(cells / max_cells)
         << " or look at the unit of the coordinates.";
    throw InputError(file, 0, text.str());
  }
} // namespace hybrid::scene
