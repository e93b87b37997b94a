// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/continuum/implicit_waves.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <utility>

namespace hybrid::continuum
{
  namespace
  {
    constexpr std::size_t kept_step_sizes = 3;
  }


  Continuum::Implementation::StepMatrix &Continuum::Implementation::step_matrix(const double dt)
  {
    for (auto it = step_matrices.begin(); it != step_matrices.end(); ++it)
      if (it->dt == dt)
        {
          step_matrices.splice(step_matrices.begin(), step_matrices, it);
          return step_matrices.front();
        }

    const Stopwatch watch(factor_time);
    // A = K + M / (beta dt^2) + gamma / (beta dt) C,  C = alpha_M M + beta_K K + dashpots; the
    // correction of the inertia is no part of C. Maxwell branches scale K.
    const double to_rate = newmark.gamma / (newmark.beta * dt);
    const double of_mass = 1. / (newmark.beta * dt * dt) + to_rate * rayleigh_mass;
    double       excess  = to_rate * rayleigh_stiffness; // of K beyond the elastic one
    if (maxwell.is_on())
      excess += maxwell.step_modulus(dt);
    std::vector<double> blocks = matrices.stiffness;
    for (std::size_t e = 0; e < matrices.mass.size(); ++e)
      for (int k = 0; k < 4; ++k)
        blocks[4 * e + k] =
          (1. + excess) * blocks[4 * e + k] + (k % 3 == 0 ? of_mass * matrices.mass[e] : 0.);
    for (std::size_t k = 0; k < matrices.inertia_correction.size(); ++k)
      blocks[k] += matrices.inertia_correction[k] / (newmark.beta * dt * dt);
    boundary->add_dashpots(matrices, to_rate, blocks);
    boundary->add_springs(matrices, blocks);
    if (slip != nullptr && excess != 0.)
      slip->planes().add_stiffness(matrices, -excess, blocks);

    if (step_matrices.size() >= kept_step_sizes)
      step_matrices.pop_back();
    StepMatrix made;
    made.dt                = dt;
    made.factor            = factorisation->factor(pattern.values(blocks));
    made.surface_stiffness = factorisation->surface_stiffness(*made.factor);
    made.base              = base_coupling(blocks);
    if (slip != nullptr)
      made.slip_relaxation = slip_relaxation(free_unknowns(), *factorisation, *made.factor);
    step_matrices.push_front(std::move(made));
    return step_matrices.front();
  }


  std::vector<Continuum::Implementation::BaseCoupling>
  Continuum::Implementation::base_coupling(const std::vector<double> &blocks) const
  {
    std::vector<BaseCoupling> result;
    if (boundary->moving_nodes().empty())
      return result;
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      {
        const int    dof = dof_of_system[s], node = dof / 2;
        BaseCoupling coupling{static_cast<int>(s), 0., 0.};
        for (int e = matrices.row_start[node]; e < matrices.row_start[node + 1]; ++e)
          if (boundary->supports()[2 * matrices.column[e]] == Support::base_motion)
            {
              coupling.x += blocks[4 * e + 2 * (dof % 2)];
              coupling.y += blocks[4 * e + 2 * (dof % 2) + 1];
            }
        if (boundary->supports()[dof] == Support::none && (coupling.x != 0. || coupling.y != 0.))
          result.push_back(coupling);
      }
    return result;
  }


  void Continuum::Implementation::multiply_rayleigh(const double        *x,
                                                    std::vector<double> &y,
                                                    std::vector<double> &work)
  {
    std::fill(y.begin(), y.end(), 0.);
    if (rayleigh_mass != 0.)
      {
        matrices.multiply_mass(x, work.data());
        for (std::size_t i = 0; i < n_dofs(); ++i)
          y[i] += rayleigh_mass * work[i];
      }
    if (rayleigh_stiffness != 0.)
      {
        matrices.multiply_stiffness(x, work.data());
        for (std::size_t i = 0; i < n_dofs(); ++i)
          y[i] += rayleigh_stiffness * work[i];
        if (slip != nullptr)
          add_joint_force(-rayleigh_stiffness, x, y);
      }
  }


