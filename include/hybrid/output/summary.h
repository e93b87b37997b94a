// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/overlap.h>

#include <array>
#include <limits>
#include <map>
#include <string>

namespace hybrid::output
{
  /// What one monitor saw, as [x, y]. Displacement is relative to the base monitor if there is one.
  struct MonitorSummary
  {
    using Pair                      = std::array<double, 2>;
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    Pair peak_displacement = {
      {unknown, unknown}}; ///< signed value of largest magnitude [m], filtered
    Pair peak_velocity      = {{unknown, unknown}}; ///< the same [m/s]
    Pair peak_acceleration  = {{unknown, unknown}}; ///< the same [m/s2]
    Pair final_displacement = {{unknown, unknown}}; ///< at the end, not filtered [m]
    Pair amplification      = {{unknown, unknown}}; ///< |peak acceleration| / outcrop peak [-]
    Pair amplification_until_first_failure = {
      {unknown, unknown}}; ///< the same up to the first failed joint
  };


  /**
   * The figures of a run, written to summary.json (names and units there as in the members'
   * comments). Values that are NaN or infinite become null.
   */
  struct Summary
  {
    /// Joints that failed, by how.
    struct FailedJoints
    {
      long tensile = 0;
      long shear   = 0;
    };

    /// On the sliding surface since the state at rest, downhill positive [m]; NaN: nothing stands
    /// on it. Of largest magnitude during the run, and what is left at its end.
    struct Slip
    {
      double               mean         = MonitorSummary::unknown; ///< of all soles
      double               largest      = MonitorSummary::unknown; ///< of one sole
      MonitorSummary::Pair where        = {{MonitorSummary::unknown, MonitorSummary::unknown}};
      double               mean_left    = MonitorSummary::unknown;
      double               largest_left = MonitorSummary::unknown;

      double part      = MonitorSummary::unknown; ///< of the length that slid beyond threshold [-]
      double threshold = MonitorSummary::unknown;

      std::string downhill    = ""; ///< "+x", "-x", "level", or "both ways": slides face each other
      int         off_surface = 0; ///< blocks that lay on it and touch it no more; their ways count
    };

    /// What a bedding plane, or a joint line of the mass, has slipped for good since the state at
    /// rest, of the upper side along +x, at the end [m]: where its size is largest.
    struct PlaneSlip
    {
      double               largest_left = 0.;
      MonitorSummary::Pair where        = {{MonitorSummary::unknown, MonitorSummary::unknown}};
      double               opening_left = 0.; ///< largest [m]
    };

    /// Force of the mass on what it stands on; NaN: nothing stands on it. Mobilised is the shear
    /// over the shear strength, downhill positive; on level ground its size [-].
    struct BaseShear
    {
      double shear             = MonitorSummary::unknown; ///< of largest size, downhill + [N/m]
      double shear_left        = MonitorSummary::unknown; ///< at the end [N/m]
      double normal_left       = MonitorSummary::unknown; ///< likewise, compression positive [N/m]
      double mobilised_at_rest = MonitorSummary::unknown; ///< before the motion; NaN: held
      double mobilised         = MonitorSummary::unknown; ///< largest downhill during the run
      double mobilised_left    = MonitorSummary::unknown; ///< at the end
    };

    /// How the mass came to rest, or without one the planes of the bedrock.
    struct StaticStage
    {
      bool   settled      = false; ///< there was one: blocks or planes that may slip bear weight
      bool   equilibrium  = false; ///< of the blocks, where they were drawn; else of the planes
      bool   planes_hold  = true;  ///< the bedding planes of the bedrock carry their load
      bool   slid         = false; ///< loose blocks came to rest farther than elasticity explains
      double residual     = 0.;    ///< [-]
      int    iterations   = 0;
      double displacement = 0.; ///< largest, of a block [m]
      double lifts_moved  = 0.; ///< largest, of a block since its lift was placed [m]; 0: no lifts
    };

    /// Of blocks with each other or with the ground, in the pictures of a run.
    struct DeepestOverlap
    {
      dda::Overlap of;
      double       time = 0.; ///< when it was seen [s]
    };

    /// Work of the dynamic stage that came to nothing: steps that were rolled back.
    struct Wasted
    {
      long cuts          = 0; ///< steps rolled back and halved
      long retries       = 0; ///< steps tried again: the cuts, but for one at the smallest step
      long moved_too_far = 0; ///< of the cuts: settled, displacement above the allowed ratio
      long iterations    = 0; ///< open-close iterations of the others, which did not settle
    };

    /// What contact search did in the dynamic stage.
    struct ContactSearch
    {
      long steps    = 0; ///< steps tried
      long searches = 0; ///< of them, those in which the search did not sleep
      long lists    = 0; ///< lists of near pairs built
    };

    /// Largest error of the displacement relative to the base, of the velocity and of the
    /// acceleration at any time, over the peak of the same monitor.
    struct ErrorPart
    {
      std::array<double, 3> part = {
        {MonitorSummary::unknown, MonitorSummary::unknown, MonitorSummary::unknown}}; ///< [-]
      std::array<std::string, 3> where;           ///< the monitor whose is largest
      double slip_left = MonitorSummary::unknown; ///< of the mean slip that is left, over it [-]
    };

