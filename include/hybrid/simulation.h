// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/clock.h>
#include <hybrid/coupling/base.h>
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/interruption.h>
#include <hybrid/output/log.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <memory>
#include <mpi.h>

namespace hybrid
{
  /// How a run ended.
  enum class RunStatus
  {
    finished,
    no_convergence, ///< a step failed at the smallest allowed size
    energy_limit,   ///< the energy audit does not close, with a checkpoint
    no_equilibrium, ///< the slope cannot stand, and the scene asks for one that does
    interrupted     ///< by the user, with a checkpoint if the static stage was over
  };


  /**
   * A run: builds what the scene calls for, then the static stage and the time loop.
   *
   * Only here all modules meet. Parts that the scene does not have are never
   * made.
   */
  class Simulation
  {
  public:
    /// Read the mesh and motion and build the model; writes no file. @throws InputError.
    Simulation(const scene::SceneParameters &scene, output::Log &log, MPI_Comm communicator);

    /// Scene card and warnings to the log.
    void print_card() const;

    /// What a run will take of the machine's memory. Only a warning belongs in the log of a run:
    /// the numbers differ a little between equal runs.
    void print_memory(bool warning_only) const;

    /// Run to the end and write everything to the output directory.
    RunStatus run(const Interruption &interruption);

    /// Go on from a checkpoint of the same scene; the results are those of a run that was never
    /// stopped. @throws InputError if the checkpoint is of another scene or program, or finished.
    RunStatus resume(const restart::CheckpointContent &checkpoint,
                     const Interruption               &interruption);

  private:
    struct Run; ///< what changes while the scene runs, besides the state of its parts

    const scene::SceneParameters          scene;
    output::Log                          &log;
    scene::SectionMesh                    mesh;
    const scene::InputMotion              input; ///< as given
    const scene::GroundMotion             motion;
    std::unique_ptr<continuum::Continuum> continuum;
    std::unique_ptr<dda::Model>           blocks;
    std::unique_ptr<coupling::Base>       base;
    dda::StaticResult                     settled;
    coupling::CoupledState                state;

    void make_blocks();

    /// A bedrock of blocks and what it stands on.
    void make_bedrock_blocks();

    /// Every monitor and borehole lies in the model: found before anything is written. @throws
    /// InputError.
    void check_points() const;

    /// The static stage. @return false if the user has ended it.
    bool settle(const Interruption &interruption);

    /// The static stage found no equilibrium, and the scene does not let it go on.
    bool has_failed_to_stand() const;

    /// The initial wave and the initial velocities of blocks, after the static stage.
    void set_in_motion();

    /// Tractions at rest of planes that may slip in a bedrock of blocks.
    void stress_planes();

    void report_static_stage() const;

    /// Of a mass that came to rest elsewhere than where it was drawn.
    void warn_of_fallen_blocks() const;
    void report_planes(const continuum::StaticSlip &planes) const;

    /// The time loop. @return how it ended, after a checkpoint if it was interrupted.
    RunStatus advance(Run &run, const Interruption &interruption);

    /// Last records and the summary. @return the status after the last audit.
    RunStatus finish(Run &run, RunStatus status);

    /// Everything that changes, for the checkpoint; what says whose it is comes before it.
    void serialize(restart::Archive &archive, Run &run);

    void save(Run &run);

    void load(const restart::CheckpointContent &checkpoint, Run &run);

    std::uint64_t layout(Run &run);

    /// Of a run that goes on: somebody has deleted pictures.
    void warn_of_missing_pictures(const Run &run) const;

    /// Say what the last energy audit calls for. @return false if the run has to stop.
    bool watch_energy(Run &run) const;

    /// The same after the last audit of a run that ended with @p status. @return its status now.
    RunStatus judge_energy(Run &run, RunStatus status) const;

    void say_why(const dda::StepResult &result, double time) const;
  };
} // namespace hybrid
