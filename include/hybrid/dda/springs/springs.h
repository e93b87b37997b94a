// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/joint/contact_state.h>
#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/bonded_area.h>
#include <hybrid/dda/springs/springs_of_blocks.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

namespace hybrid::dda
{
  /// A trial of the step: where the unknowns would take all bodies.
  struct Trial
  {
    double                   dt = 0.;      ///< [s]
    std::vector<Vec6>        increment;    ///< d of each block
    std::vector<Vec6>        rate;         ///< velocity of each block at the end of the step
    std::vector<BlockMotion> motion;       ///< finite motion of each block
    std::vector<Vec2>        displacement; ///< of each vertex over the step [m]
    Eigen::VectorXd          foundation;   ///< displacement of the foundation nodes at the end [m]
  };


  /**
   * The springs of one time step: the ends of unreleased joints and the vertex-edge contacts, all
   * seen as pairs of points P (on a block) and Q (on another block or the foundation) with a normal
   * from P to Q. The force on Q is N n + T t times the length, the opposite acts on P, both at one
   * place, so action equals reaction in force and moment.
   *
   * Contacts, and ends of joints torn for good, are integrated implicitly: their force at the end
   * of the step acts through the whole step, d = ... + dt^2/2 M^-1 F, v = ... + dt M^-1 F, and is
   * gone when the step is over (after Kane, Repetto, Ortiz and Marsden 1999). A joint with the
   * damage D is both, side by side: a bond of the part 1 - D and a contact of the part D.
   */
  class Springs
  {
  public:
    /// Normal traction, compression positive, and shear traction [Pa].
    struct Traction
    {
      double normal, shear;
    };

    /// Fixed data of one spring during a step.
    struct Spring
    {
      int    block;                     ///< of P
      int    other;                     ///< block of Q, or foundation_body
      int    node[2]          = {0, 0}; ///< foundation nodes of Q
      int    joint            = -1;     ///< number of the joint, or -1
      int    contact          = -1;     ///< number of the contact, or -1
      int    end              = 0;      ///< of the joint
      double contact_fraction = 0.;     ///< that acts as a contact [-]: 1, or the joint's damage
      const JointLaw *law     = nullptr;
      double          length  = 0.;               ///< [m]
      double          cohesion_length_ratio = 1.; ///< see JointKinematics [-]
      bool            coulomb = false; ///< acts as a contact alone, see JointLaw::is_coulomb()
      Vec2            along   = Vec2::Zero(); ///< unit vector of a contact's edge at the start
      int             part    = -1;           ///< of a joint that acts as both: in contact_parts
      SpringState     old;                    ///< when the step began

      /// A joint with a damage between none and all.
      bool acts_as_both() const
      {
        return joint >= 0 && contact_fraction > 0. && contact_fraction < 1.;
      }

      /// What acts as a contact at the start or end of the step.
      Traction contact_traction(const SpringState &state) const
      {
        return Springs::contact_traction(state, contact_fraction);
      }
    };

    /// What the part that is a contact bears.
    static Traction contact_traction(const SpringState &state, const double fraction)
    {
      return {fraction * std::max(0., state.elastic_normal), fraction * state.shear};
    }

    /// Generalised forces on both bodies.
    struct Forces
    {
      Vec6 on_block, on_other;
    };

    /// What a trial makes of one spring.
    struct Response
    {
      Vec2        normal, tangent;          ///< unit vectors; normal from P to Q
      Vec2        place;                    ///< where the force acts [m]
      double      weight[2]     = {1., 0.}; ///< of the foundation nodes
      double      edge_position = 0.;       ///< projection on the contact's edge [-]
      SpringState now;                      ///< if the step is accepted
      double      shear_strength = 0.;      ///< that its shear may reach [Pa]
      double      mohr_coulomb   = 0.;      ///< see JointResponse [Pa]
      double      k_nn = 0., shear_by_slip = 0., k_tn = 0.; ///< tangents [Pa/m]
      Traction    taken_back{0., 0.}; ///< of a bond that is torn in this step, see torn_bond.h [Pa]

      /// That acts in this step.
      Traction acting() const
      {
        return {now.normal - taken_back.normal, now.shear - taken_back.shear};
      }
    };

    /// Collect the springs of the step that starts from @p state.
    void collect(const Model &model, const DdaState &state);

    /// Set the matrix pattern that these springs need (kept if it holds them already) and find the
    /// slots.
    void connect(const Model &model, BlockMatrix &matrix);

    /// Forces of the springs in a trial: of that trial alone. Same bits for any number of threads.
    void evaluate(const Model &model, const DdaState &state, const Trial &trial);

    /// What a spring did in the trial evaluated last.
    Condition condition(std::size_t number) const
    {
      return bearing[number].condition;
    }

    /// Let springs bear in the trial evaluated last what they would in these conditions: contacts
    /// in any (Spring::coulomb), others if they shall stick. @return whether that changes one.
    bool prescribe(const Model                  &model,
                   const DdaState               &state,
                   const Trial                  &trial,
                   const std::vector<Condition> &conditions);

