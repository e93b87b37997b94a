// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/scene/input_error.h>

#include <cmath>
#include <sstream>

namespace hybrid::continuum
{
  namespace
  {
    constexpr double largest_at_blocks = 0.01; ///< of the amplitude at the contact surface [-]

    bool is_side(const std::string &line)
    {
      return line == "left" || line == "right";
    }
  } // namespace



  void Continuum::Implementation::add_wave(const scene::InitialWaveParameters &parameters,
                                           const scene::SectionMesh           &mesh)
  {
    if (parameters.type == scene::WaveType::none)
      return;
    const int       cell       = cell_point(parameters.centre, "Initial wave/Centre").cell;
    const Material &rock_there = cell_material[cell];
    wave                       = std::make_unique<WavePacket>(parameters,
                                        parameters.type == scene::WaveType::pressure
                                                                ? rock_there.p_wave_speed()
                                                                : rock_there.s_wave_speed());
    for (const auto &[name, edges] : mesh.lines)
      {
        // A plane front without end reaches the sides: that is meant.
        if (parameters.width == 0. && is_side(name))
          continue;
        for (const auto &edge : edges)
          for (const int node : edge)
            if (const double fraction = wave->envelope(mesh.nodes[node]);
                fraction > wave_reach.fraction)
              wave_reach = {fraction, mesh.nodes[node]};
      }
    for (const Vec2 &node : surface_positions)
      if (wave->envelope(node) > largest_at_blocks)
        {
          std::ostringstream text;
          text << "Initial wave: at t = 0 it is at (" << node.x() << ", " << node.y()
               << ") m already, on the surface that blocks stand on or may slide to, with "
               << 100. * wave->envelope(node) << " % of its amplitude; at most "
               << 100. * largest_at_blocks
               << " % are allowed: move its centre away or make it shorter";
          throw InputError(text.str());
        }
  }



  void Continuum::Implementation::find_acceleration(ContinuumState &state)
  {
    const std::size_t n = n_dofs();
    const double     *u = state.displacement.data(), *v = state.velocity.data();
    matrices.multiply_stiffness(u, predicted.data());
    multiply_rayleigh(v, load, product2);
    for (std::size_t i = 0; i < n; ++i)
      product[i] = -predicted[i] - load[i];
    if (maxwell.is_on())
      {
        state.maxwell.elastic = predicted; // the branches are at rest
        if (slip != nullptr)
          add_joint_force(-1.,
                          u,
                          state.maxwell.elastic); // joints that may slip have no such damping
        for (std::size_t i = 0; i < n; ++i)
          product[i] -= maxwell.excess_force(state.maxwell, i);
      }
    boundary->incoming(state.time, u + n, v + n, incoming0);
    gather_boundary(state.velocity, edge0);
    boundary->forces(incoming0, edge0, edge_force0);
    if (!boundary->springs().empty())
      {
        gather_boundary(state.displacement, edge_u0);
        boundary->springs().add_forces({edge_u0, incoming0.displacement}, edge_force0);
      }
    add_boundary(edge_force0, product);
    if (!point_loads.empty())
      point_loads.add_forces(state.time, product);

    solve_inertia(product, a1);
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      if (boundary->supports()[dof_of_system[s]] == Support::none)
        state.acceleration[dof_of_system[s]] = a1[dof_of_system[s]];
  }



  Condensation::Factor &Continuum::Implementation::factor_of_inertia()
  {
    if (inertia_factor == nullptr)
      {
        std::vector<double> inertia(matrices.stiffness.size(), 0.);
        for (std::size_t e = 0; e < matrices.mass.size(); ++e)
          inertia[4 * e] = inertia[4 * e + 3] = matrices.mass[e];
        for (std::size_t k = 0; k < matrices.inertia_correction.size(); ++k)
          inertia[k] += matrices.inertia_correction[k];
        inertia_factor = factorisation->factor(pattern.values(inertia));
      }
    return *inertia_factor;
  }



  void Continuum::Implementation::solve_inertia(const std::vector<double> &force,
                                                std::vector<double>       &a)
  {
    const auto &supports = boundary->supports();
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      rhs[s] = supports[dof_of_system[s]] == Support::none ? force[dof_of_system[s]] : 0.;
    factorisation->forward(factor_of_inertia(), rhs, surface_motion);
    factorisation->backward(factor_of_inertia(), solution);
    take_acceleration(a);
  }



  void Continuum::Implementation::take_acceleration(std::vector<double> &a) const
  {
    a.assign(n_dofs(), 0.);
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      if (boundary->supports()[dof_of_system[s]] == Support::none)
        a[dof_of_system[s]] = solution[s];
  }



  void Continuum::start_wave(ContinuumState &state)
  {
    if (impl->wave == nullptr)
      return;
    std::vector<char> at_blocks(impl->nodes->size(), 0);
    for (const int node : impl->surface)
      at_blocks[node] = 1;
    for (std::size_t node = 0; node < at_blocks.size(); ++node)
      {
        const int slot = impl->slot(static_cast<int>(node));
        if (slot < 0 || at_blocks[node])
          continue;
        const WavePacket::Motion motion = impl->wave->at(impl->nodes->positions[node]);
        for (int c = 0; c < 2; ++c)
          if (impl->boundary->supports()[2 * node + c] == Support::none)
            {
              state.displacement[2 * slot + c] += motion.displacement[c];
              state.velocity[2 * slot + c] += motion.velocity[c];
            }
      }
    if (impl->waves != nullptr)
      impl->waves->start(state);
    else
      impl->find_acceleration(state);
  }



  Continuum::WaveReach Continuum::wave_at_boundary() const
  {
    return impl->wave_reach;
  }
} // namespace hybrid::continuum
