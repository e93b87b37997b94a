// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/interface_stiffness.h>
#include <hybrid/dda/linear/local_system.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/springs/springs.h>
#include <hybrid/dda/step/block_stresses.h>
#include <hybrid/dda/step/blocks_at_work.h>
#include <hybrid/dda/step/foundation_response.h>
#include <hybrid/dda/step/part_times.h>
#include <hybrid/dda/step/shared_trial.h>
#include <hybrid/dda/step/step_kinematics.h>
#include <hybrid/dda/step/step_result.h>

namespace hybrid::dda
{
  /// Where a trial was.
  struct TrialPlace
  {
    std::vector<Vec6> increment;  ///< of each block
    Eigen::VectorXd   foundation; ///< displacement of the foundation nodes [m]
  };


  /**
   * The equations of one implicit step of blocks and foundation, and a trial of their unknowns.
   *
   * Wanted are the increments d of all blocks and the displacement w of the foundation nodes so
   * that at the end of the step inertia, stresses, joints, contacts and weight balance,
   *
   *     M (a(d) - (1/(2 beta)) c) + A_0 (s + D e(d) + beta_K D e(d)/dt) = W + sum of bonds G^T f,
   *     M c = sum of contacts G^T f,
   *     S w = g + bonds + (1/(2 beta)) contacts, both on the foundation and less those at rest,
   *
   * where c acts through the whole step (see Springs: (d - d*) / (beta dt^2) = a + c / (2 beta)),
   * on blocks and foundation alike, so that the impulse of one is that of the other, with f(d, w),
   * gaps and slips of the exact finite motion and contact states that agree with the forces.
   * beta_K: block_damping_times().
   *
   * The residual depends on the trial alone, and on what springs were told to bear (prescribe()).
   * All bodies but few may be held for a while (narrow()). Several processes share the evaluations
   * (SharedTrial): all have the residual then, but each only the springs of its own blocks, until
   * complete(). The state is changed by accept() alone; it, model and foundation outlive the step.
   */
  class StepProblem
  {
  public:
    /// A step begins: collect its springs and predict its motion.
    void begin(const Model              &block_model,
               const DdaState           &state,
               const FoundationResponse &response,
               double                    dt);

    /// Begin the trial without motion if the mass rests, else with the acceleration as it was or,
    /// far from balance, with none where that is closer. @return as evaluate()
    double choose_start();

    /// What the laws make of the trial, and what that leaves. @return relative_residual()
    double evaluate();

    /// What is left of the balance with what springs bear now. @return relative_residual()
    double balance();

    /// See Springs::prescribe().
    bool prescribe(const std::vector<Condition> &conditions);

    /// See Springs::hold_bonds(); until the next evaluate().
    bool hold_bonds();

    /// Evaluations are shared with other processes now.
    bool is_shared() const
    {
      return shared.is_on() && !is_narrow();
    }

    /// Who owns what while trials are shared.
    const SharedTrial &share() const
    {
      return shared;
    }

    /// Find what springs of others' blocks do in the trial, too, as the laws say or
    /// @p conditions prescribe.
    void complete(const std::vector<Condition> *conditions = nullptr);

    /// Let every process evaluate everything, in this step.
    void evaluate_alone();

    /// Norm of what is left of the balance, of the bodies that are not held, over forces() [-].
    double relative_residual() const;

    /// The same of all bodies, whatever is held.
    double whole_residual() const;

    /// Move the trial by a part of an update of all unknowns; not evaluated.
    void move(const Eigen::VectorXd &update, double fraction);

    void keep(TrialPlace &place) const;

    /// Move the trial to a place. @return as evaluate()
    double go_back(const TrialPlace &place);

    /// Hold all bodies but these until widen().
    void narrow(const LocalSystem &bodies);

    void widen();

    bool is_narrow() const
    {
      return few != nullptr;
    }

    /// A block that nothing is near flies farther than a step may move it: nothing to solve.
    bool flies_too_far(StepResult &result) const;

    /// The trial moves neither the base nor any block, and a mass may stop here.
    bool moves_nothing() const;

    /// To the tolerance, and every block nearly.
    bool lies_in_balance() const;

    /// Blocks of the mass out of balance: more than a millionth is left of their own forces, and of
    /// what would accelerate the block as much as any; with a coarse tolerance a hundred times it.
    struct Imbalance
    {
      double worst         = 0.; ///< largest force that is left, over what may be [-]
      double least_allowed = 0.; ///< least force that may be left on one of them [N]

      bool is_any() const
      {
        return worst > 1.;
      }
    };

    /// @param blocks receives those blocks beside what it has, ascending
    Imbalance imbalance(std::vector<int> &blocks) const;

    /// The trial is the solution: its rates and accelerations. @param rests all stops where it is
    void finish(bool rests);

    /// How far the solution goes, and how much of it is inertia.
    void judge(StepResult &result) const;

    /// Make the solution the new state: move bodies, remember contacts, count failures and energy.
    void accept(DdaState &state);

    /// Blocks that are not held, ascending.
    const std::vector<int> &at_work() const
    {
      return blocks_at_work.at_work();
    }

