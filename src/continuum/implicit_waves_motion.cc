// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/implicit_waves.h>

#include <algorithm>

// What a state and the free-field columns give and get.
namespace hybrid::continuum
{
  void ImplicitWaves::load_motion(const ContinuumState &state)
  {
    const std::size_t of_rock = n_held(), all = state.displacement.size(), count = columns.u.size();
    const auto        take = [&](const double        *there,
                          std::vector<double> &mine,
                          std::vector<double> *of_places,
                          double              *of_columns) {
      std::copy_n(there, mine.size(), mine.data());
      for (std::size_t k = 0; of_places != nullptr && k < of_places->size(); ++k)
        (*of_places)[k] = there[2 * slots[k / 2] + static_cast<int>(k % 2)];
      std::copy_n(there + of_rock, count, of_columns);
    };
    take(state.displacement.data(), before.u, &edges0.u, columns.u.data());
    take(state.velocity.data(), before.v, &edges0.v, columns.v.data());
    take(state.acceleration.data(), before.a, &edges0.a, columns.a.data());
    if (newmark.filter > 0.)
      take(state.acceleration_change.data(), change, nullptr, column_change.data());
    for (std::size_t l = 0; l < branch.size(); ++l)
      take(state.maxwell.strain.data() + l * all, branch[l], nullptr, &column_branch[l * count]);
  }



  void ImplicitWaves::store(ContinuumState &state, const double dt)
  {
    const std::size_t of_rock = n_held(), all = state.displacement.size(), count = columns.u.size();
    const auto        put = [&](const std::vector<double> &mine,
                         const std::vector<double> *of_places,
                         const double              *of_columns,
                         double                    *there) {
      std::copy_n(mine.data(), mine.size(), there);
      for (std::size_t k = 0; of_places != nullptr && k < of_places->size(); ++k)
        there[2 * slots[k / 2] + static_cast<int>(k % 2)] = (*of_places)[k];
      std::copy_n(of_columns, count, there + of_rock);
    };
    put(now.u, &edges1.u, next_columns.u.data(), state.displacement.data());
    put(now.v, &edges1.v, next_columns.v.data(), state.velocity.data());
    put(now.a, &edges1.a, next_columns.a.data(), state.acceleration.data());
    put_surface(surface.u, state.displacement);
    put_surface(surface.v, state.velocity);
    put_surface(surface.a, state.acceleration);
    if (newmark.filter > 0.)
      {
        put(change, nullptr, next_column_change.data(), state.acceleration_change.data());
        state.last_step = dt;
      }
    for (std::size_t l = 0; l < branch.size(); ++l)
      put(next_branch[l],
          nullptr,
          &next_column_branch[l * count],
          state.maxwell.strain.data() + l * all);
  }



  void ImplicitWaves::step_columns(const ContinuumState &state, const double dt)
  {
    const bool keeps = newmark.filter > 0.;
    boundary.step_columns({columns.u.data(),
                           columns.v.data(),
                           columns.a.data(),
                           keeps ? column_change.data() : nullptr,
                           state.last_step,
                           branch.empty() ? nullptr : column_branch.data(),
                           columns.u.size()},
                          {next_columns.u.data(),
                           next_columns.v.data(),
                           next_columns.a.data(),
                           keeps ? next_column_change.data() : nullptr,
                           branch.empty() ? nullptr : next_column_branch.data()},
                          state.time,
                          dt);
    find_incoming(state.time, columns, column_branch, incoming0);
    find_incoming(state.time + dt, next_columns, next_column_branch, incoming1);
  }



  void ImplicitWaves::find_incoming(const double               time,
                                    const Motion              &of_columns,
                                    const std::vector<double> &branches,
                                    BoundaryForces::Incoming  &in)
  {
    const std::size_t count = of_columns.u.size();
    for (std::size_t k = 0; k < count; ++k) // BoundaryForces adds beta_K v
      {
        column_strained[k] = damping.body.relaxed * of_columns.u[k];
        for (std::size_t l = 0; l < branch.size(); ++l)
          column_strained[k] += damping.body.weight[l] * branches[l * count + k];
      }
    boundary.incoming(time,
                      of_columns.u.data(),
                      of_columns.v.data(),
                      in,
                      branch.empty() ? nullptr : column_strained.data());
  }
} // namespace hybrid::continuum
