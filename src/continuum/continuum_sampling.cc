// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/scene/input_error.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace hybrid::continuum
{
  namespace
  {
    /// A point may lie this part of a cell's size outside: it is moved onto the cell's edge.
    constexpr double tolerated_distance = 0.1;

    /// Cells are equally near within this part of their size.
    constexpr double round_off = 1e-9;

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


  Continuum::Implementation::NearestCell
  Continuum::Implementation::nearest_cell(const Vec2 &position, const double reach) const
  {
    NearestCell best;
    double      height = 0.; // of the best one's centre [m]
    for (std::size_t c = 0; c < nodes->cells.size(); ++c)
      {
        const Vec2 centre = nodes->map(c, Vec2(0.5, 0.5));
        double     radius = 0.;
        for (const int node : rock.cells[c])
          radius = std::max(radius, (rock.nodes[node] - centre).norm());
        if ((position - centre).norm() > std::max(1.5 * radius, radius + reach))
          continue;
        const Vec2   at = local_coordinates(*nodes, c, position);
        const double d  = (nodes->map(c, at) - position).norm() / radius;
        if (d < best.distance - round_off ||
            (d < best.distance + round_off && centre.y() > height + round_off * radius))
          {
            best   = {static_cast<int>(c), at, d};
            height = centre.y();
          }
      }
    return best;
  }


  Continuum::Point Continuum::Implementation::cell_point(const Vec2        &position,
                                                         const std::string &what) const
  {
    const NearestCell nearest = nearest_cell(position, 0.);
    if (nearest.cell < 0 || nearest.distance > tolerated_distance)
      {
        std::ostringstream text;
        text << what << " at (" << position.x() << ", " << position.y()
             << ") m lies outside the bedrock";
        throw InputError(text.str());
      }
    return {nearest.cell, nodes->values(nearest.local)};
  }


  const std::vector<Vec2> &Continuum::node_positions() const
  {
    return impl->nodes->positions;
  }


  const Vec2 &Continuum::node_position(const int node) const
  {
    return impl->nodes->position(node);
  }


  const std::vector<Vec2> &Continuum::corners() const
  {
    return impl->rock.nodes;
  }


  void Continuum::Implementation::forget_others(const std::vector<Point> &points)
  {
    // An initial wave moves all nodes of a rank, and weight acts on all cells.
    if (wave == nullptr)
      nodes->keep_positions(ownership()->portion());
    if (has_weight)
      return;
    const Portion   &drawn = share_of_pictures().cells();
    std::vector<int> sampled;
    for (const Point &point : points)
      sampled.push_back(point.cell);
    std::sort(sampled.begin(), sampled.end());
    nodes->keep_cells([&](const std::size_t cell) {
      return drawn.has(cell) ||
             std::binary_search(sampled.begin(), sampled.end(), static_cast<int>(cell));
    });
  }


  std::vector<std::array<int, 4>>
  Continuum::Implementation::quadrilaterals(const Portion &portion) const
  {
    const auto                     &space = *nodes;
    const int                       p = space.line.degree(), n = p + 1;
    std::vector<std::array<int, 4>> result;
    result.reserve(portion.size() * p * p);
    for (std::size_t c = portion.begin; c < portion.end; ++c)
      {
        const auto &cell   = space.cells[c];
        const bool  turned = space.jacobian(c, Vec2(0.5, 0.5)).determinant() < 0.;
        for (int j = 0; j < p; ++j)
          for (int i = 0; i < p; ++i)
            {
              std::array<int, 4> corners = {cell[j * n + i],
                                            cell[j * n + i + 1],
                                            cell[(j + 1) * n + i + 1],
                                            cell[(j + 1) * n + i]};
              if (turned)
                std::swap(corners[1], corners[3]);
              result.push_back(corners);
            }
      }
    return result;
  }


  std::vector<std::array<int, 4>> Continuum::cells() const
  {
    return impl->quadrilaterals({0, impl->nodes->cells.size()});
  }


  std::size_t Continuum::n_cells() const
  {
    const int p = impl->nodes->line.degree();
    return impl->nodes->cells.size() * p * p;
  }


  std::vector<std::array<int, 4>> Continuum::cells_to_write() const
  {
    return impl->quadrilaterals(impl->share_of_pictures().cells());
  }


  const std::vector<Continuum::Facing> &Continuum::facing_nodes() const
  {
    return impl->facing;
  }


  std::vector<Continuum::Facing> Continuum::Implementation::find_facing_nodes() const
  {
    std::vector<Facing>          result;
    std::set<std::array<int, 3>> seen;
    for (const auto &joint : rock.joints)
      {
        const auto left = nodes->along(joint.first), right = nodes->along(joint.second);
        const Vec2 along = rock.nodes[joint.first.b] - rock.nodes[joint.first.a];
        for (std::size_t k = 0; k < left.size(); ++k)
          if (left[k] != right[k] &&
              seen.insert({joint.plane, std::min(left[k], right[k]), std::max(left[k], right[k])})
                .second)
            result.push_back({left[k], right[k], along.normalized()});
      }
    return result;
  }


  Continuum::Point Continuum::point(const Vec2 &position, const double reach) const
  {
    const auto nearest = impl->nearest_cell(position, reach);
    if (nearest.cell < 0)
      return {-1, {}, std::numeric_limits<double>::infinity()};
    return {nearest.cell,
            impl->nodes->values(nearest.local),
            (impl->nodes->map(nearest.cell, nearest.local) - position).norm()};
  }


  Continuum::Point Continuum::point_beside(const Vec2  &position,
                                           const Vec2  &direction,
                                           const double reach,
                                           double      &alignment) const
  {
    constexpr double least = 0.9; // cosine of 25 degrees
    int              best  = -1;
    alignment              = least;
    for (std::size_t c = 0; c < impl->rock.cells.size(); ++c)
      for (int i = 0; i < 4; ++i)
        {
          const auto  &cell = impl->rock.cells[c]; // counter-clockwise: rock to the left of a -> b
          const Vec2  &a = impl->rock.nodes[cell[i]], &b = impl->rock.nodes[cell[(i + 1) % 4]];
          const Vec2   along = b - a, from = position - a;
          const double length = along.norm(), at = from.dot(along) / length;
          if (at < -reach || at > length + reach || std::abs(cross(along, from)) > reach * length)
            continue;
          const double cosine = along.dot(direction) / length;
          if (cosine > alignment)
            {
              alignment = cosine;
              best      = static_cast<int>(c);
            }
        }
    if (best < 0)
      {
        alignment = 0.;
        return {};
      }
    return {best, impl->nodes->values(local_coordinates(*impl->nodes, best, position))};
  }


  Continuum::Sample Continuum::sample(const ContinuumState &state, const Point &p) const
  {
    Sample result{Vec2(0., 0.), Vec2(0., 0.), Vec2(0., 0.)};
    for (std::size_t k = 0; k < p.weights.size(); ++k)
      {
        const int i = 2 * impl->slot(impl->nodes->cells[p.cell][k]);
        result.displacement +=
          p.weights[k] * Vec2(state.displacement[i], state.displacement[i + 1]);
        result.velocity += p.weights[k] * Vec2(state.velocity[i], state.velocity[i + 1]);
        result.acceleration +=
          p.weights[k] * Vec2(state.acceleration[i], state.acceleration[i + 1]);
      }
    return result;
  }


  std::array<double, 3>
  Continuum::Implementation::static_stress(const int                  cell,
                                           const Vec2                &local,
                                           const std::vector<double> &displacement) const
  {
    std::array<double, 3> result =
      stress(nodes->gradient(cell, local, displacement), cell_material[cell]);
    if (initial_stress != nullptr)
      for (int k = 0; k < 3; ++k)
        result[k] += initial_stress->at(cell, local)[k];
    return result;
  }


  const PictureShare &Continuum::Implementation::share_of_pictures()
  {
    if (picture_share == nullptr)
      picture_share = std::make_unique<PictureShare>(*nodes, ownership());
    return *picture_share;
  }


  Continuum::Picture Continuum::picture(const ContinuumState &state) const
  {
    auto                      &m     = *impl;
    const ElementNodes        &nodes = *m.nodes;
    const auto                &x     = nodes.line.nodes();
    const int                  p     = nodes.line.degree();
    const PictureShare        &share = m.share_of_pictures();
    std::vector<double>        room[4], with_branches;
    const std::vector<double> &u        = share.bring(state.displacement, room[0]);
    const std::vector<double> &v        = share.bring(state.velocity, room[1]);
    const std::vector<double> *stressed = &u;
    if (m.maxwell.is_on())
      {
        with_branches.resize(m.n_held());
        m.maxwell.stressed(state.maxwell, state.displacement.data(), 0, with_branches);
        stressed = &share.bring(with_branches, room[2]);
      }
    const bool                 rests   = m.knows_rest();
    const std::vector<double> &at_rest = share.bring_own(m.static_displacement, rests, room[3]);

    Picture result;
    result.cells = m.quadrilaterals(share.cells());
    for (std::vector<Vec2> *of_nodes : {&result.points, &result.displacement, &result.velocity})
      of_nodes->reserve(share.nodes().size());
    result.region.reserve(result.cells.size());
    result.stress.reserve(result.cells.size());
    result.static_stress.reserve(result.cells.size());
    for (std::size_t node = share.nodes().begin; node < share.nodes().end; ++node)
      {
        const std::size_t i = 2 * share.place(static_cast<int>(node));
        result.points.push_back(nodes.position(static_cast<int>(node)));
        result.displacement.emplace_back(u[i], u[i + 1]);
        result.velocity.emplace_back(v[i], v[i + 1]);
      }
    std::vector<double> of_cell, rest_of_cell;
    for (std::size_t c = share.cells().begin; c < share.cells().end; ++c)
      {
        share.take_cell(nodes.cells[c], *stressed, of_cell);
        share.take_cell(nodes.cells[c], at_rest, rest_of_cell);
        for (int j = 0; j < p; ++j)
          for (int i = 0; i < p; ++i)
            {
              const int  cell = static_cast<int>(c);
              const Vec2 centre(0.5 * (x[i] + x[i + 1]), 0.5 * (x[j] + x[j + 1]));
              result.region.push_back(m.cell_region[c]);
              result.stress.push_back(
                stress(nodes.gradient(cell, centre, of_cell), m.cell_material[c]));
              result.static_stress.push_back(rests ? m.static_stress(cell, centre, rest_of_cell)
                                                   : std::array<double, 3>{0., 0., 0.});
            }
      }
    return result;
  }
} // namespace hybrid::continuum
