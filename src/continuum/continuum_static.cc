// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/condensed_factor.h>
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/continuum/restrained_rock.h>
#include <hybrid/continuum/stress_load.h>

#include <Eigen/LU>

namespace hybrid::continuum
{
  namespace
  {
    constexpr int max_static_corrections = 20;

    /// Diagonal of the box round all planes [m]: what slips by more is held by nothing but
    /// round-off.
    double extent(const BeddingPlanes &planes)
    {
      Vec2 lower = planes.points().front().position, upper = lower;
      for (const BeddingPlanes::Point &point : planes.points())
        {
          lower = lower.cwiseMin(point.position);
          upper = upper.cwiseMax(point.position);
        }
      return (upper - lower).norm();
    }

    /// Weight of all cells, and what pushes them along +x, on their nodes [N/m].
    std::vector<double> weight_load(const ElementNodes  &nodes,
                                    const CellMaterials &material,
                                    const double         gravity,
                                    const double         horizontal)
    {
      const LagrangeLine line(nodes.line.degree()); // with exact integrals
      const int          n = line.degree() + 1;
      // The Jacobian of a straight-sided cell is linear in x and y: integrate N times a linear
      // function.
      std::vector<double> flat(n), sloped(n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          {
            flat[i] += line.mass()(i, j);
            sloped[i] += line.mass()(i, j) * line.nodes()[j];
          }
      std::vector<double> load(2 * static_cast<std::size_t>(nodes.size()), 0.);
      for (std::size_t c = 0; c < nodes.cells.size(); ++c)
        {
          const double j00 = nodes.jacobian(c, Vec2(0., 0.)).determinant();
          const double j10 = nodes.jacobian(c, Vec2(1., 0.)).determinant() - j00;
          const double j01 = nodes.jacobian(c, Vec2(0., 1.)).determinant() - j00;
          for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
              {
                const double area =
                  j00 * flat[i] * flat[j] + j10 * sloped[i] * flat[j] + j01 * flat[i] * sloped[j];
                double *node = &load[2 * nodes.cells[c][j * n + i]];
                node[0] += horizontal * material[c].density * area;
                node[1] -= gravity * material[c].weighing_density() * area;
              }
        }
      return load;
    }
  } // namespace


  std::vector<char> Continuum::Implementation::static_supports() const
  {
    std::vector<char> supported(n_dofs(), 0);
    for (const auto *side : {&left_nodes, &right_nodes})
      for (const int node : *side)
        supported[2 * node] = 1;
    for (const int node : base_nodes)
      supported[2 * node] = supported[2 * node + 1] = 1;
    return supported;
  }



  void Continuum::Implementation::find_pull(const std::vector<double> &forces,
                                            StaticSlip                &result) const
  {
    constexpr double    told = 1e-3; // of the rock's weight
    std::vector<double> inner(n_dofs());
    matrices.multiply_stiffness(static_displacement.data(), inner.data());
    double weight = 0.;
    for (std::size_t k = 1; k < forces.size(); k += 2)
      weight += std::abs(forces[k]);
    for (const SidePart &part : side_parts)
      {
        double pull = 0.;
        Vec2   middle(0., 0.);
        for (const int node : part.nodes)
          {
            pull += part.outward * (inner[2 * node] - forces[2 * node]);
            middle += nodes->positions[node] / static_cast<double>(part.nodes.size());
          }
        if (pull > std::max(result.pull, told * weight))
          {
            result.pull   = pull;
            result.pulled = middle;
          }
      }
  }



  StaticSlip Continuum::Implementation::solve_static_waves(const std::vector<double> &forces)
  {
    const std::vector<char> supported = static_supports();
    const RestrainedRock    restrained(
      {waves->rock(), rock, *nodes, cell_material, joint_stiffness, supported});
    RestrainedRock::Solution found = restrained.solve(forces);
    static_displacement.clear();
    StaticSlip result;
    result.solved = found.converged;
    if (result.solved)
      static_displacement = std::move(found.displacement);
    return result;
  }



