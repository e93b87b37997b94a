// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/springs/springs.h>
#include <hybrid/dda/step/foundation_response.h>
#include <hybrid/dda/step/full_step_phase.h>
#include <hybrid/dda/step/part_times.h>
#include <hybrid/dda/step/sliding_regularisation.h>

#include <functional>
#include <limits>

namespace hybrid::dda
{
  /// What became of one step of the blocks.
  struct StepResult
  {
    bool   converged          = false; ///< if not, nothing was changed: cut the step
    bool   stopped            = false; ///< by whoever watches the iteration
    int    iterations         = 0;     ///< of the open-close iteration
    int    solver_iterations  = 0;     ///< of the linear solver, summed
    int    factorizations     = 0;
    double residual           = 0.; ///< relative force residual at the end [-]
    double displacement_ratio = 0.; ///< largest displacement over block size [-]
    double unbalanced =
      0.; ///< relative inertial force at the end (the static residual of a step from rest) [-]
    int largest_block = -1; ///< block that moved most, relative to its size
  };


  /**
   * One implicit step of blocks and foundation: the open-close iteration.
   *
   * Finds the increments d of all blocks and the displacement w of the foundation
   * nodes so that at the end of the step inertia, stresses, joints, contacts
   * and weight balance,
   *
   *     M (a(d) - (1/(2 beta)) c) + A_0 (s + D e(d) + beta_K D e(d)/dt) = W + sum of bonds G^T f,
   *     M c = sum of contacts G^T f,
   *     S w = g + bonds on the foundation + (1/(2 beta)) contacts on the foundation, less those at
   * rest,
   *
   * where c acts through the whole step (see Springs: (d - d*) / (beta dt^2) = a + c / (2 beta)),
   * on blocks and foundation alike, so that the impulse of one is that of the other, with f(d, w),
   * gaps and slips of the exact finite motion and contact states that agree with the forces.
   * beta_K: block_damping_times(). Newton's method with the consistent tangent; the tangent is kept
   * as long as it serves. Not converged is a status: the state is changed only by accept().
   *
   * The first iterations take full steps, and a joint or contact whose slip would turn round
   * sticks before it may slide back (Shi 1988). With its friction at once the other way a line
   * search ends near the first contact of hundreds that should stick, and every iteration finds but
   * one of them. Only if whole updates do not settle there is a line search, with the law alone.
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
    Watch                 watch;
    Springs               springs;
    SpringStiffness       stiffness;
    BlockMatrix           matrix;
    LinearSolver          solver;
    SlidingRegularisation sliding_regularisation;
    Trial                 trial;
    std::vector<Mat6>     mass;
    std::vector<double>   damping_time; ///< beta_K of each block in this step [s]
    std::vector<Vec6>     predicted;    ///< Newmark's d*: a = (d - d*) / (beta dt^2)
    std::vector<Vec6>     start_rate;   ///< velocity that the step begins with, k01 v
    std::vector<Vec6> acceleration; ///< of all but contacts, end of the solved step, not yet turned
    std::vector<Vec6> contact_acceleration; ///< of contacts, likewise
    Eigen::VectorXd   residual, absolute, scale, update, force_increment, contact_increment;
    // The foundation's balance is taken from where the trial starts: at S w the round-off of a
    // stiff foundation that moves as a whole would hide the forces of soft blocks.
    Eigen::VectorXd foundation_start; ///< load less S times the displacement at the start [N/m]
    Eigen::VectorXd foundation_moved; ///< displacement since then [m]
    Eigen::VectorXd contact_force;    ///< of contacts on blocks and foundation nodes
    Eigen::VectorXd incoming;         ///< at artificial boundaries, end of the step [N/m]
    double          tangent_dt             = -1.; ///< step of the tangent in matrix
    double          tangent_regularisation = 0.;  ///< SlidingRegularisation of it
    int             tangent_pattern        = -1;
    bool            is_restored            = false; ///< the tangent is that of a checkpoint
    bool            expects_many           = false; ///< iterations, after the last step
    FullStepPhase   full_step_phase;
    bool            full_steps           = false; ///< updates: no line search, SlipReversal::locks
    bool            guesses_acceleration = true;  ///< the trial begins as if it stayed the same
    double          reference            = 0.;    ///< norm of absolute forces [N]
    PartTimes       times;

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

    /// force -= S displacement
    void subtract_foundation_product(const Eigen::VectorXd      &displacement,
                                     Eigen::Ref<Eigen::VectorXd> force) const;

    void move(const DdaState &state);

    /// Acceleration of a block by the contacts' forces in the trial.
    Vec6 acceleration_by_contacts(int block) const;

    /// Velocity of a block at the end of the trial: with 2 beta = gamma the mean of both ends is
    /// the increment over dt, whatever the forces.
    Vec6 end_rate(int block) const
    {
      return 2. / trial.dt * trial.increment[block] - start_rate[block];
    }

    /// Forces of the trial and what is left of the balance; they depend on the trial alone (while
    /// it full_steps, on that of Springs::remember() as well). @return relative norm of the
    /// residual
    double
    evaluate(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Add the water's forces to the residual.
    void add_water(const Model &model, const DdaState &state);

    void add_edge_loads(const Model &model, const DdaState &state);

    /// What a tangent is made of.
    struct Tangent
    {
      bool follow_softening; ///< of joints, see SpringStiffness
      bool all;              ///< rows, not only those of springs that have changed
    };

    void assemble(const Model              &model,
                  const DdaState           &state,
                  const FoundationResponse &foundation,
                  const Tangent            &tangent);

    /// The update that takes the residual away but for @p tolerance [N].
    LinearSolver::Result solve_linear(double tolerance);

    /// Where a line search ended.
    struct LineSearch
    {
      double residual; ///< relative norm there
      double fraction; ///< of the update that was taken
    };

    /// Choose the springs and rows to be rebuilt.
    void update_stiffness(const Model &model, const Tangent &tangent);

    /// Move the trial along the update, as far as the residual allows: a contact that locks, closes
    /// or slides back on the way would otherwise make the iteration cycle. All of it while
    /// it full_steps.
    LineSearch
    search_line(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Set the trial's motion to the guess: velocities as they were, and accelerations if
    /// guesses_acceleration; the foundation where the rock brings it.
    void
    start_trial(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// Begin the trial with the acceleration as it was or, far from balance, with none where that
    /// is closer. @return relative norm of the residual there
    double
    choose_guess(const Model &model, const DdaState &state, const FoundationResponse &foundation);

    /// End whole updates: go on by the law alone from where they led, or from the start if that is
    /// closer. @return relative norm of the residual there
    double begin_line_search(const Model              &model,
                             const DdaState           &state,
                             const FoundationResponse &foundation);

    /// Displacement of a block in the trial over its size [-].
    double displacement_ratio(const Model &model, int block) const;

    /// True if a block that nothing is near flies farther than a step may move it: no need to
    /// solve.
    bool flies_too_far(const Model &model, StepResult &result) const;

    void judge(const Model &model, StepResult &result) const;

    /// Rates and accelerations of the solved step.
    void finish(const Model &model);

    /// Joints that are torn or released in this step hand nothing to the next one either: the
    /// contacts' part of accelerations and of the foundation force is set in @p state.
    void carry_contact_accelerations(const Model &model, DdaState &state) const;
  };
} // namespace hybrid::dda
