// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/bedding_slip.h>
#include <hybrid/scene/first_of_largest.h>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  namespace
  {
    /// Change of the tractions that ends the iteration, over the largest traction.
    constexpr double tolerance = 1e-9;

    /// Round-off of a displacement found by Cholesky factors, over the displacement.
    constexpr double round_off = 1e-14;
  } // namespace


  BeddingSlip::BeddingSlip(const RockMesh       &rock,
                           const ElementNodes   &nodes,
                           const JointStiffness &stiffness,
                           const PlaneStrength  &strength)
    : bedding(rock, nodes, stiffness)
    , solver(bedding.points().size(), strength)
    , rest(2 * bedding.points().size(), 0.)
    , now(rest)
    , before(rest)
    , t(rest)
    , t1(rest)
    , rest_failed(bedding.points().size(), 0)
    , start(static_cast<Eigen::Index>(rest.size()))
    , change(start.size())
  {}


  SlipState BeddingSlip::initial_state() const
  {
    const std::size_t n = bedding.points().size();
    return {std::vector<double>(2 * n, 0.),
            std::vector<double>(n, 0.),
            std::vector<char>(n, 0),
            std::vector<PlaneCondition>(n, PlaneCondition::elastic)};
  }


  void BeddingSlip::set_rest(const double compression)
  {
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = i % 2 == 0 ? -compression : 0.;
  }


  void BeddingSlip::add_rest(const std::vector<double> &tractions_at_rest)
  {
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] += tractions_at_rest[i];
  }


  void BeddingSlip::add_pore_forces(const std::function<double(const Vec2 &)> &pressure,
                                    std::vector<double>                       &load) const
  {
    std::vector<double> traction(rest.size(), 0.);
    for (std::size_t i = 0; i < bedding.points().size(); ++i)
      traction[2 * i] = pressure(bedding.points()[i].position);
    bedding.add_forces(traction, 1., load);
  }


  void BeddingSlip::begin_rest()
  {
    rest_state = initial_state();
    begin(rest_state);
  }


  SlipStatus BeddingSlip::solve_rest(const Eigen::MatrixXd     &relaxation,
                                     const std::vector<double> &u)
  {
    return solve(relaxation, rest_state, u);
  }


  void BeddingSlip::keep_rest(const std::vector<double> &u)
  {
    tractions(u, now, t);
    rest        = t;
    rest_failed = failed;
  }


  StaticSlip BeddingSlip::slip_at_rest() const
  {
    StaticSlip result;
    for (std::size_t i = 0; i < failed.size(); ++i)
      {
        result.slipping += solver.conditions()[i] == PlaneCondition::slipping;
        result.open += solver.conditions()[i] == PlaneCondition::open;
        if (std::abs(now[2 * i + 1]) > result.largest)
          {
            result.largest = std::abs(now[2 * i + 1]);
            result.where   = bedding.points()[i].position;
            result.plane   = bedding.points()[i].plane;
          }
      }
    return result;
  }


  const BeddingPlanes::Point &BeddingSlip::most_loaded_at_rest() const
  {
    std::vector<double> excess;
    for (std::size_t i = 0; i < bedding.points().size(); ++i)
      excess.push_back(solver.excess(rest[2 * i], rest[2 * i + 1]));
    return bedding.points()[first_of_largest(excess)];
  }


  void BeddingSlip::begin(const SlipState &state)
  {
    now    = state.jump;
    before = now;
    failed = state.failed;
    for (std::size_t i = 0; i < failed.size(); ++i)
      failed[i] |= rest_failed[i];
  }


  void BeddingSlip::tractions(const std::vector<double> &u,
                              const std::vector<double> &p,
                              std::vector<double>       &traction) const
  {
    bedding.jumps(u, traction);
    for (std::size_t i = 0; i < traction.size(); ++i)
      traction[i] -= p[i];
    bedding.tractions(traction, traction);
    for (std::size_t i = 0; i < traction.size(); ++i)
      traction[i] += rest[i];
  }


  SlipStatus BeddingSlip::solve(const Eigen::MatrixXd     &relaxation,
                                const SlipState           &state,
                                const std::vector<double> &u)
  {
    tractions(u, now, t);
    double largest = 0.;
    for (const double x : t)
      largest = std::max(largest, std::abs(x));
    const Eigen::Map<const Eigen::VectorXd> found(t.data(), start.size());
    const Eigen::Map<const Eigen::VectorXd> p(now.data(), start.size());
    const Eigen::Map<const Eigen::VectorXd> old(state.jump.data(), start.size());
    start = found;
    if (now != state.jump)
      start.noalias() += relaxation * (p - old);
    if (!solver.solve({relaxation, start, state.jump}, failed))
      return SlipStatus::failed;

    // How far the tractions are from what the strength allows; k (u - u') knows them to within the
    // round-off of u only.
    const Eigen::Map<const Eigen::VectorXd> next(solver.jump().data(), start.size());
    change.noalias() = relaxation * (next - p);
    const double bound =
      tolerance * largest + round_off * bedding.largest_displacement(u) *
                              std::max(bedding.stiffness().normal, bedding.stiffness().shear);
    if (change.lpNorm<Eigen::Infinity>() <= bound)
      return SlipStatus::settled;
    before = now;
    now    = solver.jump();
    return SlipStatus::changed;
  }


  void BeddingSlip::add_load(const std::vector<double> &p,
                             const double               factor,
                             std::vector<double>       &force)
  {
    bedding.tractions(p, t1);
    bedding.add_forces(t1, factor, force);
  }


  void BeddingSlip::add_elastic_force(const std::vector<double> &x,
                                      const double               factor,
                                      std::vector<double>       &force)
  {
    bedding.jumps(x, t);
    add_load(t, factor, force);
  }


  void BeddingSlip::add_load_change(std::vector<double> &force)
  {
    add_load(now, 1., force);
    add_load(before, -1., force);
  }


  BeddingSlip::Energy BeddingSlip::finish(SlipState                 &state,
                                          const std::vector<double> &u0,
                                          const std::vector<double> &u1)
  {
    // Newmark's identity takes the work Dp . W [(1 - gamma) t_0 + gamma t_1] from the joints, and
    // its own term has -(gamma - 1/2) Dp . W Dt: together Dp . W (t_0 + t_1) / 2. Of that the
    // planes lose, with the traction at the end that the strength allows: by slip tau_1 Ds, by
    // opening and closing nothing (o sigma = 0), and where a point breaks the elastic energy F_t^2
    // / (2 k_n) of the tension and (tau_0 - tau_1)^2 / (2 k_s) of the shear traction that it drops.
    // What remains depends on the step: it is the scheme's.
    tractions(u0, state.jump, t);
    tractions(u1, now, t1);
    const JointStiffness &k = bedding.stiffness();
    Energy                energy;
    for (std::size_t i = 0; i < failed.size(); ++i)
      {
        const std::size_t n = 2 * i, s = n + 1;
        const double      slip = now[s] - state.jump[s], opened = now[n] - state.jump[n];
        double            loss = slip * t1[s];
        if (failed[i] && !state.failed[i] && !rest_failed[i])
          loss += 0.5 * (t[s] - t1[s]) * (t[s] - t1[s]) / k.shear +
                  (now[n] > 0. ? 0.5 * solver.cut_off() * solver.cut_off() / k.normal : 0.);
        const double work = 0.5 * (slip * (t[s] + t1[s]) + opened * (t[n] + t1[n]));
        energy.loss += bedding.points()[i].length * loss;
        energy.integration += bedding.points()[i].length * (work - loss);
      }
    for (std::size_t i = 0; i < state.path.size(); ++i)
      state.path[i] += std::abs(now[2 * i + 1] - state.jump[2 * i + 1]);
    state.jump      = now;
    state.failed    = failed;
    state.condition = solver.conditions();
    return energy;
  }


  double BeddingSlip::strain_correction(const SlipState &state, const std::vector<double> &u) const
  {
    std::vector<double> jump(state.jump.size()), traction(jump);
    bedding.jumps(u, jump);
    bedding.tractions(state.jump, traction);
    double sum = 0.;
    for (std::size_t i = 0; i < jump.size(); ++i)
      sum += bedding.points()[i / 2].length * traction[i] * (0.5 * state.jump[i] - jump[i]);
    return sum;
  }


  double BeddingSlip::static_energy(const SlipState &state) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < rest.size(); ++i)
      sum -= bedding.points()[i / 2].length * rest[i] * state.jump[i];
    return sum;
  }
} // namespace hybrid::continuum
