// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/clock.h>
#include <hybrid/coupling/base.h>
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/dda/static_stage.h>
#include <hybrid/output/log.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/scene/input_motion.h>
#include <hybrid/scene/scene_parameters.h>
#include <hybrid/scene/section_mesh.h>

#include <memory>
#include <mpi.h>

namespace hybrid
{
  /// How a run ended.
  enum class RunStatus
  {
    finished,
    no_convergence ///< a step failed at the smallest allowed size
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

    /// Run to the end and write everything to the output directory.
    RunStatus run();

  private:
    const scene::SceneParameters          scene;
    output::Log                          &log;
    scene::SectionMesh                    mesh;
    const scene::InputMotion              input;  ///< as given
    scene::Motion                         motion; ///< at an outcrop
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

    void settle();

    void report_static_stage() const;
    void report_planes(const continuum::StaticSlip &planes) const;

    RunStatus advance(Clock                 &clock,
                      coupling::CoupledStep &step,
                      output::RunRecorder   &recorder,
                      output::Summary       &summary);

    void say_why(const dda::StepResult &result, double time) const;
  };
} // namespace hybrid
