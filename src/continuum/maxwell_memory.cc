// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/maxwell_memory.h>
#include <hybrid/restart/archive.h>

#include <utility>

namespace hybrid::continuum
{
  void serialize(restart::Archive &archive, MaxwellState &state)
  {
    auto &[strain, force, elastic] = state;
    archive(strain, force, elastic);
  }



  MaxwellMemory::MaxwellMemory(MaxwellBody       maxwell,
                               const std::size_t model,
                               const std::size_t columns)
    : body(std::move(maxwell))
    , n(model)
    , all(model + columns)
  {}



  MaxwellState MaxwellMemory::at_rest() const
  {
    MaxwellState state;
    if (!is_on())
      return state;
    state = strains_at_rest(all);
    state.force.assign(body.n_branches() * n, 0.);
    state.elastic.assign(n, 0.);
    return state;
  }



  MaxwellState MaxwellMemory::strains_at_rest(const std::size_t unknowns) const
  {
    MaxwellState state;
    state.strain.assign(body.n_branches() * unknowns, 0.);
    return state;
  }



  void MaxwellMemory::add_past(const MaxwellState  &state,
                               const double         dt,
                               std::vector<double> &load) const
  {
    // s_l1 = kept s_l0 + gained (u1 - u0), and what belongs to u1 is in the step's matrix.
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        const double  kept   = body.weight[l] * body.kept(dt, l);
        const double  gained = body.weight[l] * body.gained(dt, l);
        const double *force  = state.force.data() + l * n;
        for (std::size_t i = 0; i < n; ++i)
          load[i] += gained * state.elastic[i] - kept * force[i];
      }
  }



  void MaxwellMemory::advance(const MaxwellState        &state,
                              const double               dt,
                              const std::vector<double> &elastic,
                              const std::vector<double> &change,
                              MaxwellState              &next) const
  {
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        const double kept = body.kept(dt, l), gained = body.gained(dt, l);
        for (std::size_t i = 0; i < n; ++i)
          {
            next.strain[l * all + i] = kept * state.strain[l * all + i] + gained * change[i];
            next.force[l * n + i] =
              kept * state.force[l * n + i] + gained * (elastic[i] - state.elastic[i]);
          }
      }
    next.elastic = elastic;
  }



  double
  MaxwellMemory::loss(const MaxwellState &state, const MaxwellState &next, const double dt) const
  {
    double sum = 0.;
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      {
        double work = 0.;
        for (std::size_t i = 0; i < n; ++i)
          work += (state.strain[l * all + i] + next.strain[l * all + i]) *
                  (state.force[l * n + i] + next.force[l * n + i]);
        sum += 0.25 * dt / body.time[l] * body.weight[l] * work;
      }
    return sum;
  }



  double MaxwellMemory::stored_energy(const MaxwellState &state, const double *u) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < n; ++i)
      sum += (body.relaxed - 1.) * u[i] * state.elastic[i];
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      for (std::size_t i = 0; i < n; ++i)
        sum += body.weight[l] * state.strain[l * all + i] * state.force[l * n + i];
    return 0.5 * sum;
  }



  double MaxwellMemory::excess_force(const MaxwellState &state, const std::size_t unknown) const
  {
    double sum = (body.relaxed - 1.) * state.elastic[unknown];
    for (std::size_t l = 0; l < body.n_branches(); ++l)
      sum += body.weight[l] * state.force[l * n + unknown];
    return sum;
  }



  void MaxwellMemory::stressed(const MaxwellState  &state,
                               const double        *u,
                               const std::size_t    first,
                               std::vector<double> &result) const
  {
    const std::size_t n_branches = body.n_branches(), of_branch = state.strain.size() / n_branches;
    for (std::size_t k = 0; k < result.size(); ++k)
      {
        result[k] = body.relaxed * u[k];
        for (std::size_t l = 0; l < n_branches; ++l)
          result[k] += body.weight[l] * state.strain[l * of_branch + first + k];
      }
  }
} // namespace hybrid::continuum
