// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/step/part_times.h>
#include <hybrid/dda/step/secant_correction.h>
#include <hybrid/dda/step/sliding_regularisation.h>
#include <hybrid/dda/step/step_problem.h>

namespace hybrid::dda
{
  /**
   * The tangent of a step's equations and what solves with it, kept from one update to the next,
   * and from one step to the next, as long as it serves.
   */
  class StepTangent
  {
  public:
    /// What a tangent is made of.
    struct Choice
    {
      bool follow_softening; ///< of joints, see SpringStiffness
      bool all;              ///< rows, not only those of springs that have changed
    };

    /// See LinearSolver.
    void set_processes(const ProcessGroup *processes)
    {
      solver.set_processes(processes);
    }

    /// A step begins; before StepProblem::begin().
    void begin(const Model &model, const FoundationResponse &foundation);

    /// The springs of the step have their places in the matrix.
    void connect(StepProblem &problem);

    /// It is not one of the laws, or of another place: the next repair() makes all rows anew.
    void outdate()
    {
      stale = true;
    }

    bool is_outdated() const
    {
      return stale;
    }

    /// repair() leaves it as it is. @param served see there
    bool serves(const bool served) const
    {
      return served && !stale;
    }

    /// Rebuild it if it is outdated or has not served.
    void repair(const StepProblem &problem, bool served, bool follow_softening);

    void assemble(const StepProblem &problem, const Choice &choice);

    /// Solve for the update of all unknowns that takes the residual away, but for @p part of the
    /// forces.
    void
    solve(const StepProblem &problem, double part, Eigen::VectorXd &update, StepResult &result);

    /// The same for a few bodies, all others held.
    void
    solve_few(const StepProblem &problem, LocalSystem &few, double part, Eigen::VectorXd &update);

    /// After an update of which the line search took @p fraction, where sliding is regularised.
    void adapt_sliding(const double fraction)
    {
      stale = sliding.adapt(fraction) || stale;
    }

    const BlockMatrix &rows() const
    {
      return matrix;
    }

    const SpringStiffness &of_springs() const
    {
      return stiffness;
    }

    /// The foundation's own stiffness.
    const InterfaceStiffness &surface() const
    {
      return solver.foundation_stiffness();
    }

    /// What is kept from one step to the next, for the checkpoint.
    void serialize(restart::Archive &archive);

    SecantCorrection secant; ///< of the kept tangent
    PartTimes        times;  ///< of assembly, factors and products

  private:
    SpringStiffness       stiffness;
    BlockMatrix           matrix;
    LinearSolver          solver;
    SlidingRegularisation sliding;
    double                made_for_dt      = -1.; ///< step that the rows were made for [s]
    double                made_for_sliding = 0.;  ///< SlidingRegularisation of them
    int                   made_for_pattern = -1;
    bool                  is_restored      = false; ///< it is that of a checkpoint
    bool                  stale            = false; ///< see outdate()
    int                   repairs          = 0;     ///< tangents rebuilt in this step

    /// Choose the springs and rows to be rebuilt.
    void update_stiffness(const StepProblem &problem, const Choice &choice);

    /// No coupling with nodes, whose motion is given, and the unit matrix for them.
    void cut_nodes_off();
  };
} // namespace hybrid::dda
