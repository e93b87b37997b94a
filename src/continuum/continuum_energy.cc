// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/base_memory.h>
#include <hybrid/continuum/continuum_implementation.h>

namespace hybrid::continuum
{
  /*
   * Newmark's discrete identity with 2 beta = gamma, with D the change over a step, F = M a the sum
   * of all forces but contacts, and C that of contacts at its end: D[1/2 v M v] = Du . [(1 - gamma)
   * F_0 + gamma F_1 + C], so each force does the work Du . [(1 - gamma) F_i0 + gamma F_i1],
   * contacts Du . C. That of the elastic forces is -D[1/2 u K u] - (gamma - 1/2) Du K Du. K Du
   * follows from the difference of the equilibrium at both ends; no product with K is needed.
   * A filter takes filter Du . M m in addition, m the remembered change of a.
   */
  namespace
  {
    double dot(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }
  } // namespace


  void Continuum::Implementation::gather_boundary(const std::vector<double> &x,
                                                  std::vector<double>       &on_boundary) const
  {
    const auto &edge_nodes = boundary->boundary_nodes();
    for (std::size_t k = 0; k < edge_nodes.size(); ++k)
      for (int c = 0; c < 2; ++c)
        on_boundary[2 * k + c] = x[2 * edge_nodes[k] + c];
  }


  void Continuum::Implementation::add_boundary(const std::vector<double> &on_boundary,
                                               std::vector<double>       &x) const
  {
    const auto &edge_nodes = boundary->boundary_nodes();
    for (std::size_t k = 0; k < edge_nodes.size(); ++k)
      for (int c = 0; c < 2; ++c)
        x[2 * edge_nodes[k] + c] += on_boundary[2 * k + c];
  }


  Vec2 Continuum::Implementation::base_reaction(const double              *u,
                                                const double              *v,
                                                const double              *a,
                                                const std::vector<double> &edge_force) const
  {
    Vec2 sum(0., 0.);
    for (const int node : boundary->moving_nodes())
      for (int e = matrices.row_start[node]; e < matrices.row_start[node + 1]; ++e)
        {
          const int     j = 2 * matrices.column[e];
          const double  m = matrices.mass[e];
          const double *k = matrices.stiffness.data() + 4 * e;
          const Vec2    strained(u[j] + rayleigh_stiffness * v[j],
                              u[j + 1] + rayleigh_stiffness * v[j + 1]);
          sum += m * Vec2(a[j] + rayleigh_mass * v[j], a[j + 1] + rayleigh_mass * v[j + 1]) +
                 Vec2(k[0] * strained.x() + k[1] * strained.y(),
                      k[2] * strained.x() + k[3] * strained.y());
          if (!matrices.inertia_correction.empty())
            {
              const double *i = matrices.inertia_correction.data() + 4 * e;
              sum += Vec2(i[0] * a[j] + i[1] * a[j + 1], i[2] * a[j] + i[3] * a[j + 1]);
            }
        }
    const auto &edge_nodes = boundary->boundary_nodes();
    for (std::size_t k = 0; k < edge_nodes.size(); ++k)
      if (boundary->supports()[2 * edge_nodes[k]] == Support::base_motion)
        sum -= Vec2(edge_force[2 * k], edge_force[2 * k + 1]);
    return sum;
  }


  Vec2 Continuum::Implementation::base_inertia(const std::vector<double> &a) const
  {
    Vec2 sum(0., 0.);
    if (a.empty())
      return sum;
    for (const int node : boundary->moving_nodes())
      for (int e = matrices.row_start[node]; e < matrices.row_start[node + 1]; ++e)
        {
          const int j = 2 * matrices.column[e];
          sum += matrices.mass[e] * Vec2(a[j], a[j + 1]);
          if (!matrices.inertia_correction.empty())
            {
              const double *m = matrices.inertia_correction.data() + 4 * e;
              sum += Vec2(m[0] * a[j] + m[1] * a[j + 1], m[2] * a[j] + m[3] * a[j + 1]);
            }
        }
    return sum;
  }


  void Continuum::Implementation::add_spring_forces(const ContinuumState &state)
  {
    gather_boundary(state.displacement, edge_u0);
    gather_boundary(u1, edge_u1);
    boundary->springs().add_forces({edge_u0, incoming0.displacement}, edge_force0);
    boundary->springs().add_forces({edge_u1, incoming1.displacement}, edge_force1);
  }


