// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <hybrid/continuum/explicit_waves.h>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  namespace
  {
    constexpr int    lanczos_steps = 60;
    constexpr double margin        = 0.95; ///< of the stable step: what Lanczos has not found yet



    /// A number in [-1, 1] for an unknown, the same on any number of ranks.
    double scattered(const int unknown)
    {
      std::uint64_t x = static_cast<std::uint64_t>(unknown) + 0x9e3779b97f4a7c15ULL;
      x               = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
      x               = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
      x ^= x >> 31;
      return std::ldexp(static_cast<double>(x >> 11), -52) - 1.;
    }
  } // namespace



  ExplicitWaves::ExplicitWaves(const RockMesh              &rock,
                               const ElementSpace          &space,
                               const std::vector<Material> &material,
                               const JointStiffness        &joint_stiffness,
                               const PointLoads            &loads,
                               BoundaryForces              &boundary,
                               const double                 rayleigh_mass,
                               const MPI_Comm               communicator)
    : damping(rayleigh_mass)
    , n(2 * space.nodes.positions.size())
    , rock_operator(space, material, communicator)
    , edges(rock, space.nodes, joint_stiffness, loads, boundary, rayleigh_mass)
    , places(edges.nodes(), rock_operator.unknowns(), communicator)
    , u(rock_operator.make_vector())
    , f(rock_operator.make_vector())
    , v(rock_operator.unknowns().size(), 0.)
    , a(v)
  {
    std::vector<double> mass;
    places.gather(rock_operator.mass().data(), mass);
    edges.set_mass(mass);
    find_stable_step();

    int rank = 0, ranks = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    if (ranks == 1)
      return;
    const int count = static_cast<int>(v.size());
    counts.resize(ranks);
    offsets.assign(ranks, 0);
    MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, communicator);
    for (int r = 1; r < ranks; ++r)
      offsets[r] = offsets[r - 1] + counts[r - 1];
    if (rank == 0)
      {
        unknown_of.resize(n);
        received.resize(n);
      }
    sent.resize(v.size());
    MPI_Gatherv(rock_operator.unknowns().data(),
                count,
                MPI_INT,
                unknown_of.data(),
                counts.data(),
                offsets.data(),
                MPI_INT,
                0,
                communicator);
  }



  void ExplicitWaves::find_stable_step()
  {
    using Vector = WaveOperator::Vector;
    struct Stiffness
    {
      ExplicitWaves &waves;

      void vmult(Vector &to, const Vector &from) const
      {
        waves.u = from;
        waves.places.gather(from.begin(), waves.work);
        waves.find_rock_force(waves.work);
        to = waves.f;
        to *= -1.;
      }
    };

    dealii::DiagonalMatrix<Vector> inverse_mass(rock_operator.make_vector());
    Vector                         start = rock_operator.make_vector(), result = start;
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        inverse_mass.get_vector().local_element(i) = 1. / rock_operator.mass()[i];
        start.local_element(i) = scattered(rock_operator.unknowns()[i]) * rock_operator.mass()[i];
      }
    dealii::IterationNumberControl control(lanczos_steps, 0.);
    dealii::SolverCG<Vector>       lanczos(control);
    double                         largest = 0.;
    lanczos.connect_eigenvalues_slot(
      [&largest](const std::vector<double> &values) { largest = values.back(); }, false);
    lanczos.solve(Stiffness{*this}, result, start, inverse_mass);
    stable_step = margin * 2. / std::sqrt(largest);
    u           = 0.;
  }



  int ExplicitWaves::parts(const double dt) const
  {
    constexpr double rounding = 1e-6;
    return std::max(1, static_cast<int>(std::ceil(dt / stable_step - rounding)));
  }



  double ExplicitWaves::memory() const
  {
    constexpr double of_operator = 12.; // per unknown: cells' metric, modulus, numbers
    return sizeof(double) * (of_operator + 5.) * static_cast<double>(v.size());
  }



  void ExplicitWaves::load(const ContinuumState &state)
  {
    const std::vector<int> &mine = rock_operator.unknowns();
    for (std::size_t i = 0; i < mine.size(); ++i)
      {
        u.local_element(i) = state.displacement[mine[i]];
        v[i]               = state.velocity[mine[i]];
        a[i]               = state.acceleration[mine[i]];
      }
    edges.take(state, n);
  }



  void ExplicitWaves::store(ContinuumState &state) const
  {
    const std::vector<int> &mine = rock_operator.unknowns();
    for (std::size_t i = 0; i < mine.size(); ++i)
      {
        state.displacement[mine[i]] = u.local_element(i);
        state.velocity[mine[i]]     = v[i];
        state.acceleration[mine[i]] = a[i];
      }
    edges.put(state, n);
  }



  void ExplicitWaves::find_rock_force(const std::vector<double> &u_of_places)
  {
    rock_operator.elastic_force(u, f);
    places.gather(f.begin(), rock_force1);
    edges.add_joint_forces(u_of_places, rock_force1);
    places.scatter(rock_force1, f.begin());
  }



  void ExplicitWaves::start(ContinuumState &state)
  {
    load(state);
    find_rock_force(edges.motion().displacement);
    edges.find_acceleration(state.time, rock_force1);
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] = f.local_element(i) / rock_operator.mass()[i] - damping * v[i];
    places.scatter(edges.motion().acceleration, a.data());
    store(state);
    damped               = 0.;
    const Sums sum       = sum_up();
    state.energy.kinetic = sum.kinetic;
    state.energy.strain  = sum.strain;
  }



  bool ExplicitWaves::step(ContinuumState &state, const double dt)
  {
    const int    count = parts(dt);
    const double part  = dt / count;
    load(state);
    double inertia0 = inertia();
    MPI_Allreduce(MPI_IN_PLACE, &inertia0, 1, MPI_DOUBLE, MPI_SUM, rock_operator.communicator());
    damped = 0.;
    if (edges.has_moving_base())
      find_rock_force(edges.motion().displacement);
    for (int k = 0; k < count; ++k)
      advance(state, state.time + k * part, part);
    store(state);

    const Sums sum       = sum_up();
    state.energy.kinetic = sum.kinetic;
    state.energy.strain  = sum.strain;
    state.energy.damping_loss += sum.damping;
    state.energy.integration_loss += part * part / 8. * (inertia0 - sum.inertia);
    state.time += dt;
    return std::isfinite(sum.kinetic + sum.strain);
  }



  void ExplicitWaves::advance(ContinuumState &state, const double time, const double dt)
  {
    edges.move(dt);
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        v[i] += 0.5 * dt * a[i];
        u.local_element(i) += dt * v[i];
      }
    places.scatter(edges.motion().displacement, u.begin());
    std::swap(rock_force0, rock_force1);
    find_rock_force(edges.motion().displacement);
    edges.accelerate(time + dt, dt, rock_force1);
    accelerate(dt);
    edges.add_energy(rock_force0, rock_force1, state.energy);
  }



  void ExplicitWaves::accelerate(const double dt)
  {
    const std::vector<double> &mass = rock_operator.mass();
    const double               half = 0.5 * dt, resisting = 1. + half * damping;
    if (damping != 0.)
      {
        // Of the nodes with a place the edges know the acceleration.
        const WaveEdges::Motion &motion = edges.motion();
        work                            = edges.mass();
        for (std::size_t k = 0; k < work.size(); ++k)
          {
            const double v_half = motion.velocity[k] - half * motion.acceleration[k];
            work[k] *= resisting * motion.acceleration[k] + damping * v_half;
          }
        places.scatter(work, f.begin());
      }
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        const double next =
          (f.local_element(i) / mass[i] - damping * v[i]) / resisting;
        if (damping != 0.)
          damped += damping * mass[i] * dt * v[i] * (v[i] + 0.25 * dt * (next - a[i]));
        a[i] = next;
        v[i] += half * next;
      }
    places.scatter(edges.motion().acceleration, a.data());
    places.scatter(edges.motion().velocity, v.data());
    if (damping != 0.)
      places.scatter(rock_force1, f.begin());
  }



  double ExplicitWaves::inertia() const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += rock_operator.mass()[i] * a[i] * a[i];
    return sum;
  }



  ExplicitWaves::Sums ExplicitWaves::sum_up() const
  {
    double sum[4] = {0., 0., inertia(), damped};
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        sum[0] += 0.5 * rock_operator.mass()[i] * v[i] * v[i];
        sum[1] -= 0.5 * u.local_element(i) * f.local_element(i);
      }
    MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, rock_operator.communicator());
    return {sum[0], sum[1], sum[2], sum[3]};
  }



  void ExplicitWaves::collect(ContinuumState &state)
  {
    if (counts.empty())
      return;
    const std::vector<int> &mine = rock_operator.unknowns();
    for (auto *all : {&state.displacement, &state.velocity, &state.acceleration})
      {
        for (std::size_t i = 0; i < mine.size(); ++i)
          sent[i] = (*all)[mine[i]];
        MPI_Gatherv(sent.data(),
                    static_cast<int>(sent.size()),
                    MPI_DOUBLE,
                    received.data(),
                    counts.data(),
                    offsets.data(),
                    MPI_DOUBLE,
                    0,
                    rock_operator.communicator());
        for (std::size_t k = 0; k < received.size(); ++k)
          (*all)[unknown_of[k]] = received[k];
      }
  }
} // namespace hybrid::continuum
