// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/base_memory.h>
#include <hybrid/continuum/implicit_waves.h>

// The sums of continuum_energy.cc, whose opening comment has the identity.
namespace hybrid::continuum
{
  double ImplicitWaves::product(const Weights             &weights,
                                const std::vector<double> &x,
                                const std::vector<double> &y)
  {
    multiply(weights, x, work);
    double result = 0.;
    for (std::size_t i = 0; i < y.size(); ++i)
      result += work.local_element(i) * y[i];
    return result;
  }



  double ImplicitWaves::add_boundary_energy(ContinuumState &state)
  {
    const double     gamma  = newmark.gamma;
    ContinuumEnergy &energy = state.energy;
    boundary_forces(incoming0, edges0, force0);
    boundary_forces(incoming1, edges1, force1);
    double work_done = 0., strain_change = 0.;
    for (std::size_t k = 0; k < du.size(); ++k)
      {
        du[k]      = edges1.u[k] - edges0.u[k];
        du_free[k] = incoming1.displacement[k] - incoming0.displacement[k];
        v_free[k]  = (1. - gamma) * incoming0.velocity[k] + gamma * incoming1.velocity[k];
        mean[k]    = (1. - gamma) * edges0.v[k] + gamma * edges1.v[k];
        work_done += du[k] * ((1. - gamma) * force0[k] + gamma * force1[k]);
        strain_change += du[k] * (force1[k] - force0[k]);
      }
    const double loss = boundary.dashpot_loss(du, mean, du_free, v_free);
    energy.boundary_loss += loss;
    energy.input_work += work_done + loss;
    const BoundarySprings &springs = boundary.springs();
    if (springs.empty())
      return strain_change;
    // What the springs take up beyond the model's work comes from the free field that moves them.
    for (std::size_t k = 0; k < du.size(); ++k)
      {
        mean[k]   = (1. - gamma) * edges0.u[k] + gamma * edges1.u[k];
        v_free[k] = (1. - gamma) * incoming0.displacement[k] + gamma * incoming1.displacement[k];
      }
    energy.input_work += springs.product({du, du_free}, {mean, v_free});
    energy.integration_loss += (gamma - 0.5) * springs.product({du, du_free}, {du, du_free});
    return strain_change;
  }



  Vec2 ImplicitWaves::base_reaction(const Motion              &of,
                                    const Branches            &branches,
                                    const std::vector<double> &edge_force)
  {
    strain(of, branches, strained);
    multiply({1., 0., 0.}, strained, work);
    multiply({0., 1., 1.}, of.a, work2);
    work += work2;
    if (damping.mass != 0.)
      {
        multiply({0., damping.mass, 0.}, of.v, work2);
        work += work2;
      }
    places.gather(work.begin(), shared_y);
    Vec2 result(0., 0.);
    for (const int p : moving_places)
      result += Vec2(shared_y[2 * p], shared_y[2 * p + 1]);
    const std::vector<int> &nodes = boundary.boundary_nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (boundary.supports()[2 * nodes[k]] == Support::base_motion)
        result -= Vec2(edge_force[2 * k], edge_force[2 * k + 1]);
    return result;
  }



  double ImplicitWaves::add_base_energy(ContinuumState &state, const double dt)
  {
    if (boundary.moving_nodes().empty())
      return 0.;
    const int  p = 2 * moving_places.front();
    const Vec2 moved(edges1.u[p] - edges0.u[p], edges1.u[p + 1] - edges0.u[p + 1]);
    const Vec2 r0 = base_reaction(before, branch, force0),
               r1 = base_reaction(now, next_branch, force1);
    state.energy.input_work +=
      moved.dot((1. - newmark.gamma) * r0 + newmark.gamma * r1 + contact_reaction());
    take_back_base_work(newmark, dt, moved, r1 - r0, state);
    return moved.dot(r1 - r0);
  }



  Vec2 ImplicitWaves::contact_reaction()
  {
    Vec2 result(0., 0.);
    if (!contacts_push)
      return result;
    multiply({0., 1., 1.}, c1, work);
    places.gather(work.begin(), shared_y);
    for (const int p : moving_places)
      result += Vec2(shared_y[2 * p], shared_y[2 * p + 1]);
    return result;
  }