  void Continuum::Implementation::add_spring_energy(ContinuumState &state)
  {
    // What the springs take up beyond the model's work comes from the free field that moves them.
    const double gamma = newmark.gamma;
    for (std::size_t i = 0; i < edge_u0.size(); ++i)
      {
        edge_u1[i]   = (1. - gamma) * edge_u0[i] + gamma * edge_u1[i];
        edge_u_ff[i] = (1. - gamma) * incoming0.displacement[i] + gamma * incoming1.displacement[i];
      }
    const auto &springs = boundary->springs();
    state.energy.input_work += springs.product({edge_du, edge_du_ff}, {edge_u1, edge_u_ff});
    state.energy.integration_loss +=
      (gamma - 0.5) * springs.product({edge_du, edge_du_ff}, {edge_du, edge_du_ff});
  }


  double Continuum::Implementation::add_boundary_energy(ContinuumState &state)
  {
    const std::size_t n          = n_dofs();
    const double      gamma      = newmark.gamma;
    ContinuumEnergy  &energy     = state.energy;
    const auto       &edge_nodes = boundary->boundary_nodes();
    gather_boundary(state.velocity, edge0);
    gather_boundary(v1, edge1);
    boundary->incoming(state.time,
                       state.displacement.data() + n,
                       state.velocity.data() + n,
                       incoming0,
                       columns_stressed(state.maxwell, state.displacement.data() + n));
    boundary->forces(incoming0, edge0, edge_force0);
    boundary->forces(incoming1, edge1, edge_force1);
    const bool springs = !boundary->springs().empty();
    if (springs)
      add_spring_forces(state);
    double boundary_work = 0.;
    double strain_change = 0.;
    for (std::size_t k = 0; k < edge_nodes.size(); ++k)
      for (int c = 0; c < 2; ++c)
        {
          const std::size_t i = 2 * k + c, dof = 2 * edge_nodes[k] + c;
          edge_du[i]    = u1[dof] - state.displacement[dof];
          edge_du_ff[i] = incoming1.displacement[i] - incoming0.displacement[i];
          edge_v_ff[i]  = (1. - gamma) * incoming0.velocity[i] + gamma * incoming1.velocity[i];
          boundary_work += edge_du[i] * ((1. - gamma) * edge_force0[i] + gamma * edge_force1[i]);
          strain_change += edge_du[i] * (edge_force1[i] - edge_force0[i]);
          edge1[i] = (1. - gamma) * edge0[i] + gamma * edge1[i];
        }
    const double loss = boundary->dashpot_loss(edge_du, edge1, edge_du_ff, edge_v_ff);
    energy.boundary_loss += loss;
    energy.input_work += boundary_work + loss;
    if (springs)
      add_spring_energy(state);
    return strain_change;
  }


  double Continuum::Implementation::add_base_energy(ContinuumState &state, const double dt)
  {
    if (boundary->moving_nodes().empty())
      return 0.;
    const double gamma = newmark.gamma;
    const int    node  = boundary->moving_nodes().front();
    const Vec2   moved(u1[2 * node] - state.displacement[2 * node],
                     u1[2 * node + 1] - state.displacement[2 * node + 1]);
    Vec2         r0 =
      base_reaction(state.displacement.data(), state.velocity.data(), a0.data(), edge_force0);
    Vec2 r1 = base_reaction(u1.data(), v1.data(), a1.data(), edge_force1);
    if (slip != nullptr)
      {
        base_excess(state.slip.jump, state.velocity, excess0);
        base_excess(slip->jump(), v1, excess1);
        for (const int moving : boundary->moving_nodes())
          {
            r0 -= Vec2(excess0[2 * moving], excess0[2 * moving + 1]);
            r1 -= Vec2(excess1[2 * moving], excess1[2 * moving + 1]);
          }
      }
    if (maxwell.is_on())
      {
        r0 += base_maxwell(state.maxwell);
        r1 += base_maxwell(maxwell1);
      }
    state.energy.input_work += moved.dot((1. - gamma) * r0 + gamma * r1 + base_inertia(c1));
    take_back_base_work(newmark, dt, moved, r1 - r0, state);
    return moved.dot(r1 - r0);
  }


  double Continuum::Implementation::add_surface_energy(ContinuumState     &state,
                                                       const SurfaceForce &force)
  {
    const double gamma         = newmark.gamma;
    double       strain_change = 0.;
    for (std::size_t k = 0; k < surface.size(); ++k)
      for (int c = 0; c < 2; ++c)
        {
          const std::size_t i = 2 * k + c, dof = 2 * surface[k] + c;
          const double      contact = SurfaceForce::at(force.contacts, i);
          const double      now     = SurfaceForce::at(force.all, i) - contact;
          const double      old     = (state.surface_force.empty() ? 0. : state.surface_force[i]) -
                             (state.surface_contact.empty() ? 0. : state.surface_contact[i]);
          const double moved = u1[dof] - state.displacement[dof];
          state.energy.surface_work += moved * ((1. - gamma) * old + gamma * now + contact);
          strain_change += moved * (now - old);
        }
    return strain_change;
  }