  void Continuum::Implementation::predict(const ContinuumState &state, const double dt)
  {
    StepMatrix &matrix = step_matrix(dt);
    newmark_acceleration(state);
    filter = newmark.filter_in(dt, state.last_step);
    predict_columns(state, dt);
    add_predicted_inertia(state, dt);
    add_rock_forces(state, dt);
    add_boundary_forces();
    if (!point_loads.empty())
      point_loads.add_forces(state.time + dt, product);
    set_right_hand_side(matrix, state.time + dt, dt);
    factorisation->forward(*matrix.factor, rhs, surface_load);
  }


  void Continuum::Implementation::predict_columns(const ContinuumState &state, const double dt)
  {
    const std::size_t n     = n_dofs();
    const bool        keeps = newmark.filter > 0.;
    if (slip != nullptr)
      boundary->set_column_rest(slip->rest_tractions(), slip->rest_failures());
    columns_settled =
      boundary->step_columns({state.displacement.data() + n,
                              state.velocity.data() + n,
                              state.acceleration.data() + n,
                              keeps ? state.acceleration_change.data() + n : nullptr,
                              state.last_step,
                              maxwell.is_on() ? state.maxwell.strain.data() + n : nullptr,
                              n + column_u.size()},
                             {column_u.data(),
                              column_v.data(),
                              column_a.data(),
                              keeps ? column_change.data() : nullptr,
                              maxwell.is_on() ? maxwell1.strain.data() + n : nullptr},
                             state.time,
                             dt,
                             state.column_slip);
    boundary->incoming(state.time + dt,
                       column_u.data(),
                       column_v.data(),
                       incoming1,
                       columns_stressed(maxwell1, column_u.data()));
  }


  void Continuum::Implementation::add_predicted_inertia(const ContinuumState &state,
                                                        const double          dt)
  {
    const double *u = state.displacement.data(), *v = state.velocity.data();
    const double *change     = state.acceleration_change.data();
    const double  beta       = newmark.beta;
    const double  to_inertia = 1. / (beta * dt * dt);
    for (std::size_t i = 0; i < n_dofs(); ++i)
      {
        predicted[i] = u[i] + dt * v[i] + dt * dt * (0.5 - beta) * a0[i];
        if (filter > 0.)
          predicted[i] -= 0.5 * dt * dt * filter * change[i];
        rate[i] = 2. / dt * u[i] + v[i]; // v1 = 2 (u1 - u0) / dt - v0, as 2 beta = gamma
        load[i] = to_inertia * predicted[i] + rayleigh_mass * rate[i];
      }
    for (const int i : fixed_dofs)
      predicted[i] = rate[i] = load[i] = 0.;
    matrices.multiply_mass(load.data(), product.data());
    matrices.add_inertia_correction(to_inertia, predicted.data(), product.data());
  }


  void Continuum::Implementation::add_rock_forces(const ContinuumState &state, const double dt)
  {
    if (rayleigh_stiffness != 0.)
      {
        matrices.multiply_stiffness(rate.data(), product2.data());
        for (std::size_t i = 0; i < n_dofs(); ++i)
          product[i] += rayleigh_stiffness * product2[i];
        if (slip != nullptr)
          add_joint_force(-rayleigh_stiffness, rate.data(), product);
      }
    if (maxwell.is_on())
      maxwell.add_past(state.maxwell, dt, product);
    if (slip != nullptr)
      {
        slip->begin(state.slip);
        slip->add_load(state.slip.jump, 1., product);
      }
  }


  void Continuum::Implementation::add_boundary_forces()
  {
    // t_in + Z (v_ff - v) with v = 2 u / dt - rate; the first part of v is in A.
    gather_boundary(rate, edge0);
    for (double &x : edge0)
      x = -x;
    boundary->forces(incoming1, edge0, edge_force1);
    if (!boundary->springs().empty())
      {
        std::fill(edge0.begin(), edge0.end(), 0.); // k u is in A
        boundary->springs().add_forces({edge0, incoming1.displacement}, edge_force1);
      }
    add_boundary(edge_force1, product);
  }


  void Continuum::Implementation::set_right_hand_side(const StepMatrix &matrix,
                                                      const double      time,
                                                      const double      dt)
  {
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      rhs[s] =
        boundary->supports()[dof_of_system[s]] == Support::none ? product[dof_of_system[s]] : 0.;
    if (matrix.base.empty())
      return;
    const int  node  = boundary->moving_nodes().front();
    const Vec2 moved = Vec2(predicted[2 * node], predicted[2 * node + 1]) +
                       newmark.beta * dt * dt * boundary->base_acceleration(time);
    for (const auto &coupling : matrix.base)
      rhs[coupling.system] -= coupling.x * moved.x() + coupling.y * moved.y();
  }