    /// Let bonds that crack in the trial evaluated last, or begin to slide, bear what they would if
    /// they did neither in this step. @return whether there are any
    bool hold_bonds(const Model &model, const DdaState &state, const Trial &trial);

    /// Only springs of these blocks and foundation nodes are at work until widen(): the responses
    /// of all others stay.
    void narrow(const std::vector<int> &blocks, const std::vector<int> &nodes);

    /// Likewise only these.
    void choose(const std::vector<int> &numbers)
    {
      chosen = &numbers;
    }

    void widen()
    {
      chosen = nullptr;
    }

    std::size_t n_at_work() const
    {
      return chosen != nullptr ? chosen->size() : springs.size();
    }

    /// Number of the spring at work at place @p k.
    std::size_t at_work(const std::size_t k) const
    {
      return chosen != nullptr ? static_cast<std::size_t>((*chosen)[k]) : k;
    }

    /// Bring the forces of one spring up to date with tractions that were set.
    void set_forces(const Trial &trial, std::size_t s);

    /// Add forces on blocks and foundation nodes, of bonds and of contacts apart, and their
    /// absolute values to @p absolute. @param blocks that are asked for, if not all
    void add_forces(Eigen::VectorXd        &bonds,
                    Eigen::VectorXd        &contacts,
                    Eigen::VectorXd        &absolute,
                    const std::vector<int> *blocks = nullptr) const;

    /// Generalised forces that a traction of one spring makes in the trial evaluated last.
    Forces forces_of(const Trial &trial, std::size_t number, const Traction &traction) const;

    /// Add what a traction of one spring does on its blocks or foundation nodes.
    void add_force(const Trial     &trial,
                   std::size_t      number,
                   const Traction  &traction,
                   Eigen::VectorXd &sum) const;

    int n_blocks() const
    {
      return by_block.n_blocks();
    }

    /// See SpringsOfBlocks.
    IndexRange of_block(const int block) const
    {
      return by_block.of_block(block);
    }

    const std::vector<int> &on_foundation() const
    {
      return by_block.on_foundation();
    }

    /// Changes where the springs connect others than before.
    int list_version() const
    {
      return by_block.version();
    }

    using Bodies = SpringBodies;

    bool has_torn_joints() const ///< ends that act as contacts, in part or whole
    {
      return any_torn;
    }

    /// The number of the first contact; joints come before.
    std::size_t first_contact() const
    {
      return 2 * collected.size();
    }

    /// Where a spring is in the block matrix, after connect(): the slot of a pair of blocks twice,
    /// or those of the block with both nodes.
    const std::array<int, 2> &slot(const std::size_t number) const
    {
      return slots[number];
    }

    std::vector<Spring>   springs;
    std::vector<Bodies>   bodies; ///< of each spring
    std::vector<Response> responses;
    std::vector<Forces>   forces;        ///< in the trial; without sense where no traction acts
    std::vector<Forces>   contact_parts; ///< of joints that act as both, in the trial: what their
                                         ///< parts that are contacts bear; likewise without sense

  private:
    /// As what a spring bears in the trial.
    enum class Role : char
    {
      none,
      bond,
      contact,
      both
    };

    struct Bearing
    {
      Role      role      = Role::none;
      Condition condition = Condition::law;
    };

    void collect_joints(const Model &model, const DdaState &state);

    void collect_contacts(const Model &model, const DdaState &state);

    static Spring joint_spring(const Model &model, const DdaState &state, int j, int end);

    Spring contact_spring(const Model &model, const DdaState &state, int c) const;

    /// Set spring number @p s. @return whether it connects others than the one before did.
    bool take(std::size_t s, const Spring &spring);

    /// @return whether the matrix has them all.
    bool find_slots(const BlockMatrix &matrix);

    void add_force_on_foundation(std::size_t s, const Forces &force, Eigen::VectorXd &sum) const;

    void add_forces_on_foundation(Eigen::VectorXd &bonds, Eigen::VectorXd &contacts) const;

    void evaluate_joint(const Model    &model,
                        const DdaState &state,
                        const Trial    &trial,
                        std::size_t     s,
                        Condition       condition = Condition::law);

    void evaluate_contact(const DdaState &state,
                          const Trial    &trial,
                          std::size_t     s,
                          Condition       condition = Condition::law);

    /// The answer of a spring in a condition.
    static JointResponse respond(const Spring          &spring,
                                 Condition              condition,
                                 const JointKinematics &kinematics,
                                 const JointDamping    &damping);

    BondedArea                      bonded_area;      ///< when the step began
    const std::vector<int>         *chosen = nullptr; ///< at work, if not all
    std::vector<int>                narrow_ones;      ///< of narrow()
    std::vector<char>               is_marked;        ///< springs, work
    std::vector<int>                collected;        ///< joints that are springs
    SpringsOfBlocks                 by_block;
    std::vector<Bearing>            bearing; ///< of each spring
    std::vector<std::array<int, 2>> slots;
    bool                            bodies_changed    = true; ///< since the step before
    bool                            any_torn          = false;
    bool                            bonds_fail        = false; ///< some may, in the trial
    int                             connected_pattern = -1; ///< of the matrix, for slots; -1: none
  };
} // namespace hybrid::dda