  bool Continuum::Implementation::knows_rest() const
  {
    int knows = static_displacement.empty() ? 0 : 1; // a rank without cells has nothing either
    if (const Ownership *shared = ownership())
      MPI_Allreduce(MPI_IN_PLACE, &knows, 1, MPI_INT, MPI_MAX, shared->communicator());
    return knows != 0;
  }



  StaticSlip Continuum::solve_static_state(const Eigen::VectorXd                     &surface_force,
                                           const double                               gravity,
                                           const double                               horizontal,
                                           const std::function<double(const Vec2 &)> &pore_pressure)
  {
    auto               &m    = *impl;
    std::vector<double> load = weight_load(*m.nodes, m.cell_material, gravity, horizontal);
    for (std::size_t k = 0; k < m.surface.size() && surface_force.size() > 0; ++k)
      for (int c = 0; c < 2; ++c)
        load[2 * m.surface[k] + c] += surface_force[2 * k + c];
    if (m.initial_stress != nullptr)
      m.initial_stress->subtract_from(load);
    if (m.waves != nullptr)
      return m.solve_static_waves(load);
    if (m.slip != nullptr && pore_pressure)
      {
        add_stress_load(
          *m.nodes,
          [&](const int cell, const Vec2 &local) {
            const double p = pore_pressure(m.nodes->map(cell, local));
            return Eigen::Vector3d(p, p, 0.);
          },
          1.,
          load);
        m.slip->add_pore_forces(pore_pressure, load);
      }

    const std::vector<char> supported = m.static_supports();
    std::vector<int>        number(m.n_dofs(), -1), dofs;
    for (std::size_t i = 0; i < m.n_dofs(); ++i)
      if (!supported[i])
        {
          number[i] = static_cast<int>(dofs.size());
          dofs.push_back(static_cast<int>(i));
        }

    const SystemPattern    pattern = make_system_pattern(m.matrices, number, dofs, supported);
    CondensedFactorisation system(pattern.column_start, pattern.row, 0);
    const auto             factor = system.factor(pattern.values(m.matrices.stiffness));
    std::vector<double>    b(dofs.size()), x(dofs.size());
    for (std::size_t s = 0; s < dofs.size(); ++s)
      b[s] = load[dofs[s]];
    Eigen::VectorXd none(0);
    system.forward(*factor, b, none);
    system.backward(*factor, x);
    const auto take = [&] {
      m.static_displacement.assign(m.n_dofs(), 0.);
      for (std::size_t s = 0; s < dofs.size(); ++s)
        m.static_displacement[dofs[s]] = x[s];
    };
    take();
    if (m.slip == nullptr)
      return {};

    // Planes that gravity alone brings to their limit slip until the rest can carry it.
    std::vector<double>   all        = load;
    const Eigen::MatrixXd relaxation = m.slip_relaxation(number, system, *factor);
    if (m.initial_stress != nullptr)
      m.slip->add_rest(m.initial_stress->plane_tractions());
    m.slip->begin_rest();
    const std::vector<double> elastic = m.static_displacement;
    SlipStatus                status  = SlipStatus::changed;
    for (int k = 0; k < max_static_corrections; ++k)
      {
        status = m.slip->solve_rest(relaxation, m.static_displacement);
        if (status != SlipStatus::changed)
          break;
        load.assign(load.size(), 0.);
        m.slip->add_load_change(load);
        for (std::size_t i = 0; i < load.size(); ++i)
          all[i] += load[i];
        for (std::size_t s = 0; s < dofs.size(); ++s)
          b[s] += load[dofs[s]];
        system.forward(*factor, b, none);
        system.backward(*factor, x);
        take();
      }
    StaticSlip result  = m.slip->slip_at_rest();
    result.equilibrium = status == SlipStatus::settled && result.largest < extent(m.slip->planes());
    if (!result.equilibrium)
      {
        m.static_displacement = elastic;
        m.slip->begin_rest();
      }
    if (result.equilibrium && (result.slipping > 0 || horizontal != 0.))
      m.find_pull(all, result);
    m.slip->keep_rest(m.static_displacement);
    if (!result.equilibrium)
      {
        const BeddingPlanes::Point &point = m.slip->most_loaded_at_rest();
        result.where                      = point.position;
        result.plane                      = point.plane;
      }
    return result;
  }
} // namespace hybrid::continuum
