// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/wave_edges.h>

#include <Eigen/LU>

#include <algorithm>

namespace hybrid::continuum
{
  WaveEdges::WaveEdges(const RockMesh       &rock,
                       const ElementNodes   &nodes,
                       const JointStiffness &joint_stiffness,
                       const PointLoads     &loads,
                       BoundaryForces       &of_boundary,
                       const RockDamping    &of_rock)
    : boundary(of_boundary)
    , damping(of_rock)
    , place(nodes.positions.size(), -1)
  {
    for (const int node : boundary.boundary_nodes()) // first, as vectors on the boundary have them
      place_of(node);
    const std::vector<Support> &supports = boundary.supports();
    for (std::size_t i = 0; i < supports.size(); ++i)
      if (supports[i] != Support::none)
        place_of(static_cast<int>(i / 2));
    add_joints(rock, nodes, joint_stiffness);
    point_loads = loads.on_places([this](const int node) { return place_of(node); });
    place       = std::vector<int>();

    dashpots = boundary.nodal_dashpots();
    dashpots.resize(list.size(), Eigen::Matrix2d::Zero());
    for (const int node : list)
      for (int c = 0; c < 2; ++c)
        support.push_back(supports[2 * node + c]);
    for (Motion *motion : {&now, &before})
      for (auto *x : {&motion->displacement, &motion->velocity, &motion->acceleration})
        x->assign(2 * list.size(), 0.);
    for (Motion *motion : {&columns, &next_columns})
      for (auto *x : {&motion->displacement, &motion->velocity, &motion->acceleration})
        x->assign(boundary.n_column_unknowns(), 0.);
    column_branch.assign(damping.body.n_branches() * boundary.n_column_unknowns(), 0.);
    next_column_branch = column_branch;
    column_strained.assign(boundary.n_column_unknowns(), 0.);
    for (auto *x : {&force0, &force1, &change, &change_free, &mean, &mean_free})
      x->assign(2 * list.size(), 0.);
  }



  int WaveEdges::place_of(const int node)
  {
    if (place[node] < 0)
      {
        place[node] = static_cast<int>(list.size());
        list.push_back(node);
      }
    return place[node];
  }



  void
  WaveEdges::add_joints(const RockMesh &rock, const ElementNodes &nodes, const JointStiffness &k)
  {
    for (const FacePair &pair : rock.joints)
      {
        const auto            left = nodes.along(pair.first), right = nodes.along(pair.second);
        const Vec2            along  = rock.nodes[pair.first.b] - rock.nodes[pair.first.a];
        const double          length = along.norm();
        const Vec2            t      = along / length, normal(t.y(), -t.x());
        const Eigen::Matrix2d spring =
          k.normal * normal * normal.transpose() + k.shear * t * t.transpose();
        for (std::size_t i = 0; i < left.size(); ++i)
          if (left[i] != right[i])
            joints.push_back(
              {place_of(left[i]), place_of(right[i]), length * nodes.line.mass()(i, i) * spring});
      }
  }



  void WaveEdges::set_mass(std::vector<double> of_places)
  {
    m = std::move(of_places);
  }



  void WaveEdges::take(const ContinuumState &state, const InState &where)
  {
    const std::size_t       n         = where.columns;
    const std::vector<int> &slots     = where.slots;
    const auto              take_from = [&](const std::vector<double> &held,
                               std::vector<double>       &of_places,
                               std::vector<double>       &of_columns) {
      for (std::size_t k = 0; k < of_places.size(); ++k)
        of_places[k] = held[2 * slots[k / 2] + k % 2];
      std::copy(held.begin() + static_cast<std::ptrdiff_t>(n), held.end(), of_columns.begin());
    };
    take_from(state.displacement, now.displacement, columns.displacement);
    take_from(state.velocity, now.velocity, columns.velocity);
    take_from(state.acceleration, now.acceleration, columns.acceleration);
    const std::size_t count = column_strained.size();
    for (std::size_t l = 0; l < damping.body.n_branches(); ++l)
      std::copy_n(state.maxwell.strain.begin() + static_cast<std::ptrdiff_t>(l * (n + count) + n),
                  count,
                  column_branch.begin() + static_cast<std::ptrdiff_t>(l * count));
    find_incoming(state.time, 0.5 * state.last_step);
    outer_forces(state.time, incoming1, now.velocity, force1);
  }