  double ImplicitWaves::add_surface_energy(ContinuumState &state, const SurfaceForce &force)
  {
    const double gamma         = newmark.gamma;
    double       strain_change = 0.;
    for (std::size_t k = 0; k < surface.nodes.n_unknowns(); ++k)
      {
        const int    unknown = 2 * surface.slots[k / 2] + static_cast<int>(k % 2);
        const double contact = SurfaceForce::at(force.contacts, k);
        const double next    = SurfaceForce::at(force.all, k) - contact;
        const double old     = (state.surface_force.empty() ? 0. : state.surface_force[k]) -
                           (state.surface_contact.empty() ? 0. : state.surface_contact[k]);
        const double moved = surface.u[k] - state.displacement[unknown];
        state.energy.surface_work += moved * ((1. - gamma) * old + gamma * next + contact);
        strain_change += moved * (next - old);
      }
    return strain_change;
  }



  double ImplicitWaves::damping_work(const double dt, double &of_change)
  {
    const double  gamma = newmark.gamma;
    const Weights of{damping.stiffness, damping.mass, 0.};
    double        result = 0.;
    of_change            = 0.;
    std::vector<double> change_of_u(now.u.size());
    for (std::size_t i = 0; i < now.u.size(); ++i)
      change_of_u[i] = now.u[i] - before.u[i];
    if (damping.mass != 0. || damping.stiffness != 0.)
      {
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] = (1. - gamma) * before.v[i] + gamma * now.v[i];
        result = product(of, sum, change_of_u);
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] = now.v[i] - before.v[i];
        of_change = product(of, sum, change_of_u);
      }
    for (std::size_t l = 0; l < branch.size(); ++l)
      {
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] = branch[l][i] + next_branch[l][i];
        result += 0.25 * dt / damping.body.time[l] * damping.body.weight[l] *
                  product({1., 0., 0.}, sum, sum);
      }
    return result;
  }



  void ImplicitWaves::add_energy(ContinuumState &state, const double dt, const SurfaceForce &force)
  {
    const double     gamma = newmark.gamma, time = state.time;
    ContinuumEnergy &energy = state.energy;
    // Du . K Du, from the equilibrium of both ends.
    double strain_change = add_boundary_energy(state);
    strain_change += add_base_energy(state, dt);
    strain_change += add_surface_energy(state, force);
    if (!point_loads.empty())
      {
        const double of_peak = point_loads.work_of_peak(edges0.u, edges1.u);
        const double old = point_loads.factor(time), next = point_loads.factor(time + dt);
        energy.input_work += of_peak * ((1. - gamma) * old + gamma * next);
        strain_change += of_peak * (next - old);
      }
    double sums[3] = {0., 0., 0.}; // integration, damping, damping over its change
    sums[1]        = damping_work(dt, sums[2]);
    if (gamma != 0.5 || filter > 0.)
      {
        for (std::size_t i = 0; i < sum.size(); ++i)
          {
            sum[i]      = (0.5 - gamma) * (now.a[i] - before.a[i]);
            strained[i] = now.u[i] - before.u[i];
            if (filter > 0.)
              sum[i] += filter * change[i];
          }
        sums[0] = product({0., 1., 1.}, sum, strained);
      }
    add_up(sums, 3);
    energy.damping_loss += sums[1];
    energy.integration_loss += sums[0] + (gamma - 0.5) * (strain_change - sums[2]);
  }



  void ImplicitWaves::take_energy(ContinuumState &state)
  {
    load_motion(state);
    now            = before;
    double sums[2] = {0.5 * product({0., 1., 1.}, now.v, now.v),
                      0.5 * damping.body.relaxed * product({1., 0., 0.}, now.u, now.u)};
    for (std::size_t l = 0; l < branch.size(); ++l)
      sums[1] += 0.5 * damping.body.weight[l] * product({1., 0., 0.}, branch[l], branch[l]);
    add_up(sums, 2);
    state.energy.kinetic = sums[0];
    state.energy.strain  = sums[1];
  }
} // namespace hybrid::continuum
