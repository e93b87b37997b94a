// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/dda/springs/interior_contacts.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/springs/springs.h>
#include <hybrid/dda/step/block_stresses.h>
#include <hybrid/dda/step/foundation_response.h>
#include <hybrid/dda/step/local_attempt.h>
#include <hybrid/dda/step/open_close_parts.h>
#include <hybrid/dda/step/part_times.h>
#include <hybrid/dda/step/secant_correction.h>
#include <hybrid/dda/step/settled_islands.h>
#include <hybrid/dda/step/sliding_regularisation.h>
#include <hybrid/dda/step/step_kinematics.h>
#include <hybrid/dda/step/step_result.h>
#include <hybrid/dda/step/update_accuracy.h>

#include <functional>
#include <limits>

namespace hybrid::dda
{
  /**
   * One implicit step of blocks and foundation: the open-close iteration.
   *
   * Finds the increments d of all blocks and the displacement w of the foundation
   * nodes so that at the end of the step inertia, stresses, joints, contacts
   * and weight balance,
   *
   *     M (a(d) - (1/(2 beta)) c) + A_0 (s + D e(d) + beta_K D e(d)/dt) = W + sum of bonds G^T f,
   *     M c = sum of contacts G^T f,
   *     S w = g + bonds + (1/(2 beta)) contacts, both on the foundation and less those at rest,
   *
   * where c acts through the whole step (see Springs: (d - d*) / (beta dt^2) = a + c / (2 beta)),
   * on blocks and foundation alike, so that the impulse of one is that of the other, with f(d, w),
   * gaps and slips of the exact finite motion and contact states that agree with the forces.
   * beta_K: block_damping_times(). Newton's method with the consistent tangent; the tangent is kept
   * as long as it serves. Not converged is a status: the state is changed only by accept().
   *
   * Contacts change their conditions (open, sticking, sliding) in three ways, each tried where the
   * one before has not settled the step: Newton's method on the active set, from the conditions of
   * the last step; the interior point method on the full Coulomb law (InteriorContacts), which
   * changes all of them together; and a line search with the laws alone, which is all that steps
   * without inertia know. Between updates few bodies settle alone (LocalAttempt).
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
      solver.set_processes(processes);
    }

    /// Solve the step from @p state; @p model must outlive the call to accept(). @p guess: the
    /// increments of all blocks to begin with, instead of those of the last motion.
    StepResult solve(const Model              &model,
                     const DdaState           &state,
                     const FoundationResponse &foundation,
                     double                    dt,
                     const std::vector<Vec6>  *guess = nullptr);

    /// Make the solved step the new state: move bodies, remember contacts, count failures and
    /// energy.
    void accept(const Model &model, DdaState &state) const;

    /// Wall time of all steps so far, but for the search.
    const PartTimes &part_times() const
    {
      return times;
    }

    /// The tangent that is kept from one step to the next, for the checkpoint.
    void serialize(restart::Archive &archive);

    /// Increments of all blocks in the solved step.
    const std::vector<Vec6> &increments() const
    {
      return trial.increment;
    }

    /// The solved step has left all where it was, at rest.
    bool is_at_rest() const
    {
      return at_rest;
    }

    /// Displacement w of the foundation nodes of the solved step [m].
    const Eigen::VectorXd &foundation_displacement() const
    {
      return trial.foundation;
    }

    /// Forces of the blocks on the foundation nodes in the solved step, less the static ones [N/m].
    const Eigen::VectorXd &foundation_force_increment() const
    {
      return force_increment;
    }

    /// The contacts' part of it [N/m].
    const Eigen::VectorXd &foundation_contact_increment() const
    {
      return contact_increment;
    }

  private:
    Watch                  watch;
    Springs                springs;
    SpringStiffness        stiffness;
    BlockMatrix            matrix;
    LinearSolver           solver;
    SlidingRegularisation  sliding_regularisation;
    Trial                  trial;
    BlockStresses          stresses;
    std::vector<BlockMass> mass;
    StepKinematics         kinematics;
    std::vector<double>    damping_time; ///< beta_K of each block in this step [s]
    std::vector<Vec6> acceleration; ///< of all but contacts, end of the solved step, not yet turned
    std::vector<Vec6> contact_acceleration; ///< of contacts, likewise
    Eigen::VectorXd   residual, absolute, scale, update, force_increment, contact_increment;
    // The foundation's balance is taken from where the trial starts: at S w the round-off of a
    // stiff foundation that moves as a whole would hide the forces of soft blocks.
    Eigen::VectorXd  foundation_start; ///< load less S times the displacement at the start [N/m]
    Eigen::VectorXd  foundation_moved; ///< displacement since then [m]
    Eigen::VectorXd  contact_force;    ///< of contacts on blocks and foundation nodes
    Eigen::VectorXd  incoming;         ///< at artificial boundaries, end of the step [N/m]
    double           tangent_dt             = -1.; ///< step of the tangent in matrix
    double           tangent_regularisation = 0.;  ///< SlidingRegularisation of it
    int              tangent_pattern        = -1;
    bool             is_restored            = false; ///< the tangent is that of a checkpoint
    bool             expects_many           = false; ///< iterations, after the last step
    bool             guesses_acceleration   = true;  ///< the trial begins as if it stayed the same
    bool             may_rest  = false; ///< the step began without motion, on a base that rests
    bool             at_rest   = false; ///< nothing moves in it
    double           reference = 0.;    ///< norm of absolute forces [N]
    InteriorContacts interior;
    SettledIslands   islands;
    std::vector<Condition> conditions;         ///< of springs, for the next update
    std::vector<Condition> tangent_conditions; ///< of springs, with the last update
    std::vector<Condition> path_now;           ///< of contacts on the central path
    std::vector<Condition> path_tried;         ///< those from which active sets were tried last
    bool             stale   = false; ///< the tangent is not one of the laws, or of another step
    int              repairs = 0;     ///< tangents rebuilt in this step
    ActiveSetMemory  memory;
    UpdateAccuracy   accuracy;
    SecantCorrection secant; ///< of the kept tangent
    PartTimes        times;
    LocalAttempt     local;
    PathProgress     path_progress;
    bool             is_on_path = false; ///< with all contacts

    static constexpr double nearly_at_rest = 1e-6; ///< out of balance, of forces or weights [-]
    TrialPlace              at_start, on_path;

    void keep(TrialPlace &place) const;
    using Step = StepUnderWay;

    /// Move the trial to a place, and see what is left of the balance there.
    void go_back(const Step &step, const TrialPlace &place);

    /// All methods, one after the other.
    Attempt iterate(const Step &step);

    /// Active sets, then own strides on the path; failures end where the line search shall begin.
    Attempt settle_contacts(const Step &step);
    Attempt yield_patiently(const Step &step); ///< for IterationParameters::is_patient

    /// Updates with frozen conditions, from the trial and the conditions there are.
    Attempt iterate_conditions(const Step &step, const Patience &patience);

    /// Let few bodies find their conditions, as long as that helps. @return whether any moved
    bool settle_few(const Step &step);
    bool settle_few_once(const Step &step);

    bool is_balanced(const Step &step) const; ///< to the tolerance, the bodies that move

    double relative_residual() const; ///< of the bodies that move, over the reference [-]

    /// What the laws say now; a spring that would slide back, or one that goes round, sticks first.
    void renew_conditions(bool goes_round);

    /// The interior point method, from the start of the step or of the few bodies' attempt.
    Attempt follow_path(const Step &step, Stride stride);
    Attempt go_to_end_of_path(const Step &step, Stride stride);

    /// Begin the path. @return its mean product
    double begin_path(const Step &step);

    /// One iteration of the path: the affine direction, and that with centring and correction.
    /// @return part of it that all contacts can go; 0 if the path is too narrow where it begins
    double go_along_path(const Step &step, Stride stride, bool begins);

    /// Newton's method with a line search by the laws alone.
    Attempt search(const Step &step);

    /// Rebuild the tangent if it is stale or has not served: @p previous is the residual before.
    void repair(const Step &step, bool served, double previous);

    /// Solve for the update with the tangent there is.
    void solve_linear(const Step &step, double tolerance);

    /// Move the trial along the update.
    void take(const Step &step, double fraction);

    /// True if iterations are left and nobody stops the step.
    bool may_go_on(const Step &step);

    /// Leave islands that are balanced where they are.
    void settle_islands(const Step &step);

    /// Residual of the springs' present responses. @return its relative norm
    double balance(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Collect the springs and set where the iteration starts.
    void begin(const Model              &model,
               const DdaState           &state,
               const FoundationResponse &foundation,
               double                    dt,
               const std::vector<Vec6>  *guess);

    void predict(const Model              &model,
                 const DdaState           &state,
                 const FoundationResponse &foundation,
                 double                    dt);

    void move(const DdaState &state);
    bool moves_nothing(const Step &step) const;     ///< neither base nor trial of what may stop
    bool lies_in_balance(const Model &model) const; ///< to the tolerance, and every block nearly

    /// Acceleration of a block by the contacts' forces in the trial.
    Vec6 acceleration_by_contacts(int block) const;

    /// Velocity of a block at the end of the trial.
    Vec6 end_rate(const int block) const
    {
      return kinematics.end_rate(block, trial.increment[block]);
    }

    /// Forces of the trial and what is left of the balance; they depend on the trial alone.
    /// @return relative norm of the residual
    double
    evaluate(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    void add_water(const Model &model, const DdaState &state); ///< forces, to the residual
    void add_edge_loads(const Model &model, const DdaState &state);

    void assemble(const Model              &model,
                  const DdaState           &state,
                  const FoundationResponse &foundation,
                  const Tangent            &tangent);

    /// Choose the springs and rows to be rebuilt.
    void update_stiffness(const Model &model, const Tangent &tangent);

    /// Move the trial along the update, as far as the residual allows: a contact that changes on
    /// the way would otherwise make the iteration cycle.
    LineSearch
    search_line(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Set the trial's motion to the guess: velocities as they were, and accelerations if
    /// guesses_acceleration; the foundation where the rock brings it.
    void
    start_trial(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Forces that no motion at all in this step would leave, relative to the weights [-].
    double unbalanced_without_motion(const Model &model, const DdaState &state) const;

    /// Begin the trial without motion if the mass rests, else with the acceleration as it was or,
    /// far from balance, with none where that is closer. @return relative norm of the residual
    /// there
    double
    choose_guess(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Displacement of a block in the trial over its size [-].
    double displacement_ratio(const Model &model, int block) const;

    /// A block that nothing is near flies farther than a step may move it: nothing to solve.
    bool flies_too_far(const Model &model, StepResult &result) const;

    void judge(const Model &model, StepResult &result) const;

    /// Rates and accelerations of the solved step.
    void finish(const Model &model);

    /// Joints that are torn or released in this step hand nothing to the next one either: the
    /// contacts' part of accelerations and of the foundation force is set in @p state.
    void carry_contact_accelerations(const Model &model, DdaState &state, bool any_tears) const;
  };
} // namespace hybrid::dda