  void WaveEdges::put(ContinuumState &state, const InState &where) const
  {
    const std::size_t       n        = where.columns;
    const std::vector<int> &slots    = where.slots;
    const auto              put_into = [&](const std::vector<double> &of_places,
                              const std::vector<double> &of_columns,
                              std::vector<double>       &held) {
      for (std::size_t k = 0; k < of_places.size(); ++k)
        held[2 * slots[k / 2] + k % 2] = of_places[k];
      std::copy(of_columns.begin(),
                of_columns.end(),
                held.begin() + static_cast<std::ptrdiff_t>(n));
    };
    put_into(now.displacement, columns.displacement, state.displacement);
    put_into(now.velocity, columns.velocity, state.velocity);
    put_into(now.acceleration, columns.acceleration, state.acceleration);
    const std::size_t count = column_strained.size();
    for (std::size_t l = 0; l < damping.body.n_branches(); ++l)
      std::copy_n(column_branch.begin() + static_cast<std::ptrdiff_t>(l * count),
                  count,
                  state.maxwell.strain.begin() + static_cast<std::ptrdiff_t>(l * (n + count) + n));
  }



  void WaveEdges::move(const double dt)
  {
    before = now;
    for (std::size_t k = 0; k < now.velocity.size(); ++k)
      {
        now.velocity[k] += 0.5 * dt * now.acceleration[k];
        now.displacement[k] += dt * now.velocity[k];
      }
  }



  void WaveEdges::step_columns(const double time, const double dt)
  {
    boundary.step_columns({columns.displacement.data(),
                           columns.velocity.data(),
                           columns.acceleration.data(),
                           nullptr,
                           0.,
                           column_branch.data(),
                           column_strained.size()},
                          {next_columns.displacement.data(),
                           next_columns.velocity.data(),
                           next_columns.acceleration.data(),
                           nullptr,
                           next_column_branch.empty() ? nullptr : next_column_branch.data()},
                          time - dt,
                          dt);
    std::swap(columns, next_columns);
    std::swap(column_branch, next_column_branch);
    std::swap(incoming0, incoming1);
    find_incoming(time, 0.5 * dt);
  }



  void WaveEdges::find_incoming(const double time, const double later)
  {
    const double     *u = columns.displacement.data(), *v = columns.velocity.data();
    const std::size_t count = column_strained.size();
    for (std::size_t k = 0; k < count; ++k)
      {
        // BoundaryForces adds beta_K v.
        column_strained[k] =
          damping.body.relaxed * u[k] - damping.stiffness * later * columns.acceleration[k];
        for (std::size_t l = 0; l < damping.body.n_branches(); ++l)
          column_strained[k] += damping.body.weight[l] * column_branch[l * count + k];
      }
    boundary.incoming(time, u, v, incoming1, column_strained.data());
  }



  void WaveEdges::add_joint_forces(const std::vector<double> &u, std::vector<double> &force) const
  {
    for (const Joint &joint : joints)
      {
        const int  l = 2 * joint.left, r = 2 * joint.right;
        const Vec2 pull = joint.stiffness * Vec2(u[l] - u[r], u[l + 1] - u[r + 1]);
        for (int c = 0; c < 2; ++c)
          {
            force[l + c] -= pull[c];
            force[r + c] += pull[c];
          }
      }
  }



  void WaveEdges::add_spring_forces(const std::vector<double> &u, std::vector<double> &force) const
  {
    if (!boundary.springs().empty())
      boundary.springs().add_forces({u, std::vector<double>(u.size(), 0.)}, force);
  }



  void WaveEdges::outer_forces(const double                    time,
                               const BoundaryForces::Incoming &incoming,
                               const std::vector<double>      &v,
                               std::vector<double>            &force) const
  {
    boundary.forces(incoming, v, force);
    if (!boundary.springs().empty())
      boundary.springs().add_forces({now.displacement, incoming.displacement}, force);
    force.resize(2 * list.size(), 0.);
    point_loads.add_forces(time, force);
  }



