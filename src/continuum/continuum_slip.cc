// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/continuum/implicit_waves.h>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  namespace
  {
    /// Right-hand sides that are solved together.
    constexpr Eigen::Index chunk = 64;

    /// Corrections of a step without blocks; the first is exact but for round-off.
    constexpr int max_corrections = 20;
  } // namespace


  Eigen::MatrixXd
  Continuum::Implementation::slip_relaxation(const std::vector<int>     &number,
                                             Condensation               &system,
                                             const Condensation::Factor &factor) const
  {
    // Compliance of the node pairs: their jump to a pair of opposite unit forces.
    const auto        &pairs = slip->planes().node_pairs();
    const Eigen::Index n     = 2 * static_cast<Eigen::Index>(pairs.size());
    const auto         place = [&](const Eigen::Index k, const int side) {
      return number[2 * pairs[k / 2][side] + k % 2];
    };
    Eigen::MatrixXd compliance(n, n), forces;
    for (Eigen::Index first = 0; first < n; first += chunk)
      {
        const Eigen::Index count = std::min(chunk, n - first);
        forces                   = Eigen::MatrixXd::Zero(system.size(), count);
        for (Eigen::Index k = 0; k < count; ++k)
          for (int side = 0; side < 2; ++side)
            if (const int i = place(first + k, side); i >= 0)
              forces(i, k) = side == 0 ? 1. : -1.;
        system.solve(factor, forces);
        for (Eigen::Index r = 0; r < n; ++r)
          {
            const int l = place(r, 0), right = place(r, 1);
            for (Eigen::Index k = 0; k < count; ++k)
              compliance(r, first + k) =
                (l >= 0 ? forces(l, k) : 0.) - (right >= 0 ? forces(right, k) : 0.);
          }
      }
    return slip->planes().relaxation(compliance);
  }


  std::vector<int> Continuum::Implementation::free_unknowns() const
  {
    std::vector<int> number = system_of_dof;
    for (std::size_t i = 0; i < number.size(); ++i)
      if (boundary->supports()[i] != Support::none)
        number[i] = -1;
    return number;
  }


  SlipStatus Continuum::Implementation::update_slip(const ContinuumState &state, const double dt)
  {
    if (!columns_settled)
      return SlipStatus::failed;
    StepMatrix &matrix = step_matrix(dt);
    take_displacement(state, dt);
    const SlipStatus status = slip->solve(matrix.slip_relaxation, state.slip, u1);
    if (status != SlipStatus::changed)
      return status;
    std::fill(product.begin(), product.end(), 0.);
    slip->add_load_change(product);
    for (std::size_t s = 0; s < dof_of_system.size(); ++s)
      if (boundary->supports()[dof_of_system[s]] == Support::none)
        rhs[s] += product[dof_of_system[s]];
    factorisation->forward(*matrix.factor, rhs, surface_load);
    return status;
  }


  void Continuum::Implementation::add_joint_force(const double         factor,
                                                  const double        *x,
                                                  std::vector<double> &y)
  {
    slip_work.assign(x, x + n_dofs());
    slip->add_elastic_force(slip_work, factor, y);
  }


  void Continuum::Implementation::base_excess(const std::vector<double> &jump,
                                              const std::vector<double> &velocity,
                                              std::vector<double>       &force)
  {
    // K u + beta_K K v holds the joints as if they were elastic and damped.
    force.assign(n_dofs(), 0.);
    slip->add_load(jump, 1., force);
    add_joint_force(rayleigh_stiffness, velocity.data(), force);
  }


  void Continuum::Implementation::add_slip_energy(ContinuumState &state)
  {
    slip_work.assign(state.displacement.begin(), state.displacement.begin() + n_dofs());
    const auto energy = slip->finish(state.slip, slip_work, u1);
    state.energy.bedding_loss += energy.loss;
    state.energy.integration_loss += energy.integration;
  }


  void Continuum::Implementation::prepare_slip(const scene::BeddingParameters &bedding)
  {
    const JointStiffness stiffness{bedding.normal_stiffness, bedding.shear_stiffness};
    slip = std::make_unique<BeddingSlip>(rock, *nodes, stiffness, *strength_of(bedding));
    slip->set_rest(bedding.initial_normal_stress);
    for (const auto &name : bedding.names)
      slipping_planes.push_back({name, {}, {}});
    const auto &gauss = slip->planes().points();
    for (std::size_t i = 0; i < gauss.size(); ++i)
      {
        slipping_planes[gauss[i].plane].points.push_back(gauss[i].position);
        slipping_planes[gauss[i].plane].numbers.push_back(static_cast<int>(i));
      }
  }


  const std::vector<BeddingPlane> &Continuum::slipping_planes() const
  {
    return impl->slipping_planes;
  }


  BeddingValues Continuum::bedding_values(const ContinuumState &state,
                                          const BeddingPlane   &plane) const
  {
    BeddingValues       values;
    std::vector<double> t(state.slip.jump.size());
    impl->slip->tractions(state.displacement, state.slip.jump, t);
    for (const int i : plane.numbers)
      {
        values.opening.push_back(state.slip.jump[2 * i]);
        values.slip.push_back(state.slip.jump[2 * i + 1]);
        values.normal_stress.push_back(-t[2 * i]);
        values.shear_stress.push_back(t[2 * i + 1]);
        values.condition.push_back(static_cast<double>(state.slip.condition[i]));
      }
    return values;
  }


  SlipStatus Continuum::solve_slip(const ContinuumState  &state,
                                   const double           dt,
                                   const Eigen::VectorXd &surface_displacement)
  {
    if (impl->below_blocks != nullptr)
      return impl->below_blocks->follow_surface(dt, surface_displacement) ? SlipStatus::settled
                                                                          : SlipStatus::failed;
    if (impl->slip == nullptr)
      return SlipStatus::settled;
    impl->expand(dt, surface_displacement);
    return impl->update_slip(state, dt);
  }


  const Eigen::VectorXd &Continuum::surface_load() const
  {
    return impl->surface_load;
  }


  bool Continuum::step(ContinuumState &state, const double dt)
  {
    auto &m = *impl;
    if (m.waves != nullptr)
      return m.waves->step(state, dt);
    m.predict(state, dt);
    m.factorisation->backward(*m.step_matrix(dt).factor, m.solution);
    SlipStatus status = m.slip == nullptr ? SlipStatus::settled : m.update_slip(state, dt);
    for (int k = 0; k < max_corrections && status == SlipStatus::changed; ++k)
      {
        m.factorisation->backward(*m.step_matrix(dt).factor, m.solution);
        status = m.update_slip(state, dt);
      }
    if (status != SlipStatus::settled)
      return false;
    m.finish(state, dt, {});
    return true;
  }
} // namespace hybrid::continuum
