// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/scene/input_error.h>

#include <Eigen/LU>

#include <algorithm>
#include <sstream>

namespace hybrid::continuum
{
  namespace
  {
    /// A point may lie this part of a cell's size outside: it is moved onto the cell's edge.
    constexpr double tolerated_distance = 0.1;

    /// Local coordinates of the point of the cell that is nearest (in local coordinates) to @p
    /// position.
    Vec2 local_coordinates(const ElementNodes &nodes, const int cell, const Vec2 &position)
    {
      Vec2 local(0.5, 0.5);
      for (int iteration = 0; iteration < 20; ++iteration)
        {
          const Vec2 step =
            nodes.jacobian(cell, local).inverse() * (position - nodes.map(cell, local));
          local = (local + step).cwiseMax(-0.5).cwiseMin(1.5);
          if (step.norm() < 1e-14)
            break;
        }
      return local.cwiseMax(0.).cwiseMin(1.);
    }

    /// Plane-strain stress xx, yy, xy [Pa].
    std::array<double, 3> stress(const Eigen::Matrix2d &gradient, const Material &material)
    {
      const double lambda = material.lame_lambda(), mu = material.shear_modulus();
      const double volume = lambda * gradient.trace();
      return {volume + 2. * mu * gradient(0, 0),
              volume + 2. * mu * gradient(1, 1),
              mu * (gradient(0, 1) + gradient(1, 0))};
    }
  } // namespace


  int
  Continuum::Implementation::nearest_cell(const Vec2 &position, Vec2 &local, double &distance) const
  {
    int best = -1;
    distance = 1e300;
    for (std::size_t c = 0; c < nodes->cells.size(); ++c)
      {
        const Vec2 centre = nodes->map(c, Vec2(0.5, 0.5));
        double     radius = 0.;
        for (const int node : rock.cells[c])
          radius = std::max(radius, (rock.nodes[node] - centre).norm());
        if ((position - centre).norm() > 1.5 * radius)
          continue;
        const Vec2   at = local_coordinates(*nodes, c, position);
        const double d  = (nodes->map(c, at) - position).norm() / radius;
        if (d < distance - 1e-9)
          {
            distance = d;
            best     = static_cast<int>(c);
            local    = at;
          }
      }
    return best;
  }


  Continuum::Implementation::Point
  Continuum::Implementation::cell_point(const Vec2 &position, const std::string &what) const
  {
    Vec2      local;
    double    distance = 0.;
    const int cell     = nearest_cell(position, local, distance);
    if (cell < 0 || distance > tolerated_distance)
      {
        std::ostringstream text;
        text << what << " at (" << position.x() << ", " << position.y()
             << ") m lies outside the bedrock";
        throw InputError(text.str());
      }
    return {cell, nodes->values(local)};
  }


  int Continuum::add_point(const Vec2 &position, const std::string &name)
  {
    impl->points.push_back(impl->cell_point(position, "Point '" + name + "'"));
    return static_cast<int>(impl->points.size()) - 1;
  }


  Continuum::Sample Continuum::sample(const ContinuumState &state, const int point) const
  {
    const auto &p = impl->points.at(point);
    Sample      result{Vec2(0., 0.), Vec2(0., 0.), Vec2(0., 0.)};
    for (std::size_t k = 0; k < p.weights.size(); ++k)
      {
        const int i = 2 * impl->nodes->cells[p.cell][k];
        result.displacement +=
          p.weights[k] * Vec2(state.displacement[i], state.displacement[i + 1]);
        result.velocity += p.weights[k] * Vec2(state.velocity[i], state.velocity[i + 1]);
        result.acceleration +=
          p.weights[k] * Vec2(state.acceleration[i], state.acceleration[i + 1]);
      }
    return result;
  }


  Continuum::Picture Continuum::picture(const ContinuumState &state) const
  {
    const auto &nodes = *impl->nodes;
    const auto &x     = nodes.line.nodes();
    const int   p = nodes.line.degree(), n = p + 1;
    Picture     result;
    result.points = nodes.positions;
    for (std::size_t k = 0; k < nodes.positions.size(); ++k)
      {
        result.displacement.emplace_back(state.displacement[2 * k], state.displacement[2 * k + 1]);
        result.velocity.emplace_back(state.velocity[2 * k], state.velocity[2 * k + 1]);
      }
    for (std::size_t c = 0; c < nodes.cells.size(); ++c)
      {
        const auto &cell   = nodes.cells[c];
        const bool  turned = nodes.jacobian(c, Vec2(0.5, 0.5)).determinant() < 0.;
        for (int j = 0; j < p; ++j)
          for (int i = 0; i < p; ++i)
            {
              std::array<int, 4> corners = {cell[j * n + i],
                                            cell[j * n + i + 1],
                                            cell[(j + 1) * n + i + 1],
                                            cell[(j + 1) * n + i]};
              if (turned)
                std::swap(corners[1], corners[3]);
              result.cells.push_back(corners);
              result.region.push_back(impl->cell_region[c]);
              const Vec2 centre(0.5 * (x[i] + x[i + 1]), 0.5 * (x[j] + x[j + 1]));
              result.stress.push_back(
                stress(nodes.gradient(c, centre, state.displacement), impl->cell_material[c]));
              if (impl->static_displacement.empty())
                result.static_stress.push_back({0., 0., 0.});
              else
                result.static_stress.push_back(
                  stress(nodes.gradient(c, centre, impl->static_displacement),
                         impl->cell_material[c]));
            }
      }
    return result;
  }
} // namespace hybrid::continuum
