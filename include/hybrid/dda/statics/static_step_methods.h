// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/stick_predictor_steps.h>

#include <limits>
#include <optional>

namespace hybrid::dda
{
  /**
   * How static steps are solved: by the line search; where a loose mass does not settle so, from
   * where contacts that never slide would bring it (StickPredictorSteps); and where that fails,
   * too, or where a bonded mass does not settle by the line search, by the interior point method,
   * in which contacts and bonds change their conditions together. The last takes more iterations
   * than small masses need, but hardly more for large ones.
   */
  class StaticStepMethods
  {
  public:
    static constexpr double first_step = 0.0156; ///< pseudo time step [s]

    /// @param watch may be empty
    StaticStepMethods(const Model &static_problem, OpenCloseIteration::Watch watch);

    // The solvers refer to the models beside them.
    StaticStepMethods(const StaticStepMethods &)            = delete;
    StaticStepMethods &operator=(const StaticStepMethods &) = delete;

    /// Solve a step.
    StepResult solve(DdaState &state, const FoundationResponse &foundation, double dt);

    /// Make the solved step the new state.
    void accept(DdaState &state);

    /// A step did not converge: go on with the next method if there is one for this mass.
    /// @param hopeless the line search is not worth another try. @return the step to go on with [s]
    double step_failed(const DdaState &state, double dt, bool hopeless);

    /// By the interior point method many steps in a row have not lowered the force that is left:
    /// the mass moves on, but not through the air. @param unbalanced that force after another step
    /// [-]
    bool leads_nowhere(double unbalanced);

    /// A step of a bonded mass has not converged by the line search: bonds and contacts of many
    /// blocks slide.
    bool slides_in_bonds() const
    {
      return in_bonds;
    }

    PartTimes part_times() const;

  private:
    enum class Method
    {
      line_search,
      from_hold,
      on_path
    };

    const Model                       &problem;
    OpenCloseIteration::Watch          watch;
    Method                             method = Method::line_search;
    std::optional<BlockSolver>         plain; ///< as the others only while it serves
    PartTimes                          times; ///< of methods that no longer serve
    std::optional<StickPredictorSteps> from_hold;
    std::optional<Model>       together; ///< the problem, with contacts that change together
    std::optional<BlockSolver> path;
    double least = std::numeric_limits<double>::infinity(); ///< force left after a step [-]
    int    vain  = 0; ///< steps in a row that have not lowered it

    bool in_bonds = false; ///< see slides_in_bonds()

    void go_on_path();
  };
} // namespace hybrid::dda