  double Continuum::Implementation::add_point_load_energy(ContinuumState &state, const double dt)
  {
    const double gamma = newmark.gamma, work = point_loads.work_of_peak(state.displacement, u1);
    const double old = point_loads.factor(state.time), now = point_loads.factor(state.time + dt);
    state.energy.input_work += work * ((1. - gamma) * old + gamma * now);
    return work * (now - old);
  }


  void Continuum::Implementation::add_energy(ContinuumState     &state,
                                             const double        dt,
                                             const SurfaceForce &force)
  {
    const std::size_t n      = n_dofs();
    const double      gamma  = newmark.gamma;
    ContinuumEnergy  &energy = state.energy;

    // Du . K Du, from the equilibrium of both ends: what pushes from outside and damping; inertia's
    // part goes with the filter's straight into the loss.
    double strain_change = add_boundary_energy(state);
    strain_change += add_base_energy(state, dt);
    strain_change += add_surface_energy(state, force);
    if (!point_loads.empty())
      strain_change += add_point_load_energy(state, dt);

    for (std::size_t i = 0; i < n; ++i)
      {
        du[i] = u1[i] - state.displacement[i];
        da[i] = (0.5 - gamma) * (a1[i] - a0[i]);
        if (filter > 0.)
          da[i] += filter * state.acceleration_change[i];
      }
    matrices.multiply_inertia(da.data(), product.data());
    energy.integration_loss += dot(du, product);
    if (rayleigh_mass != 0. || rayleigh_stiffness != 0.)
      {
        for (std::size_t i = 0; i < n; ++i)
          mean[i] = (1. - gamma) * state.velocity[i] + gamma * v1[i];
        multiply_rayleigh(mean.data(), load, product2);
        energy.damping_loss += dot(du, load);
        for (std::size_t i = 0; i < n; ++i)
          mean[i] = v1[i] - state.velocity[i];
        multiply_rayleigh(mean.data(), load, product2);
        strain_change -= dot(du, load);
      }
    // Branches are springs to the scheme; what their dashpots take is exact.
    if (maxwell.is_on())
      energy.damping_loss += maxwell.loss(state.maxwell, maxwell1, dt);
    energy.integration_loss += (gamma - 0.5) * strain_change;
  }


  ContinuumEnergy Continuum::audit_energy(const ContinuumState &state) const
  {
    const auto     &m      = *impl;
    ContinuumEnergy energy = state.energy;
    if (m.waves != nullptr) // collect() has put both into the state
      {
        if (m.waves->keeps_rock_work())
          energy.damping_loss += energy.rock_work - energy.strain;
      }
    else
      {
        const std::size_t   n = m.n_dofs();
        std::vector<double> product(n);
        const auto          form = [&](const std::vector<double> &x) {
          double sum = 0.;
          for (std::size_t i = 0; i < n; ++i)
            sum += x[i] * product[i];
          return 0.5 * sum;
        };
        m.matrices.multiply_inertia(state.velocity.data(), product.data());
        energy.kinetic = form(state.velocity);
        m.matrices.multiply_stiffness(state.displacement.data(), product.data());
        energy.strain = form(state.displacement);
      }
    if (m.maxwell.is_on() && m.waves == nullptr)
      energy.strain += m.maxwell.stored_energy(state.maxwell, state.displacement.data());
    if (m.slip != nullptr)
      {
        energy.strain += m.slip->strain_correction(state.slip, state.displacement);
        energy.bedding_static_stress = m.slip->static_energy(state.slip);
      }
    if (!m.boundary->springs().empty())
      {
        BoundaryForces::Incoming in;
        std::vector<double>      u;
        m.boundary->incoming(state.time,
                             state.displacement.data() + m.n_held(),
                             state.velocity.data() + m.n_held(),
                             in);
        for (const int node : m.boundary->boundary_nodes()) // all ranks hold them
          for (int c = 0; c < 2; ++c)
            u.push_back(state.displacement[2 * m.slot(node) + c]);
        energy.boundary_springs =
          0.5 * m.boundary->springs().product({u, in.displacement}, {u, in.displacement});
      }
    return energy;
  }
} // namespace hybrid::continuum
