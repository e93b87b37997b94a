// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/step/step_tangent.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>

namespace hybrid::dda
{
  void StepTangent::begin(const Model &model, const FoundationResponse &foundation)
  {
    solver.set_slices(model.slice);
    solver.set_foundation_stiffness(foundation.prescribed ? FoundationStiffness()
                                                          : foundation.stiffness);
    if (is_restored)
      solver.matrix_restored(matrix);
    is_restored = false;
    sliding     = {};
  }



  void StepTangent::connect(StepProblem &problem)
  {
    const Stopwatch timer(times.springs);
    problem.springs.connect(*problem.model, matrix);
    stale = stale || made_for_dt != problem.trial.dt ||
            made_for_pattern != matrix.pattern_version() || made_for_sliding > 0.;
    repairs = 0;
  }



  void
  StepTangent::repair(const StepProblem &problem, const bool served, const bool follow_softening)
  {
    constexpr int whole_every = 3; ///< of a step's tangents is made of all rows
    if (serves(served))
      return;
    const bool all = stale || (!problem.is_narrow() && ++repairs % whole_every == 0);
    assemble(problem, {follow_softening, all});
    stale = false;
  }



  void StepTangent::update_stiffness(const StepProblem &problem, const Choice &choice)
  {
    const Model            &model = *problem.model;
    SpringStiffness::Choice springs{choice.follow_softening,
                                    StepKinematics::contact_weight(model.newmark),
                                    sliding.value(),
                                    choice.all || (model.hold_bedrock && model.n_bedrock > 0) ||
                                      model.blocks_yield,
                                    &problem.at_work()};
    stiffness.update(problem.springs, problem.trial, springs);
    if (!stiffness.changed_blocks().empty() || springs.all)
      return;
    // No spring is to blame that the residual does not fall: the directions may be.
    springs.all = true;
    stiffness.update(problem.springs, problem.trial, springs);
  }



  void StepTangent::assemble(const StepProblem &problem, const Choice &choice)
  {
    const Stopwatch timer(times.assembly);
    update_stiffness(problem, choice);
    const std::vector<int> &rebuilt = stiffness.changed_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(rebuilt.size()))
    for (std::size_t k = 0; k < rebuilt.size(); ++k)
      {
        const int b = rebuilt[k];
        matrix.set_row_zero(b);
        matrix.diagonal[b] = problem.block_stiffness(b);
        stiffness.add_rows(problem.springs, b, matrix);
      }
    matrix.set_nodes_zero();
    stiffness.add_foundation(problem.springs, matrix);
    if (!problem.blocks_are_symmetric())
      matrix.symmetric = false;
    if (problem.model->n_bedrock > 0)
      add_bedrock_stiffness(problem.bedrock(), rebuilt, matrix);
    if (problem.foundation->prescribed)
      cut_nodes_off();
    solver.matrix_changed(matrix, rebuilt);
    secant.reset();
    made_for_dt      = problem.trial.dt;
    made_for_sliding = sliding.value();
    made_for_pattern = matrix.pattern_version();
  }



  void StepTangent::cut_nodes_off()
  {
    const auto clear = [](auto &parts) {
      for (auto &part : parts)
        part.setZero();
    };
    clear(matrix.block_node);
    clear(matrix.node_block);
    clear(matrix.node_next);
    clear(matrix.node_previous);
    for (Eigen::Matrix2d &part : matrix.node_diagonal)
      part.setIdentity();
  }



  void StepTangent::solve(const StepProblem &problem,
                          const double       part,
                          Eigen::VectorXd   &update,
                          StepResult        &result)
  {
    const Stopwatch             timer(times.products);
    const LocalSystem::Residual left = problem.left();
    const LinearSolver::Result  linear =
      solver.solve(matrix, left.of_unknowns, left.scale, part * problem.forces(), update);
    times.factors += linear.factor_time;
    times.products -= linear.factor_time;
    result.solver_iterations += linear.iterations;
    result.factorizations += linear.factored ? 1 : 0;
  }



  void StepTangent::solve_few(const StepProblem &problem,
                              LocalSystem       &few,
                              const double       part,
                              Eigen::VectorXd   &update)
  {
    const Stopwatch           timer(times.products);
    const FoundationResponse &foundation = *problem.foundation;
    few.solve(matrix,
              foundation.prescribed ? FoundationStiffness() : foundation.stiffness,
              problem.left(),
              part * problem.forces(),
              update);
  }



  void StepTangent::serialize(restart::Archive &archive)
  {
    bool is_current = made_for_pattern == matrix.pattern_version();
    archive(matrix, stiffness, made_for_dt, is_current, stale, secant);
    solver.serialize(archive);
    if (!archive.is_reading())
      return;
    made_for_pattern = is_current ? matrix.pattern_version() : -1;
    is_restored      = matrix.n_blocks() > 0;
  }
} // namespace hybrid::dda
