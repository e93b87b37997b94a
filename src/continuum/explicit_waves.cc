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



  ExplicitWaves::ExplicitWaves(const RockMesh       &rock_mesh,
                               ElementSpace         &space,
                               const CellMaterials  &material,
                               const JointStiffness &joint_stiffness,
                               const PointLoads     &loads,
                               BoundaryForces       &boundary,
                               const RockDamping    &of_rock,
                               const MPI_Comm        communicator)
    : SharedWaves(space, communicator)
    , damping(of_rock)
    , stiffness(rock().dofs(),
                material,
                nothing_supported(),
                dealii::QGaussLobatto<1>(space.nodes.line.degree() + 1))
    , edges(rock_mesh, space.nodes, joint_stiffness, loads, boundary, of_rock)
    , places(edges.nodes(), unknowns(), communicator)
    , u(stiffness.make_vector())
    , f(stiffness.make_vector())
    , v(unknowns().size(), 0.)
    , a(v)
  {
    slots = hold(edges.nodes());
    if (keeps_rock_work())
      {
        strained = stiffness.make_vector();
        force0.assign(v.size(), 0.);
        branch.assign(damping.body.n_branches(), v);
      }
    const Vector masses = stiffness.masses();
    mass.assign(masses.begin(), masses.end());
    for (const double m : mass)
      inverse_mass.push_back(1. / m);
    std::vector<double> of_places;
    places.gather(mass.data(), of_places);
    edges.set_mass(of_places);
    find_stable_step();
  }



  void ExplicitWaves::find_stable_step()
  {
    struct Stiffness
    {
      ExplicitWaves &waves;

      void vmult(Vector &to, const Vector &from) const
      {
        waves.u = from;
        waves.find_rock_force(waves.u);
        waves.places.gather(from.begin(), waves.work);
        waves.edges.add_spring_forces(waves.work, waves.rock_force1);
        waves.places.scatter(waves.rock_force1, waves.f.begin());
        to = waves.f;
        to *= -1.;
      }
    };

    dealii::DiagonalMatrix<Vector> scaling(stiffness.make_vector());
    Vector                         start = stiffness.make_vector(), result = start;
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        scaling.get_vector().local_element(i) = inverse_mass[i];
        start.local_element(i)                = scattered(unknowns()[i]) * mass[i];
      }
    dealii::IterationNumberControl control(lanczos_steps, 0.);
    dealii::SolverCG<Vector>       lanczos(control);
    double                         largest = 0.;
    lanczos.connect_eigenvalues_slot(
      [&largest](const std::vector<double> &values) { largest = values.back(); }, false);
    lanczos.solve(Stiffness{*this}, result, start, scaling);
    double modulus = damping.body.relaxed;
    for (const double weight : damping.body.weight)
      modulus += weight;
    const double lag = damping.stiffness * largest, stiff = modulus * largest;
    stable_step = margin * (std::sqrt(lag * lag + 4. * stiff) - lag) / stiff;
    u           = 0.;
    f           = 0.;
  }



  int ExplicitWaves::parts(const double dt) const
  {
    constexpr double rounding = 1e-6;
    return std::max(1, static_cast<int>(std::ceil(dt / stable_step - rounding)));
  }



  double ExplicitWaves::memory() const
  {
    constexpr double of_operator = 12., of_step = 6.; // numbers per unknown; cells' metric, motion
    const double     of_damping = keeps_rock_work() ? 2. + static_cast<double>(branch.size()) : 0.;
    return sizeof(double) * (of_operator + of_step + of_damping) * static_cast<double>(v.size());
  }



  bool ExplicitWaves::load(const ContinuumState &state)
  {
    const bool is_asked = edges.has_moving_base() || keeps_rock_work();
    bool       is_same  = true;
    const auto take     = [&](const double *there, double *here) {
      is_same = is_same && (!is_asked || std::equal(there, there + v.size(), here));
      std::copy_n(there, v.size(), here);
    };
    take(state.displacement.data(), u.begin());
    take(state.velocity.data(), v.data());
    take(state.acceleration.data(), a.data());
    for (std::size_t l = 0; l < branch.size(); ++l)
      take(state.maxwell.strain.data() + l * state.displacement.size(), branch[l].data());
    edges.take(state, {n_held(), slots});
    if (!is_asked)
      return false;
    int differs = is_same ? 0 : 1;
    MPI_Allreduce(MPI_IN_PLACE, &differs, 1, MPI_INT, MPI_MAX, rock().communicator());
    return differs == 0;
  }



  void ExplicitWaves::store(ContinuumState &state) const
  {
    const auto put = [this](const double *here, double *there) {
      std::copy_n(here, v.size(), there);
    };
    put(u.begin(), state.displacement.data());
    put(v.data(), state.velocity.data());
    put(a.data(), state.acceleration.data());
    for (std::size_t l = 0; l < branch.size(); ++l)
      put(branch[l].data(), state.maxwell.strain.data() + l * state.displacement.size());
    edges.put(state, {n_held(), slots});
  }



  void ExplicitWaves::find_rock_force(Vector &by)
  {
    stiffness.multiply(-1., by, f);
    places.gather(f.begin(), rock_force1);
    if (!edges.has_joints())
      return;
    places.gather(by.begin(), work);
    edges.add_joint_forces(work, rock_force1);
    places.scatter(rock_force1, f.begin());
  }



  void ExplicitWaves::find_rock_force_now(const double later)
  {
    if (!keeps_rock_work())
      return find_rock_force(u);
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        double sum =
          damping.body.relaxed * u.local_element(i) + damping.stiffness * (v[i] - later * a[i]);
        for (std::size_t l = 0; l < branch.size(); ++l)
          sum += damping.body.weight[l] * branch[l][i];
        strained.local_element(i) = sum;
      }
    find_rock_force(strained);
  }



  void ExplicitWaves::start(ContinuumState &state)
  {
    load(state);
    find_rock_force_now(0.);
    edges.find_acceleration(state.time, rock_force1);
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] = f.local_element(i) / mass[i] - damping.mass * v[i];
    places.scatter(edges.motion().acceleration, a.data());
    store(state);
    double stored = stored_energy();
    add_up(&stored, 1);
    state.energy.rock_work = stored;
    state.last_step        = 0.;
  }



  bool ExplicitWaves::step(ContinuumState &state, const double dt)
  {
    const int    count   = parts(dt);
    const double part    = dt / count;
    const bool   is_same = load(state);
    // The half velocity of before is rounded anew: always, so that a resumed run does the same.
    if (damping.stiffness > 0. || (!is_same && (edges.has_moving_base() || keeps_rock_work())))
      find_rock_force_now(0.5 * state.last_step);
    double sums[4] = {inertia(), 0., 0., 0.};
    damped = rock_work = 0.;
    for (int k = 0; k < count; ++k)
      advance(state, state.time + k * part, part);
    store(state);

    sums[1] = inertia();
    sums[2] = damped;
    sums[3] = rock_work;
    add_up(sums, 4);
    state.energy.integration_loss += part * part / 8. * (sums[0] - sums[1]);
    state.energy.damping_loss += sums[2];
    state.energy.rock_work += sums[3];
    state.last_step = part;
    state.time += dt;
    return std::isfinite(sums[1]);
  }



  void ExplicitWaves::advance(ContinuumState &state, const double time, const double dt)
  {
    edges.move(dt);
    {
      double *const displacement = u.begin();
      for (std::size_t i = 0; i < v.size(); ++i)
        {
          v[i] += 0.5 * dt * a[i];
          displacement[i] += dt * v[i];
        }
    }
    places.scatter(edges.motion().displacement, u.begin());
    for (std::size_t l = 0; l < branch.size(); ++l)
      {
        const double kept = damping.body.kept(dt, l), gained = dt * damping.body.gained(dt, l);
        for (std::size_t i = 0; i < v.size(); ++i)
          branch[l][i] = kept * branch[l][i] + gained * v[i];
      }
    if (keeps_rock_work())
      std::copy(f.begin(), f.end(), force0.begin());
    std::swap(rock_force0, rock_force1);
    find_rock_force_now(0.);
    for (std::size_t i = 0; i < force0.size(); ++i)
      rock_work -= 0.5 * dt * v[i] * (force0[i] + f.local_element(i));
    edges.accelerate(time + dt, dt, rock_force1);
    accelerate(dt);
    edges.add_energy(rock_force0, rock_force1, state.energy);
  }



  void ExplicitWaves::accelerate(const double dt)
  {
    const double half = 0.5 * dt, drag = damping.mass;
    const double resisting = 1. + half * drag;
    if (drag != 0.)
      {
        // Of the nodes with a place the edges know the acceleration.
        const WaveEdges::Motion &motion = edges.motion();
        work                            = edges.mass();
        for (std::size_t k = 0; k < work.size(); ++k)
          {
            const double v_half = motion.velocity[k] - half * motion.acceleration[k];
            work[k] *= resisting * motion.acceleration[k] + drag * v_half;
          }
        places.scatter(work, f.begin());
      }
    const double *const force = f.begin();
    if (drag != 0.)
      for (std::size_t i = 0; i < v.size(); ++i)
        {
          const double next = (force[i] * inverse_mass[i] - drag * v[i]) / resisting;
          damped += drag * mass[i] * dt * v[i] * (v[i] + 0.25 * dt * (next - a[i]));
          a[i] = next;
          v[i] += half * next;
        }
    else
      for (std::size_t i = 0; i < v.size(); ++i)
        {
          a[i] = force[i] * inverse_mass[i];
          v[i] += half * a[i];
        }
    places.scatter(edges.motion().acceleration, a.data());
    places.scatter(edges.motion().velocity, v.data());
    if (drag != 0.)
      places.scatter(rock_force1, f.begin());
  }



  double ExplicitWaves::inertia() const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += mass[i] * a[i] * a[i];
    return sum;
  }



  double ExplicitWaves::stored_energy()
  {
    const auto energy = [this](Vector &by) {
      find_rock_force(by);
      double sum = 0.;
      for (std::size_t i = 0; i < v.size(); ++i)
        sum -= 0.5 * by.local_element(i) * f.local_element(i);
      return sum;
    };
    double sum = damping.body.relaxed * energy(u);
    for (std::size_t l = 0; l < branch.size(); ++l)
      {
        std::copy(branch[l].begin(), branch[l].end(), strained.begin());
        sum += damping.body.weight[l] * energy(strained);
      }
    return sum;
  }



  void ExplicitWaves::take_energy(ContinuumState &state)
  {
    load(state);
    double sums[2] = {0., stored_energy()};
    for (std::size_t i = 0; i < v.size(); ++i)
      sums[0] += 0.5 * mass[i] * v[i] * v[i];
    add_up(sums, 2);
    state.energy.kinetic = sums[0];
    state.energy.strain  = sums[1];
    find_rock_force_now(0.5 * state.last_step); // the next step begins with it
  }
} // namespace hybrid::continuum