    /// What the balance lacks, and the scale of its norm.
    LocalSystem::Residual left() const
    {
      return {residual, scale};
    }

    /// Norm of absolute forces, what residuals are compared with [N].
    double forces() const
    {
      return reference;
    }

    /// The bedrock's part of the step.
    BedrockStep bedrock() const
    {
      return {*model, *before, trial, incoming};
    }

    /// Inertia and stiffness of a block alone.
    Mat6 block_stiffness(int block) const;

    /// Whether the stiffness of all blocks is symmetric.
    bool blocks_are_symmetric() const
    {
      return stresses.is_symmetric();
    }

    /// Forces of the blocks on the foundation nodes, less the static ones [N/m].
    const Eigen::VectorXd &foundation_force() const
    {
      return force_increment;
    }

    /// The contacts' part of it [N/m].
    const Eigen::VectorXd &foundation_contact_force() const
    {
      return contact_increment;
    }

    const Model              *model      = nullptr;
    const DdaState           *before     = nullptr; ///< the state when the step began
    const FoundationResponse *foundation = nullptr;
    const InterfaceStiffness *surface    = nullptr; ///< the foundation's S; set before begin()
    Springs                   springs;
    Trial                     trial;
    PartTimes                 times; ///< of springs and surface products

  private:
    static constexpr double nearly_at_rest = 1e-6; ///< out of balance, of forces or weights [-]

    const LocalSystem     *few = nullptr; ///< bodies that move, if not all
    BlocksAtWork           blocks_at_work;
    BlockStresses          stresses;
    StepKinematics         kinematics;
    std::vector<BlockMass> mass;
    std::vector<double>    damping_time;    ///< beta_K of each block [s]
    bool                   at_rest = false; ///< nothing moves in the solution
    // Of the solution, not yet turned with the blocks: accelerations of all but contacts, of
    // contacts.
    std::vector<Vec6> acceleration, contact_acceleration;
    Eigen::VectorXd   residual, scale;
    Eigen::VectorXd   absolute;       ///< sum of absolute forces of each block [N]
    double            reference = 0.; ///< their norm [N]
    Eigen::VectorXd   contact_force;  ///< of contacts on blocks and foundation nodes
    Eigen::VectorXd   force_increment, contact_increment;
    Eigen::VectorXd   incoming; ///< at artificial boundaries, end of the step [N/m]
    // The foundation's balance is taken from where the trial starts: at S w the round-off of a
    // stiff foundation that moves as a whole would hide the forces of soft blocks.
    Eigen::VectorXd foundation_start; ///< load less S times the displacement at the start [N/m]
    Eigen::VectorXd foundation_moved; ///< displacement since then [m]

    SharedTrial       shared;
    bool              is_complete    = true;  ///< springs of others' blocks are those of the trial
    bool              bonds_hold     = false; ///< that crack in the trial
    bool              lacks_contacts = false; ///< contact_force is old where others' blocks are
    std::vector<Vec2> turned;                 ///< work of accept(): turned_beyond_bonds()

    void predict(double dt);

    /// Blocks whose balance this process sums up.
    const std::vector<int> &summed() const
    {
      return is_shared() ? shared.blocks() : at_work();
    }

    /// The trial begins with velocities as they were, perhaps with accelerations, too; the
    /// foundation where the rock brings it.
    void start_trial(bool with_acceleration);

    /// Forces that no motion at all in this step would leave, relative to the weights [-].
    double unbalanced_without_motion() const;

    void move_blocks();

    void clear_forces();

    /// Get the sums of others' blocks where they are shared.
    void exchange_sums();

    /// Of a block in the trial [Pa].
    Eigen::Vector3d block_stress(int block);

    /// What the balance of a block lacks [N].
    double left_of(int block) const;

    /// Of a block in the trial, with the weight of its contacts [m/s2, 1/s2].
    Vec6 inertial_acceleration(const int block) const
    {
      return kinematics.inertia(block) * (trial.increment[block] - kinematics.predicted(block));
    }

    /// Inertia, stresses and weights.
    void add_block_forces();

    void add_water();
    void add_edge_loads();
    void add_foundation_balance();

    /// Acceleration of a block by the contacts' forces in the trial.
    Vec6 acceleration_by_contacts(int block) const;

    /// Velocity of a block at the end of the trial.
    Vec6 end_rate(const int block) const
    {
      return kinematics.end_rate(block, trial.increment[block]);
    }

    /// Displacement of a block in the trial over its size [-].
    double displacement_ratio(int block) const;

    void accept_energy(DdaState &state) const;

    /// @param kept of the memories, see Newmark. @return whether any joint becomes more of a
    /// contact
    bool accept_joints(double kept, DdaState &state) const;
    void find_turned(const DdaState &state);
    void accept_block(int block, double kept, DdaState &state) const;
    void accept_places(DdaState &state) const;
    void accept_contacts(DdaState &state) const;

    void keep_angular_momentum(DdaState &state) const; ///< see contact_couple()

    /// Joints that are torn or released in this step hand nothing to the next one either: the
    /// contacts' part of accelerations and of the foundation force is set in @p state.
    void carry_contact_accelerations(DdaState &state, bool any_tears) const;
  };
} // namespace hybrid::dda
