// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/statics/lifts.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/interruption.h>
#include <hybrid/output/mesh_orders.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/output/step_record.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/run_report.h>
#include <hybrid/run_status.h>
#include <hybrid/scene/mesh/reentrant_corner.h>
#include <hybrid/scene_model.h>
#include <hybrid/step_choice.h>
#include <hybrid/step_plan.h>

#include <map>
#include <optional>

namespace hybrid
{
  /**
   * A run: the static stage and the time loop of what a scene calls for (SceneModel). What it
   * says is RunReport's.
   */
  class Simulation
  {
  public:
    /// Read the mesh and motion and build the model; writes no file. @throws InputError.
    Simulation(const scene::SceneParameters &scene, output::Log &log, MPI_Comm communicator);

    /// One process computes the scene.
    bool is_alone() const;

    /// What it says before it runs.
    const RunReport &report() const
    {
      return run_report;
    }

    /// Before it runs: steps are cut as those of another run were.
    void follow(std::vector<StepLevel> cuts)
    {
      plan = std::move(cuts);
    }

    /// Run to the end and write everything to the output directory.
    RunStatus run(const Interruption &interruption);

    /// Go on from a checkpoint of the same scene; the results are those of a run that was never
    /// stopped. @throws InputError if the checkpoint is of another scene or program, or finished.
    RunStatus resume(const restart::CheckpointContent &checkpoint,
                     const Interruption               &interruption);

    /// What Time/Error target calls for after a run that has finished.
    StepChoice next_step_size() const;

    /// Histories of a run that has finished, on the first process, if another run is to tell its
    /// error.
    const std::optional<output::StepRecord> &step_record() const
    {
      return record;
    }

    /// What a run that has finished found, on the first process.
    const output::Summary &summary() const
    {
      return found;
    }

    /// Step of the second run, which tells the error of this one [s] (Time/Error estimate).
    double second_time_step() const;

    /// Up to where the second run has to go [s]; empty: none is called for.
    std::optional<double> end_of_second_run() const;

    /// The same of runs with coarser meshes (Mesh/Error estimate).
    std::optional<double> end_of_coarser_runs() const;

    /// The mesh has numbers to make it coarser by.
    bool has_coarser_mesh() const;

    /// Mesh/Numbers with all Resolution/... so many times as large; empty: there are none.
    std::string coarser_mesh(double factor) const;

    /// Why there are none; empty: there are.
    std::string why_no_coarser_mesh() const;

    /// Parameters by which another run looks at the points that this one watches without monitors.
    std::vector<std::string> watched_points() const;

    /// Inward corners of a bedrock of finite elements, whose cells another run can halve.
    std::vector<scene::ReentrantCorner> corners_of_bedrock() const;

    /// Of cells of such a bedrock, by surfaces of the geometry (thin_layers.h) [m].
    std::map<int, double> cell_thickness() const;

    /// Mesh/Corner levels
    int corner_levels() const
    {
      return model.scene.mesh.corner_levels;
    }

    bool takes_explicit_steps() const
    {
      return model.scene.continuum.is_explicit;
    }

    int n_blocks() const;

    /// Blocks, or without any the unknowns of the bedrock: what a coarser mesh has fewer of.
    double mesh_count() const;

    output::MeshOrders mesh_orders() const;

    bool has_error_target() const
    {
      return model.scene.time.error_target != 0.;
    }

    double time_step() const
    {
      return model.scene.time.time_step;
    }

    const std::string &directory() const
    {
      return model.scene.output.directory;
    }

  private:
    struct Run; ///< what changes while the scene runs, besides the state of its parts

    /// What a step calls for after it; any process may.
    struct Call
    {
      bool energy_limit, interruption, checkpoint, rest = false;
    };

    output::Log                      &log;
    const SceneModel                  model;
    const RunReport                   run_report;
    dda::LiftResult                   lifts;
    dda::StaticResult                 settled;
    continuum::StaticSlip             planes_at_rest;
    coupling::CoupledState            state;
    std::vector<StepLevel>            plan;   ///< of cuts, of another run
    output::Summary                   found;  ///< by the run that has finished
    std::optional<output::StepRecord> record; ///< of it

    /// Of processes that compute together, the one that writes.
    bool is_first() const;

    /// Processes that compute together share the unknowns of the bedrock.
    bool shares_bedrock() const;

    /// What the first process asks for, on it and from all. @return the same on all
    output::RunRecorder::Needs collect(const output::RunRecorder::Needs &of_first);

    /// From the state before the first step on.
    void start_recording(Run &run);

    /// A warning where blocks are deep in each other or in the ground.
    void tell_of_overlap(output::RunRecorder &recorder) const;

    /// Peaks of a bedrock that processes share, at the end.
    void write_shared_peaks(Run &run) const;

    /// The first process records the step.
    void record_step(Run &run, const dda::StepResult &result, double dt, double wall_time);

    /// What the processes call for together. @throws std::runtime_error if they compute blocks
    /// together and have come to different states
    Call agree(const Call &mine) const;

    /// A number that tells states of the blocks apart.
    std::uint64_t fingerprint_of_blocks() const;

    /// What the first one says.
    RunStatus agreed_status(RunStatus of_first) const;

    /// The static stage. @return false if the user has ended it.
    bool settle(const Interruption &interruption);

    /// The static stage found no equilibrium, and the scene does not let it go on.
    bool has_failed_to_stand() const;

    /// The initial wave and the initial velocities of blocks, after the static stage.
    void set_in_motion();

    /// Keep and tell what the planes of the bedrock do at rest.
    void report_planes(const continuum::StaticSlip &rest);

    output::Summary::StaticStage static_summary() const;

    /// Tractions at rest of planes that may slip in a bedrock of blocks.
    void stress_planes();

    /// Stress of a bedrock of finite elements below the mass that has settled.
    void settle_bedrock();

    /// The search for the surface's stiffness, long by conjugate gradients, ends when the user asks
    /// for it; @p interruption lives as long as the steps.
    void watch_search(const Interruption &interruption);

    /// One step; nothing if the user has ended it while the surface's stiffness was found: the
    /// state is that of before.
    std::optional<dda::StepResult> try_step(Run &run, double dt);

    /// The time loop. @return how it ended, after a checkpoint if it was interrupted.
    RunStatus advance(Run &run, const Interruption &interruption);

    /// Up to where the record of a run with this step [s] can be compared with that of another.
    std::optional<double> end_of_further_run(double step) const;

    /// The error from the difference to the run before, which Time/Error target has repeated.
    void measure_step_error(const Run &run, output::Summary &summary);

    /// Last records and the summary. @return the status after the last audit.
    RunStatus finish(Run &run, RunStatus status);

    /// Everything that changes, for the checkpoint; what says whose it is comes before it.
    void serialize(restart::Archive &archive, Run &run);

    void save(Run &run);

    void load(const restart::CheckpointContent &checkpoint, Run &run);

    std::uint64_t layout(Run &run);

    /// Say what the last energy audit calls for. @return false if the run has to stop.
    bool watch_energy(Run &run) const;

    /// The same after the last audit of a run that ended with @p status. @return its status now.
    RunStatus judge_energy(Run &run, RunStatus status) const;
  };
} // namespace hybrid
