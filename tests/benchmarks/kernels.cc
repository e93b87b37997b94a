// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the hot kernels alone, on a wall of unit squares that slides and on a bonded mass; see
// doc/performance.md. Counters: bytes/s that a kernel must move at least, operations/s and items/s.
#include "block_scenes.h"
#include "random_block_matrix.h"

#include <hybrid/dda/contact/contact_detection.h>
#include <hybrid/dda/linear/block_inverse.h>
#include <hybrid/dda/linear/interface_stiffness.h>
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/dda/linear/ssor_system.h>
#include <hybrid/dda/springs/spring_stiffness.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <omp.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;
  using benchmark::Counter;
  using benchmark::State;

  constexpr double dt = 1e-3; ///< [s]

  /// Rates of what one pass takes at least.
  void set_counters(State &state, const double items, const double bytes, const double operations)
  {
    const auto per_pass     = Counter::kIsIterationInvariantRate;
    state.counters["items"] = Counter(items, per_pass);
    state.counters["bytes"] = Counter(bytes, per_pass, Counter::kIs1024);
    state.counters["flop"]  = Counter(operations, per_pass);
  }



  /// A bonded square of n x n unit squares, or a loose one at rest with its contacts, in a trial
  /// that moves all of it a little.
  struct Wall
  {
    FixedBaseRun    run;
    Springs         springs;
    SpringStiffness stiffness;
    BlockMatrix     matrix;
    Trial           trial;

    static scene::SceneParameters parameters(const bool bonded)
    {
      scene::SceneParameters p             = block_parameters(25., 5e9);
      p.materials["rock"].cohesion         = 1e9;
      p.materials["rock"].tensile_strength = 1e9;
      p.blocks.bonded                      = bonded;
      p.environment.gravity                = 0.; // the step that finds the contacts is soon done
      return p;
    }

    Wall(const int n, const bool bonded)
      : run(square_blocks(n, n), parameters(bonded), straight_foundation(0., 5., n + 5.))
    {
      run.advance(dt, 10); // finds contacts
      trial.dt         = dt;
      trial.foundation = run.state.foundation_displacement;
      trial.rate.assign(run.state.blocks.size(), Vec6::Zero());
      trial.increment.assign(run.state.blocks.size(), 1e-7 * Vec6::Ones());
      trial.displacement.resize(run.state.geometry.vertices.size());
      for (std::size_t b = 0; b < run.state.blocks.size(); ++b)
        {
          trial.motion.emplace_back(run.state.blocks[b].centroid, trial.increment[b]);
          for (int v = run.state.geometry.offset[b]; v < run.state.geometry.offset[b + 1]; ++v)
            trial.displacement[v] = trial.motion[b].displacement(run.state.geometry.vertices[v]);
        }
      springs.collect(run.model, run.state);
      springs.connect(run.model, matrix);
      springs.evaluate(run.model, run.state, trial);
    }

    double n_springs() const
    {
      return static_cast<double>(springs.springs.size());
    }

    /// Tangent with inertia and elasticity, as a step has it.
    void assemble()
    {
      stiffness.update(springs, trial, SpringStiffness::Choice());
      for (const int b : stiffness.changed_blocks())
        {
          const BlockProperties &p = run.model.blocks[b];
          matrix.set_row_zero(b);
          matrix.diagonal[b] =
            mass_matrix(p, run.state.blocks[b].rotation) / (run.model.newmark.beta * dt * dt);
          matrix.diagonal[b].bottomRightCorner<3, 3>() += p.area * p.elasticity;
          stiffness.add_rows(springs, b, matrix);
        }
      matrix.set_nodes_zero();
      std::fill(matrix.node_diagonal.begin(),
                matrix.node_diagonal.end(),
                Eigen::Matrix2d::Identity());
    }

    /// Of the entries that a product reads.
    double matrix_bytes() const
    {
      return 288. * static_cast<double>(matrix.diagonal.size() + 2 * matrix.pairs.size());
    }
  };



  // Springs ---------------------------------------------------------------------------------------

  void springs_evaluate(State &state)
  {
    Wall wall(static_cast<int>(state.range(0)), state.range(1) != 0);
    for (auto _ : state)
      wall.springs.evaluate(wall.run.model, wall.run.state, wall.trial);
    set_counters(state,
                 wall.n_springs(),
                 wall.n_springs() * (sizeof(Springs::Spring) + sizeof(Springs::Response)),
                 0.);
  }
  BENCHMARK(springs_evaluate)->ArgNames({"side", "bonded"})->ArgsProduct({{20, 50}, {0, 1}});

  void springs_add_forces(State &state)
  {
    Wall            wall(static_cast<int>(state.range(0)), state.range(1) != 0);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(wall.matrix.size()), c = f,
                    absolute = Eigen::VectorXd::Zero(wall.run.model.n_blocks());
    for (auto _ : state)
      wall.springs.add_forces(f, c, absolute);
    set_counters(state, wall.n_springs(), wall.n_springs() * sizeof(Springs::Response), 0.);
  }
  BENCHMARK(springs_add_forces)->ArgNames({"side", "bonded"})->ArgsProduct({{20, 50}, {0, 1}});

  void assembly_of_rows(State &state)
  {
    Wall wall(static_cast<int>(state.range(0)), state.range(1) != 0);
    for (auto _ : state)
      wall.assemble();
    // Each spring adds 2 G^T D G of 6 x 6 on both blocks: 4 blocks of 36 entries, rank 2.
    set_counters(state, wall.n_springs(), wall.matrix_bytes(), wall.n_springs() * 4. * 36. * 4.);
  }
  BENCHMARK(assembly_of_rows)->ArgNames({"side", "bonded"})->ArgsProduct({{20, 50}, {0, 1}});

  // Small blocks ----------------------------------------------------------------------------------

  void product_6x6(State &state)
  {
    const std::size_t n = static_cast<std::size_t>(state.range(0));
    std::vector<Mat6> a(n, Mat6::Random()), b(n, Mat6::Random()), c(n, Mat6::Zero());
    for (auto _ : state)
      {
        for (std::size_t k = 0; k < n; ++k)
          c[k].noalias() -= a[k] * b[k];
        benchmark::ClobberMemory();
      }
    set_counters(state, n, n * 4. * 288., n * 432.);
  }
  BENCHMARK(product_6x6)->Arg(16)->Arg(100000);

  void product_6x6_vector(State &state)
  {
    const std::size_t n = static_cast<std::size_t>(state.range(0));
    std::vector<Mat6> a(n, Mat6::Random());
    std::vector<Vec6> x(n, Vec6::Random()), y(n, Vec6::Zero());
    for (auto _ : state)
      {
        for (std::size_t k = 0; k < n; ++k)
          y[k].noalias() -= a[k] * x[k];
        benchmark::ClobberMemory();
      }
    set_counters(state, n, n * (288. + 3. * 48.), n * 72.);
  }
  BENCHMARK(product_6x6_vector)->Arg(16)->Arg(100000);

  void inverse_6x6(State &state)
  {
    constexpr int     n = 64;
    std::vector<Mat6> a, inverse(n);
    for (int k = 0; k < n; ++k)
      a.push_back(Mat6::Random() + 6. * Mat6::Identity());
    for (auto _ : state)
      {
        for (int k = 0; k < n; ++k)
          inverse[k] = block_inverse(a[k]);
        benchmark::ClobberMemory();
      }
    set_counters(state, n, n * 2. * 288., n * 2. * 216.);
  }
  BENCHMARK(inverse_6x6);

  // Linear system ---------------------------------------------------------------------------------

  /// A pass over the matrix of a wall.
  struct System
  {
    Wall               wall;
    InterfaceStiffness none;
    SsorSystem         ssor;
    std::vector<int>   all;
    Eigen::VectorXd    x, y;

    System(const int n, const bool bonded)
      : wall(n, bonded)
    {
      wall.assemble();
      x = y = Eigen::VectorXd::Random(wall.matrix.size());
      for (int b = 0; b < wall.matrix.n_blocks(); ++b)
        all.push_back(b);
      none.matrix_changed(wall.matrix);
      ssor.set(wall.matrix, none, {});
    }

    double operations() const
    {
      return wall.matrix_bytes() / 288. * 72.;
    }
  };

  void matrix_product(State &state)
  {
    System s(static_cast<int>(state.range(0)), true);
    for (auto _ : state)
      s.wall.matrix.multiply(s.x, s.y);
    set_counters(state, s.wall.matrix.n_blocks(), s.wall.matrix_bytes(), s.operations());
  }
  BENCHMARK(matrix_product)->ArgName("side")->Arg(20)->Arg(50)->Arg(100);

  void sweep_both_ways(State &state)
  {
    System s(static_cast<int>(state.range(0)), true);
    for (auto _ : state)
      s.ssor.multiply(s.x, s.y);
    set_counters(state, s.wall.matrix.n_blocks(), s.wall.matrix_bytes(), s.operations());
  }
  BENCHMARK(sweep_both_ways)->ArgName("side")->Arg(20)->Arg(50)->Arg(100);

  void sweep_copy_of_rows(State &state)
  {
    System s(static_cast<int>(state.range(0)), true);
    for (auto _ : state)
      s.ssor.set(s.wall.matrix, s.none, s.all);
    set_counters(state, s.wall.matrix.n_blocks(), 2. * s.wall.matrix_bytes(), 0.);
  }
  BENCHMARK(sweep_copy_of_rows)->ArgName("side")->Arg(20)->Arg(50)->Arg(100);

  void sparse_factor(State &state)
  {
    System       s(static_cast<int>(state.range(0)), true);
    SparseFactor factor;
    if (state.range(1) == 0) // sliding with friction
      {
        s.wall.matrix.symmetric = false;
        for (Mat6 &block : s.wall.matrix.lower)
          block *= 0.99;
      }
    if (!factor.factorize(s.wall.matrix))
      state.SkipWithError("singular");
    for (auto _ : state)
      factor.factorize(s.wall.matrix);
    set_counters(state, s.wall.matrix.n_blocks(), 0., 0.);
  }
  BENCHMARK(sparse_factor)
    ->ArgNames({"side", "symmetric"})
    ->ArgsProduct({{20, 50}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

  void sparse_solve(State &state)
  {
    System       s(static_cast<int>(state.range(0)), true);
    SparseFactor factor;
    if (!factor.factorize(s.wall.matrix))
      state.SkipWithError("singular");
    for (auto _ : state)
      factor.solve(s.x, s.y);
    set_counters(state, s.wall.matrix.n_blocks(), 0., 0.);
  }
  BENCHMARK(sparse_solve)
    ->ArgName("side")
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

  // Surface of the bedrock ------------------------------------------------------------------------

  void surface_product(State &state)
  {
    const int       n = static_cast<int>(state.range(0));
    Eigen::MatrixXd s(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        s(i, j) = (i == j ? 4. : 0.) + 1. / (1. + std::pow(i - j, 2)); // as it decays in 2D
    InterfaceStiffness stiffness;
    stiffness.set(&s);
    const Eigen::VectorXd x = Eigen::VectorXd::Random(n);
    Eigen::VectorXd       y = Eigen::VectorXd::Zero(n);
    for (auto _ : state)
      {
        stiffness.subtract_whole_product(x.data(), y.data());
        benchmark::DoNotOptimize(y.data());
      }
    set_counters(state, n, 4. * n * n, 2. * n * n);
  }
  BENCHMARK(surface_product)->ArgName("unknowns")->Arg(500)->Arg(1000)->Arg(2000);

  // Contacts --------------------------------------------------------------------------------------

  void contact_search_awake(State &state)
  {
    Wall                               wall(static_cast<int>(state.range(0)), false);
    const ContactDetection::Parameters sizes{0.1, 0.25, ContactTolerances::smooth_angle, 0.25};
    for (auto _ : state)
      {
        ContactDetection detection(sizes); // with its list of near pairs
        auto             contacts = wall.run.state.contacts;
        auto             rest     = wall.run.state.rest;
        detection.update(wall.run.state.geometry, contacts, rest);
      }
    set_counters(state, wall.run.model.n_blocks(), 0., 0.);
  }
  BENCHMARK(contact_search_awake)->ArgName("side")->Arg(20)->Arg(50);

  // The machine -----------------------------------------------------------------------------------

  /// What memory gives: a = b + s c.
  void machine_triad(State &state)
  {
    const Eigen::Index    n = state.range(0);
    Eigen::VectorXd       a = Eigen::VectorXd::Zero(n);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n), c = Eigen::VectorXd::Random(n);
    for (auto _ : state)
      {
        a = b + 3. * c;
        benchmark::ClobberMemory();
      }
    set_counters(state, n, 24. * n, 2. * n);
  }
  BENCHMARK(machine_triad)->Arg(1000)->Arg(10000000);
} // namespace

int
main(int argc, char **argv)
{
  omp_set_num_threads(1); // as a run without Parallel/Threads
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
