// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/implicit_waves.h>
#include <hybrid/continuum/stopped.h>
#include <hybrid/continuum/surface_band.h>
#include <hybrid/continuum/system_pattern.h>

#include <algorithm>
#include <stdexcept>

// Steps below blocks: the interior with the surface held, and the stiffness of the surface.
namespace hybrid::continuum
{
  namespace
  {
    constexpr std::size_t kept_step_sizes = 3;

    /// Of entries of S found by solutions to fine_residual, over its diagonal.
    constexpr double product_round_off = 1e-14;

    constexpr const char *no_convergence =
      "the conjugate gradients of the bedrock below the blocks do not converge; Continuum/Linear "
      "solver = factor needs none";
  } // namespace



  void ImplicitWaves::find_surface(const std::vector<int> &surface_nodes)
  {
    surface.nodes = SharedNodes(surface_nodes, unknowns(), rock().communicator());
    surface.slots = hold(surface_nodes);
    const std::vector<Support> &supports = boundary.supports();
    for (const int node : surface_nodes)
      for (int c = 0; c < 2; ++c)
        surface.supported.push_back(supports[2 * node + c] != Support::none);
    surface.known = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(surface.supported.size()));
    surface.work.assign(surface.supported.size(), 0.);
    for (const int slot : surface.slots) // a rank's own nodes come first
      for (int i = 2 * slot; i < 2 * slot + 2; ++i)
        if (i < static_cast<int>(unknowns().size()))
          surface.mine.push_back(static_cast<unsigned int>(i));
  }



  void ImplicitWaves::hold_surface(Vector &a) const
  {
    for (const unsigned int i : surface.mine)
      a.local_element(i) = 0.;
  }



  void ImplicitWaves::put_surface(const std::vector<double> &values,
                                  std::vector<double>       &of_state) const
  {
    for (std::size_t k = 0; k < surface.nodes.n_unknowns(); ++k)
      of_state[2 * surface.slots[k / 2] + static_cast<int>(k % 2)] = values[k];
  }



  bool ImplicitWaves::solve_interior(const double dt,
                                     const double residual_left,
                                     Vector      &load,
                                     Vector      &a)
  {
    System system        = step_system(dt);
    system.holds_surface = true;
    return solve(system, step_diagonal(system, dt), residual_left, load, a);
  }



  Eigen::MatrixXd ImplicitWaves::surface_product(const double dt, const Eigen::MatrixXd &x)
  {
    const System    system       = step_system(dt);
    const double    to_stiffness = 1. / (newmark.beta * dt * dt);
    Eigen::MatrixXd result(x.rows(), x.cols());
    for (Eigen::Index column = 0; column < x.cols(); ++column)
      {
        for (std::size_t k = 0; k < surface.work.size(); ++k)
          surface.work[k] = surface.supported[k] ? 0. : x(static_cast<Eigen::Index>(k), column);
        a1 = 0.;
        surface.nodes.scatter(surface.work, a1.begin());
        f = 0.;
        if (!solve_interior(dt, fine_residual, f, a1))
          throw std::runtime_error(no_convergence);
        if (search_goes_on && !search_goes_on())
          throw Stopped();
        system.vmult(work, a1);
        surface.nodes.gather(work.begin(), surface.work);
        for (std::size_t k = 0; k < surface.work.size(); ++k)
          result(static_cast<Eigen::Index>(k), column) = to_stiffness * surface.work[k];
      }
    return result;
  }



  SurfaceStiffness ImplicitWaves::find_surface_stiffness(const double dt)
  {
    const Vector &inverse = step_diagonal(step_system(dt), dt);
    surface.nodes.gather(inverse.begin(), surface.work);
    Eigen::VectorXd scale(static_cast<Eigen::Index>(surface.work.size()));
    for (Eigen::Index k = 0; k < scale.size(); ++k)
      scale[k] = 1. / (surface.work[k] * newmark.beta * dt * dt);
    SurfaceStiffness result{
      surface_band([&](const Eigen::MatrixXd &x) { return surface_product(dt, x); },
                   scale,
                   product_round_off),
      true};
    for (Eigen::Index k = 0; k < scale.size(); ++k)
      if (surface.supported[k])
        result.entries(0, k) = support_ratio * scale[k];
    return result;
  }



  const SurfaceStiffness &ImplicitWaves::surface_stiffness(const double dt)
  {
    std::list<Surface::Kept> &kept = surface.kept;
    const auto found = std::find_if(kept.begin(), kept.end(), [dt](const Surface::Kept &known) {
      return known.dt == dt;
    });
    if (found != kept.end())
      kept.splice(kept.begin(), kept, found);
    else
      {
        if (kept.size() >= kept_step_sizes)
          kept.pop_back();
        kept.push_front({dt, find_surface_stiffness(dt)});
      }
    return kept.front().stiffness;
  }



  void ImplicitWaves::predict(const ContinuumState &state, const double dt, Eigen::VectorXd &load)
  {
    const SurfaceStiffness &stiffness = surface_stiffness(dt); // before f and a1 are the step's
    begin(state, dt);
    step_load            = f;
    surface.is_predicted = solve_interior(dt, step_residual, f, a1);
    surface.is_followed  = false;
    step_system(dt).vmult(work, a1);
    work.sadd(-1., 1., step_load);
    surface.nodes.gather(work.begin(), surface.work);
    surface.nodes.gather(now.u.data(), surface.u);
    surface.nodes.gather(a1.begin(), surface.a);
    const auto n = static_cast<Eigen::Index>(surface.u.size());
    load         = Eigen::Map<const Eigen::VectorXd>(surface.work.data(), n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const bool is_free = !surface.supported[k];
        surface.known[k]   = is_free ? surface.u[k] + newmark.beta * dt * dt * surface.a[k] : 0.;
        load[k]            = is_free ? load[k] : 0.;
      }
    stiffness.add_product(surface.known, load);
  }



  bool ImplicitWaves::follow_surface(const double dt, const Eigen::VectorXd &surface_displacement)
  {
    for (std::size_t k = 0; k < surface.a.size(); ++k)
      if (!surface.supported[k]) // the others are as predicted
        surface.a[k] = (surface_displacement[static_cast<Eigen::Index>(k)] - surface.u[k]) /
                       (newmark.beta * dt * dt);
    surface.nodes.scatter(surface.a, a1.begin());
    f                   = step_load;
    surface.is_followed = solve_interior(dt, step_residual, f, a1) && surface.is_predicted;
    return surface.is_followed;
  }



  void ImplicitWaves::correct(ContinuumState        &state,
                              const double           dt,
                              const Eigen::VectorXd &surface_displacement,
                              const SurfaceForce    &force)
  {
    if (!surface.is_followed && !follow_surface(dt, surface_displacement))
      throw std::runtime_error(no_convergence);
    finish(dt);
    surface.nodes.gather(now.u.data(), surface.u);
    surface.nodes.gather(now.v.data(), surface.v);
    take_contacts(force);
    add_energy(state, dt, force);
    keep_change(dt, state.last_step);
    add_contacts(state, force);
    gather(now, edges1);
    surface.nodes.gather(now.a.data(), surface.a);
    store(state, dt);
    state.surface_force.assign(surface.u.size(), 0.);
    std::copy(force.all.begin(), force.all.end(), state.surface_force.begin());
    state.surface_contact.assign(force.ended.begin(), force.ended.end());
    state.time += dt;
  }



  bool ImplicitWaves::accelerate_by(const Eigen::VectorXd &surface_force,
                                    std::vector<double>   &acceleration)
  {
    if (surface_force.size() == 0 || surface_force.isZero(0.))
      return false;
    std::copy(surface_force.begin(), surface_force.end(), surface.work.begin());
    f = 0.;
    surface.nodes.scatter(surface.work, f.begin());
    a1 = 0.;
    if (!solve(inertia(), inertia_diagonal, fine_residual, f, a1))
      throw std::runtime_error(no_convergence);
    std::copy(a1.begin(), a1.end(), acceleration.begin());
    return true;
  }



  void ImplicitWaves::take_contacts(const SurfaceForce &force)
  {
    // a is the second difference of u less what contacts did.
    contacts_push = accelerate_by(force.contacts, c1);
    for (std::size_t i = 0; contacts_push && i < c1.size(); ++i)
      now.a[i] -= 0.5 / newmark.beta * c1[i];
  }



  void ImplicitWaves::add_contacts(ContinuumState &state, const SurfaceForce &force)
  {
    for (std::size_t i = 0; contacts_push && i < c1.size(); ++i)
      now.a[i] += c1[i];
    const bool ends = force.has_torn() ? accelerate_by(force.ended, c1) : contacts_push;
    state.contact_acceleration.assign(ends ? n_held() : 0, 0.);
    if (ends)
      std::copy(c1.begin(), c1.end(), state.contact_acceleration.begin());
  }
} // namespace hybrid::continuum
