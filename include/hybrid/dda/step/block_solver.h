// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_detection.h>
#include <hybrid/dda/failure/belt_parting.h>
#include <hybrid/dda/springs/contact_load.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/dda/step/sleep.h>

namespace hybrid::dda
{
  /**
   * Steps the blocks: contact search at the start of a step, open-close
   * iteration, acceptance. Steps of a mass that sleeps (Sleep) are not computed. The model must
   * outlive the solver.
   */
  class BlockSolver
  {
  public:
    explicit BlockSolver(const Model &block_model);

    /// Solve the step from @p state (whose contact list and awake blocks are brought up to date;
    /// nothing else changes). @p guess: see OpenCloseIteration.
    StepResult solve(DdaState                 &state,
                     const FoundationResponse &foundation,
                     double                    dt,
                     const std::vector<Vec6>  *guess = nullptr);

    /// Let @p watch be asked before every open-close iteration whether to go on.
    void set_watch(OpenCloseIteration::Watch watch)
    {
      iteration.set_watch(std::move(watch));
    }

    /// Make the solved step the new state.
    void accept(DdaState &state);

    /// The last step was not computed, as the mass sleeps.
    bool slept() const
    {
      return is_asleep;
    }

    /// What is kept from one step to the next, for the checkpoint.
    void serialize(restart::Archive &archive);

    /// The solved step: displacement of the foundation nodes [m] and force increments on them
    /// [N/m].
    const OpenCloseIteration &solved_step() const
    {
      return iteration;
    }

    /// What contact search has done and cost since the run began (a run that is resumed builds one
    /// list more).
    struct SearchSummary
    {
      long   steps    = 0;  ///< steps tried
      long   searches = 0;  ///< of them, those in which the search did not sleep
      long   lists    = 0;  ///< lists of near pairs built
      double time     = 0.; ///< wall time [s]
    };

    const SearchSummary &search() const
    {
      return search_summary;
    }

    /// Where the time of all steps so far went.
    PartTimes part_times() const
    {
      PartTimes times = iteration.part_times();
      times.search    = search_summary.time;
      return times;
    }

  private:
    const Model         &model;
    ContactDetection     detection;
    OpenCloseIteration   iteration;
    ContactLoads         loads;
    Sleep                sleep;
    StepResult           solved;            ///< what the last step came to
    double               solved_dt = 0.;    ///< its size [s]
    bool                 is_asleep = false; ///< it was not computed
    bool                 searched  = false; ///< contacts were searched in it
    BondedOutline        mesh_nodes;        ///< of all joints of the mass, as drawn
    BeltParting          belt_parting;
    std::vector<Contact> contacts_before; ///< of the last step, for the loads
    std::vector<char>    is_on_belt;      ///< per block: bonded to a surface
    std::vector<char>    held_off;        ///< per block, see SkippedPairs
    std::vector<char>    is_convex_block; ///< per block
    int changes = -1; ///< yielded, failed and released joints when the skip lists were made
    std::vector<ContactScope> scope;              ///< per block, now
    std::vector<Vec2>         node_displacements; ///< of the foundation in a solved step [m], work

    SearchSummary search_summary;

    std::vector<ContactScope> contact_scopes(const DdaState &state) const;

    /// The blocks of a joint may touch elsewhere, too: one of them is not convex.
    bool touches_beside(const Joint &joint) const;

    /// Sets is_on_belt and held_off.
    void find_blocks_on_surface();

    /// Blocks look at all their neighbours around a node where a joint has yielded: the chain of
    /// joints that held them beside each other (held_neighbours.h) is broken, though their own may
    /// hold.
    void wake_around_nodes(const DdaState &state, std::vector<ContactScope> &scopes) const;

    /// See SkippedPairs.
    BondedOutline bonded_outline(const DdaState &state) const;

    /// @return whether joints have yielded, failed or been released since the last call.
    bool update_skipped_pairs(const DdaState &state);

    /// Whether the solved step takes a vertex into a body that it has no contact with.
    bool is_passed(const DdaState &state);

    /// Bring the contact list of @p state up to date.
    void search_contacts(DdaState &state);
  };
} // namespace hybrid::dda