  Vec2 WaveEdges::acceleration_of(const int    p,
                                  const double time,
                                  const double half_step,
                                  const Vec2  &force) const
  {
    const Vec2      base = boundary.base_acceleration(time);
    Vec2            result(0., 0.);
    Eigen::Matrix2d resisting = half_step * dashpots[p];
    bool            is_free   = true;
    for (int c = 0; c < 2; ++c)
      {
        resisting(c, c) += (1. + half_step * damping.mass) * m[2 * p + c];
        is_free = is_free && support[2 * p + c] == Support::none;
      }
    if (is_free)
      return resisting.inverse() * force;
    for (int c = 0; c < 2; ++c)
      if (support[2 * p + c] == Support::none)
        result[c] = force[c] / resisting(c, c); // the other one is held
      else if (support[2 * p + c] == Support::base_motion)
        result[c] = base[c];
    return result;
  }



  void
  WaveEdges::accelerate(const double time, const double dt, const std::vector<double> &rock_force)
  {
    step_columns(time, dt);
    outer_forces(time, incoming1, now.velocity, mean);
    for (std::size_t p = 0; p < list.size(); ++p)
      {
        Vec2 force;
        for (std::size_t c = 0; c < 2; ++c)
          {
            const std::size_t k = 2 * p + c;
            force[c]            = rock_force[k] + mean[k] - damping.mass * m[k] * now.velocity[k];
          }
        const Vec2 a = acceleration_of(static_cast<int>(p), time, 0.5 * dt, force);
        for (std::size_t c = 0; c < 2; ++c)
          {
            now.acceleration[2 * p + c] = a[c];
            now.velocity[2 * p + c] += 0.5 * dt * a[c];
          }
      }
    std::swap(force0, force1);
    outer_forces(time, incoming1, now.velocity, force1);
  }



  void WaveEdges::find_acceleration(const double time, const std::vector<double> &rock_force)
  {
    for (std::size_t p = 0; p < list.size(); ++p)
      {
        Vec2 force;
        for (std::size_t c = 0; c < 2; ++c)
          {
            const std::size_t k = 2 * p + c;
            force[c]            = rock_force[k] + force1[k] - damping.mass * m[k] * now.velocity[k];
          }
        const Vec2 a = acceleration_of(static_cast<int>(p), time, 0., force);
        for (std::size_t c = 0; c < 2; ++c)
          if (support[2 * p + c] == Support::none)
            now.acceleration[2 * p + c] = a[c];
      }
  }



  void WaveEdges::add_energy(const std::vector<double> &rock_force0,
                             const std::vector<double> &rock_force1,
                             ContinuumEnergy           &energy)
  {
    const std::size_t on_boundary = 2 * boundary.boundary_nodes().size();
    double            work        = 0.;
    for (std::size_t k = 0; k < change.size(); ++k)
      change[k] = now.displacement[k] - before.displacement[k];
    for (std::size_t k = 0; k < on_boundary; ++k)
      {
        change_free[k] = incoming1.displacement[k] - incoming0.displacement[k];
        mean_free[k]   = 0.5 * (incoming0.velocity[k] + incoming1.velocity[k]);
        mean[k]        = 0.5 * (before.velocity[k] + now.velocity[k]);
      }
    for (std::size_t k = 0; k < change.size(); ++k) // boundary and loads
      work += change[k] * 0.5 * (force0[k] + force1[k]);
    const double loss = boundary.dashpot_loss(change, mean, change_free, mean_free);
    energy.boundary_loss += loss;
    energy.input_work += work + loss;
    if (!boundary.springs().empty())
      add_spring_energy(energy);
    if (!has_moving_base())
      return;
    // What moves the base: its inertia less all forces on it.
    for (std::size_t k = 0; k < change.size(); ++k)
      if (support[k] == Support::base_motion)
        {
          const double drag    = damping.mass * 0.5 * (before.velocity[k] + now.velocity[k]);
          const double inertia = 0.5 * (before.acceleration[k] + now.acceleration[k]);
          energy.input_work +=
            change[k] * (m[k] * (inertia + drag) - 0.5 * (rock_force0[k] + rock_force1[k]) -
                         0.5 * (force0[k] + force1[k]));
        }
  }



  void WaveEdges::add_spring_energy(ContinuumEnergy &energy)
  {
    // What the springs take up beyond the model's work comes from the free field that moves them.
    for (std::size_t k = 0; k < incoming0.displacement.size(); ++k)
      {
        mean[k]      = 0.5 * (before.displacement[k] + now.displacement[k]);
        mean_free[k] = 0.5 * (incoming0.displacement[k] + incoming1.displacement[k]);
      }
    energy.input_work += boundary.springs().product({change, change_free}, {mean, mean_free});
  }
} // namespace hybrid::continuum