  void Continuum::Implementation::newmark_acceleration(const ContinuumState &state)
  {
    std::copy(state.acceleration.begin(), state.acceleration.begin() + n_dofs(), a0.begin());
    if (!state.contact_acceleration.empty())
      for (std::size_t i = 0; i < n_dofs(); ++i)
        a0[i] -= state.contact_acceleration[i];
  }


  void Continuum::Implementation::take_displacement(const ContinuumState &state, const double dt)
  {
    const Vec2  base     = boundary->base_acceleration(state.time + dt);
    const auto &supports = boundary->supports();
    for (std::size_t i = 0; i < n_dofs(); ++i)
      if (supports[i] == Support::none)
        u1[i] = solution[system_of_dof[i]];
      else
        u1[i] = supports[i] == Support::base_motion
                  ? predicted[i] + newmark.beta * dt * dt * base[i % 2]
                  : 0.;
  }


  void Continuum::Implementation::finish(ContinuumState     &state,
                                         const double        dt,
                                         const SurfaceForce &force)
  {
    const std::size_t n    = n_dofs();
    const double      beta = newmark.beta, gamma = newmark.gamma;
    const double      to_inertia = 1. / (beta * dt * dt);
    const Vec2        base       = boundary->base_acceleration(state.time + dt);
    const auto       &supports   = boundary->supports();
    take_displacement(state, dt);
    for (std::size_t i = 0; i < n; ++i)
      {
        if (supports[i] == Support::none)
          a1[i] = to_inertia * (u1[i] - predicted[i]);
        else
          a1[i] = supports[i] == Support::base_motion ? base[i % 2] : 0.;
        v1[i] = supports[i] == Support::zero
                  ? 0.
                  : state.velocity[i] + dt * ((1. - gamma) * a0[i] + gamma * a1[i]);
        if (filter > 0. && supports[i] != Support::zero)
          v1[i] -= dt * filter * state.acceleration_change[i];
      }
    accelerate_by(force.contacts, c1);
    for (std::size_t i = 0; i < c1.size(); ++i) // a is u's second difference less what contacts did
      a1[i] -= 0.5 / beta * c1[i];
    if (maxwell.is_on())
      take_maxwell(state, dt);
    add_energy(state, dt, force);
    if (slip != nullptr)
      {
        add_slip_energy(state);
        boundary->keep_column_slip(state.column_slip);
      }
    std::swap(state.maxwell, maxwell1);
    if (newmark.filter > 0.)
      keep_change(state, dt);

    std::copy(u1.begin(), u1.end(), state.displacement.begin());
    std::copy(v1.begin(), v1.end(), state.velocity.begin());
    std::copy(a1.begin(), a1.end(), state.acceleration.begin());
    add_contacts(state, force);
    std::copy(column_u.begin(), column_u.end(), state.displacement.begin() + n);
    std::copy(column_v.begin(), column_v.end(), state.velocity.begin() + n);
    std::copy(column_a.begin(), column_a.end(), state.acceleration.begin() + n);
    state.surface_force.assign(surface_load.size(), 0.);
    std::copy(force.all.begin(), force.all.end(), state.surface_force.begin());
    state.surface_contact.assign(force.ended.begin(), force.ended.end());
    state.time += dt;
  }


  void Continuum::Implementation::keep_change(ContinuumState &state, const double dt) const
  {
    const std::size_t n    = n_dofs();
    const double      kept = (1. - Newmark::memory) * Newmark::remembered_in(dt, state.last_step);
    for (std::size_t i = 0; i < n; ++i)
      state.acceleration_change[i] =
        kept * state.acceleration_change[i] + Newmark::memory * (a1[i] - a0[i]);
    std::copy(column_change.begin(), column_change.end(), state.acceleration_change.begin() + n);
    state.last_step = dt;
  }


