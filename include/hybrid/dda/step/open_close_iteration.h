// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/interior_contacts.h>
#include <hybrid/dda/step/local_attempt.h>
#include <hybrid/dda/step/open_close_parts.h>
#include <hybrid/dda/step/step_problem.h>
#include <hybrid/dda/step/step_tangent.h>
#include <hybrid/dda/step/update_accuracy.h>

#include <functional>

namespace hybrid::dda
{
  /**
   * One implicit step of blocks and foundation: the open-close iteration.
   *
   * Solves the equations of the step (StepProblem) by Newton's method with their consistent tangent
   * (StepTangent). Not converged is a status: the state is changed only by accept().
   *
   * Contacts change their conditions (open, sticking, sliding) in three ways, each tried where the
   * one before has not settled the step: Newton's method on the active set, from the conditions of
   * the last step; the interior point method on the full Coulomb law (InteriorContacts), which
   * changes all of them together; and a line search with the laws alone, which static stages begin
   * with. Between updates few bodies settle alone (LocalAttempt).
   */
  class OpenCloseIteration
  {
  public:
    /// Asked before every iteration; the step ends unconverged where it returns false.
    using Watch = std::function<bool(const StepResult &)>;

    /// Let @p new_watch be asked from now on.
    void set_watch(Watch new_watch)
    {
      watch = std::move(new_watch);
    }

    /// See LinearSolver.
    void set_processes(const ProcessGroup *processes)
    {
      tangent.set_processes(processes);
    }

    /// Solve the step from @p state; all but @p guess must outlive the call to accept(). @p guess:
    /// the increments of all blocks to begin with, instead of those of the last motion.
    StepResult solve(const Model              &model,
                     const DdaState           &state,
                     const FoundationResponse &foundation,
                     double                    dt,
                     const std::vector<Vec6>  *guess = nullptr);

    /// Make the solved step the new state: move bodies, remember contacts, count failures and
    /// energy.
    void accept(DdaState &state)
    {
      problem.accept(state);
    }

    /// Wall time of all steps so far, but for the search.
    PartTimes part_times() const
    {
      PartTimes sum = problem.times;
      return sum += tangent.times;
    }

    /// The tangent that is kept from one step to the next, for the checkpoint.
    void serialize(restart::Archive &archive);

    /// Increments of all blocks in the solved step.
    const std::vector<Vec6> &increments() const
    {
      return problem.trial.increment;
    }

    /// Where the solved step takes all bodies.
    const Trial &trial() const
    {
      return problem.trial;
    }

    /// The solved step has left all where it was, at rest.
    bool is_at_rest() const
    {
      return at_rest;
    }

    /// Displacement w of the foundation nodes of the solved step [m].
    const Eigen::VectorXd &foundation_displacement() const
    {
      return problem.trial.foundation;
    }

    /// Forces of the blocks on the foundation nodes in the solved step, less the static ones [N/m].
    const Eigen::VectorXd &foundation_force_increment() const
    {
      return problem.foundation_force();
    }

    /// The contacts' part of it [N/m].
    const Eigen::VectorXd &foundation_contact_increment() const
    {
      return problem.foundation_contact_force();
    }

  private:
    Watch           watch;
    StepProblem     problem;
    StepTangent     tangent;
    Eigen::VectorXd update;               ///< of all unknowns
    bool            expects_many = false; ///< iterations, after the last step
    bool            may_rest     = false; ///< the step began without motion, on a base that rests
    bool            at_rest      = false; ///< nothing moves in it
    std::vector<Condition> conditions;    ///< of springs, for the next update
    std::vector<Condition> tangent_conditions; ///< of springs, with the last update
    ActiveSetMemory        memory;
    UpdateAccuracy         accuracy;
    TrialPlace             at_start;
    LocalAttempt           local;
    std::vector<int>       light; ///< blocks that balance_each() moves, ascending

    InteriorContacts       interior;
    PathProgress           path_progress;
    bool                   is_on_path = false; ///< with all contacts
    std::vector<Condition> path_now;           ///< of contacts on the central path
    std::vector<Condition> path_tried;         ///< those from which active sets were tried last
    TrialPlace             on_path;

    /// All methods, one after the other.
    Attempt iterate(StepResult &result);

    /// Active sets, then own strides on the path; failures end where the line search shall begin.
    Attempt settle_contacts(StepResult &result);
    Attempt yield_patiently(StepResult &result); ///< for IterationParameters::is_patient

    /// Updates with frozen conditions, from the trial and the conditions there are.
    Attempt iterate_conditions(StepResult &result, const Patience &patience);

    /// What is left of the balance in these conditions; with bonds that hold until contacts have
    /// settled, see WholeBonds. The path would begin where they have.
    double balance_in_conditions(StepResult &result, WholeBonds &whole);

    /// Let few bodies find their conditions, as long as that helps. @return whether any moved
    bool settle_few(StepResult &result);
    bool settle_few_once(StepResult &result);

    /// What the laws say now; a spring that would slide back, or one that goes round, sticks first.
    void renew_conditions(bool goes_round);

    /// Go on while single bodies are left with forces that would move them.
    void balance_each(StepResult &result);

    /// Those bodies alone, all others held. @return whether that helped
    bool balance_light(StepResult &result, StepProblem::Imbalance &left);

    /// The interior point method, from the start of the step or of the few bodies' attempt.
    Attempt follow_path(StepResult &result, Stride stride);
    Attempt go_to_end_of_path(StepResult &result, Stride stride);

    /// Begin the path. @return its mean product
    double begin_path();

    /// One iteration of the path: the affine direction, and that with centring and correction.
    /// @return part of it that all contacts can go; 0 if the path is too narrow where it begins
    double go_along_path(StepResult &result, Stride stride, bool begins);

    /// Newton's method with a line search by the laws alone.
    Attempt search(StepResult &result);

    /// Move the trial along the update, as far as the residual allows: a contact that changes on
    /// the way would otherwise make the iteration cycle.
    LineSearch search_line();

    /// Solve for the update with the tangent there is.
    void solve_linear(StepResult &result, double tolerance);

    bool is_balanced(const StepResult &result) const; ///< to the tolerance, the bodies that move

    /// True if iterations are left and nobody stops the step.
    bool may_go_on(StepResult &result) const;
  };
} // namespace hybrid::dda