    /// What finer steps would change, as far as it is estimated.
    struct ProbableError
    {
      std::string watched; ///< what was watched, as there are no monitors; empty: these were
      std::string reason        = "no step was taken"; ///< why it is not estimated; empty: it is
      bool        runs_would_do = false; ///< it is not, but the difference to another run tells it
      bool        may_flutter   = false; ///< blocks do in yet finer steps: it may be larger
      bool        blocks_strike = false; ///< each other: runs in other steps may go another way
      double      second_step   = 0.;    ///< of such a run, which follows [s]; 0: none does
      /// That the difference of two runs is taken to have, where no third one tells it: 2^p - 1 is
      /// sqrt(3), in the middle between 1 (first order) and 3 (second).
      double assumed_order = 1.45;
      double measured_from = MonitorSummary::unknown; ///< told by a run in steps of this [s]; NaN:
                                                      ///< estimated from this run
      double until           = MonitorSummary::unknown; ///< estimated up to here [s]; NaN: all
      bool   failed_in_other = false; ///< the joint that failed then did so in the other run
      double until_later     = MonitorSummary::unknown; ///< one failed in both runs by here [s];
                                                        ///< NaN: in one of them none did
      ErrorPart   step;                                 ///< of the time step
      ErrorPart   half_step;   ///< what would be left of it with half the step, by order
      std::string peak_at_end; ///< monitor whose acceleration peaks near an end of the record,
                               ///< where it is not compared (filter_reach.h); empty: none
      int       parts = 1;     ///< into which an explicit step is divided
      ErrorPart mesh;          ///< of the finite elements, at monitors in them; NaN: none are
      bool      mesh_has_corners = false;       ///< or bends: what these leave is not in it
      double    cost = MonitorSummary::unknown; ///< of half the step: processor time that comes on
                                                ///< top, at most [s]

      /// What half the step leaves: as much where blocks strike, as it goes another way.
      const ErrorPart &left_by_half() const
      {
        return blocks_strike ? step : half_step;
      }
    };

    /// What a finer mesh of the blocks would change, told by coarser ones.
    struct MeshError
    {
      bool        runs_would_do = false; ///< coarser meshes, which there are
      bool        follows       = false; ///< the runs that tell it
      std::string never;                 ///< why no coarser mesh tells it; empty: there are some
      std::string reason          = "no coarser run"; ///< why it is not known; empty: it is
      int         meshes          = 0; ///< coarser ones, twice and four times as coarse
      double      until           = MonitorSummary::unknown; ///< estimated up to here [s]; NaN: all
      bool        failed_in_other = false; ///< the joint that failed then did so in a coarser one
      bool        order_is_seen = false; ///< in three meshes; if not, half the size is told roughly
      double      coarsened = 1.; ///< part of the cells that are larger in the first of them [-]
      bool        keeps_corners = false; ///< cells at inward corners are as large in all of them
      bool        keeps_layers  = false; ///< of a layer cells are as thick in coarser ones
      bool        of_corners    = false; ///< a run with smaller cells at corners tells it, too
      bool        with_step     = false; ///< half the size wants half the step: fourth order, whose
                                         ///< steps are less exact on finer cells
      ErrorPart size;
      ErrorPart half_size;                      ///< what would be left with half the size
      double    cost = MonitorSummary::unknown; ///< processor time with half the size, at least [s]
    };

    std::string title;
    bool        finished           = false;
    long        steps              = 0;  ///< accepted
    double      simulated_time     = 0.; ///< [s]
    double      wall_time          = 0.; ///< [s]
    double      processor_time     = 0.; ///< of all threads, with the start of the program [s]
    double      peak_memory        = 0.; ///< resident, of this process [MB]
    long        blocks             = 0;
    long        continuum_unknowns = 0;
    long        interface_unknowns = 0;
    double      resolved_frequency =
      MonitorSummary::unknown; ///< of the part that resolves least [Hz]; NaN: waves run in none
    std::map<std::string, double> resolved_by_part;      ///< by name of the part [Hz]
    double                        motion_frequency = 0.; ///< 95 % of the energy of what shakes lie
                                                         ///< below [Hz]; 0: nothing shakes
    double         energy_residual = 0.; ///< |sum of all terms| / largest exchanged energy [-]
    FailedJoints   joints;               ///< in the dynamic stage: earthquake damage
    DeepestOverlap deepest_overlap;      ///< of blocks with each other or the ground
    int            blocks_off_base = 0;  ///< beyond the end of the base, nothing is below them
    FailedJoints   static_joints;        ///< while the body settled under gravity
    StaticStage    static_stage;
    Slip           slip;
    BaseShear      base_shear;
    std::map<std::string, PlaneSlip> planes;      ///< bedding planes that may slip, by name
    std::map<std::string, PlaneSlip> joint_lines; ///< lines joint_<suffix> of the mass, by name
    double        first_failure_time = MonitorSummary::unknown; ///< of the dynamic stage [s]
    double        first_loss_time    = MonitorSummary::unknown; ///< of a joint that loses strength
    Wasted        wasted;
    long          iterations     = 0; ///< open-close iterations, all steps
    long          few_iterations = 0; ///< beside these, of few bodies that settle alone
    ContactSearch contact_search;
    double        filter_frequency = 0.; ///< low-pass behind peaks and amplification [Hz]; 0: none
    std::array<double, 2> outcrop_peak_acceleration = {
      {MonitorSummary::unknown,
       MonitorSummary::unknown}}; ///< amplification refers to it [m/s2], filtered

    ProbableError probable_error;
    MeshError     mesh_error;

    std::map<std::string, MonitorSummary> monitors; ///< by name
    std::map<std::string, double>         timings;  ///< wall time per effect [s]
    std::map<std::string, double>         stages;   ///< processor time of the parts of a run [s]
    std::map<std::string, double>         energy;   ///< terms at the end [J/m]
  };

  /// The text of summary.json.
  std::string to_json(const Summary &summary);

  /// Replace @p file_name by the summary (atomically: a reader never sees half a file).
  void write_summary(const Summary &summary, const std::string &file_name);
} // namespace hybrid::output