  void Continuum::Implementation::accelerate_by(const Eigen::VectorXd &surface_force,
                                                std::vector<double>   &a)
  {
    a.clear();
    if (surface_force.size() == 0 || surface_force.isZero(0.))
      return;
    set_surface(surface_force);
    factorisation->solve_load_on_surface(factor_of_inertia(), surface_motion, solution);
    take_acceleration(a);
  }


  void Continuum::Implementation::add_contacts(ContinuumState &state, const SurfaceForce &force)
  {
    for (std::size_t i = 0; i < c1.size(); ++i)
      state.acceleration[i] += c1[i];
    if (force.has_torn())
      accelerate_by(force.ended, c1);
    state.contact_acceleration = c1;
  }


  bool Continuum::is_iterated() const
  {
    return impl->waves != nullptr && impl->newmark.beta > 0.;
  }



  int Continuum::parts_of_step(const double dt) const
  {
    return impl->waves != nullptr ? impl->waves->parts(dt) : 1;
  }



  const Ownership *Continuum::ownership() const
  {
    return impl->ownership();
  }



  void Continuum::watch(const std::vector<Point> &points) const
  {
    if (impl->waves == nullptr)
      return;
    std::vector<int> watched;
    for (const Point &point : points)
      if (point.cell >= 0)
        watched.insert(watched.end(),
                       impl->nodes->cells[point.cell].begin(),
                       impl->nodes->cells[point.cell].end());
    std::sort(watched.begin(), watched.end());
    watched.erase(std::unique(watched.begin(), watched.end()), watched.end());
    impl->waves->watch(watched);
    if (impl->ownership() != nullptr)
      impl->forget_others(points);
  }



  void Continuum::collect(ContinuumState &state, const bool energy) const
  {
    if (impl->waves == nullptr)
      return;
    if (energy)
      impl->waves->take_energy(state);
    impl->waves->collect_watched(state);
  }



  double Continuum::factor_time() const
  {
    return impl->factor_time;
  }



  const SurfaceStiffness &Continuum::surface_stiffness(const double dt)
  {
    if (impl->below_blocks == nullptr)
      return impl->step_matrix(dt).surface_stiffness;
    const Stopwatch watch(impl->factor_time);
    return impl->below_blocks->surface_stiffness(dt);
  }


  void Continuum::watch_search(std::function<bool()> goes_on)
  {
    if (impl->below_blocks != nullptr)
      impl->below_blocks->watch_search(std::move(goes_on));
  }



  const Eigen::VectorXd &Continuum::predict(const ContinuumState &state, const double dt)
  {
    if (impl->below_blocks != nullptr)
      impl->below_blocks->predict(state, dt, impl->surface_load);
    else
      impl->predict(state, dt);
    return impl->surface_load;
  }


  void Continuum::extrapolate_surface(const ContinuumState &state,
                                      const double          dt,
                                      Eigen::VectorXd      &displacement) const
  {
    const std::size_t n = 2 * impl->surface.size();
    displacement.resize(static_cast<Eigen::Index>(n));
    for (std::size_t k = 0; k < n; ++k)
      {
        const int i = 2 * impl->surface_slots[k / 2] + static_cast<int>(k % 2);
        displacement[k] =
          state.displacement[i] + dt * state.velocity[i] + 0.5 * dt * dt * state.acceleration[i];
      }
  }



  void Continuum::Implementation::set_surface(const Eigen::VectorXd &values)
  {
    surface_motion = values;
    for (std::size_t k = 0; k < surface.size(); ++k)
      for (int c = 0; c < 2; ++c)
        if (boundary->supports()[2 * surface[k] + c] != Support::none)
          surface_motion[2 * k + c] = 0.;
  }


  void Continuum::Implementation::expand(const double           dt,
                                         const Eigen::VectorXd &surface_displacement)
  {
    set_surface(surface_displacement);
    factorisation->backward(*step_matrix(dt).factor, surface_motion, solution);
  }


  void Continuum::correct(ContinuumState        &state,
                          const double           dt,
                          const Eigen::VectorXd &surface_displacement,
                          const SurfaceForce    &surface_force)
  {
    if (impl->below_blocks != nullptr)
      {
        impl->below_blocks->correct(state, dt, surface_displacement, surface_force);
        return;
      }
    if (impl->slip == nullptr) // solve_slip() has done it
      impl->expand(dt, surface_displacement);
    impl->finish(state, dt, surface_force);
  }
} // namespace hybrid::continuum
