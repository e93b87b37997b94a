// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/simulation_run.h>

#include <cstdio>

namespace hybrid
{
  Simulation::Run::Run(Simulation &simulation, const output::HistoryFile::Mode mode)
    : solver(simulation.blocks != nullptr ? std::make_unique<dda::BlockSolver>(*simulation.blocks)
                                          : nullptr)
    , step(solver.get(), simulation.base.get(), simulation.continuum.get())
    , clock(simulation.scene.time.time_step,
            simulation.scene.time.end_time,
            simulation.scene.time.maximum_halvings)
    , recorder({simulation.scene,
                simulation.mesh,
                simulation.motion,
                simulation.input.fit,
                simulation.blocks.get(),
                simulation.continuum.get(),
                simulation.base.get()},
               mode)
    , schedule(simulation.scene.checkpoint)
    , energy(simulation.scene.output.energy_warning, simulation.scene.output.energy_limit)
  {}



  void Simulation::serialize(restart::Archive &archive, Run &run)
  {
    archive(state);
    if (continuum != nullptr)
      continuum->serialize_rest(archive);
    if (run.solver != nullptr)
      archive(*run.solver);
    double        wall_time  = run.wall_time();
    std::uint64_t log_length = log.file_length();
    archive(run.step, run.clock, wall_time, log_length);
    output::Summary &summary                          = run.summary;
    auto &[cuts, retries, moved_too_far, unconverged] = summary.wasted;
    archive(summary.steps, summary.iterations, summary.timings);
    archive(cuts, retries, moved_too_far, unconverged);
    archive(run.recorder, run.energy);
    if (!archive.is_reading())
      return;
    run.earlier_wall_time = wall_time;
    log.resume_file(scene.output.directory + "/log.txt", log_length);
  }



  std::uint64_t Simulation::layout(Run &run)
  {
    restart::Archive archive = restart::Archive::describer();
    serialize(archive, run);
    return restart::checksum(archive.content());
  }



  void Simulation::save(Run &run)
  {
    run.recorder.flush(); // run.h5 is never behind the checkpoint
    restart::Archive archive = restart::Archive::writer();
    archive.put(scene.used_prm);
    archive.put(fingerprint(mesh, motion.outcrop()));
    serialize(archive, run);
    restart::write_checkpoint(checkpoint_file(scene.output.directory),
                              {layout(run), archive.content()});
    run.schedule.written();
  }



  void Simulation::load(const restart::CheckpointContent &checkpoint, Run &run)
  {
    if (checkpoint.layout != layout(run))
      throw InputError("the checkpoint '" + checkpoint_file(scene.output.directory) +
                       "' was written by a program whose state has other parts: resume with that "
                       "program");
    restart::Archive archive = restart::Archive::reader(checkpoint.state);
    std::string      parameters;
    std::uint64_t    number = 0;
    archive(parameters, number);
    serialize(archive, run);
    if (!archive.at_end())
      throw InputError("the checkpoint '" + checkpoint_file(scene.output.directory) +
                       "' is longer than its state");
  }



  void Simulation::warn_of_missing_pictures(const Run &run) const
  {
    const std::vector<std::string> files = run.recorder.missing_pictures();
    if (files.empty())
      return;
    const bool one = files.size() == 1;
    log.warning(std::to_string(files.size()) + (one ? " picture" : " pictures") +
                " of the part before " + (one ? "is" : "are") + " gone from '" +
                scene.output.directory + "'" + (one ? ", " : ", the first is ") + files.front() +
                ": the .pvd files list the others, and all other results go on");
  }



  RunStatus Simulation::resume(const restart::CheckpointContent &checkpoint,
                               const Interruption               &interruption)
  {
    restart::Archive archive = restart::Archive::reader(checkpoint.state);
    std::string      parameters;
    std::uint64_t    number = 0;
    archive(parameters, number);
    check_same_scene(parameters, scene.used_prm);
    if (number != fingerprint(mesh, motion.outcrop()))
      throw InputError("the mesh or the motion is not that of the run in '" +
                       scene.output.directory + "': a file of the scene has changed since");

    Run run(*this, output::HistoryFile::Mode::resume);
    load(checkpoint, run);
    write_parameters(scene);
    std::remove((scene.output.directory + "/summary.json").c_str()); // of the part before
    char text[200];
    std::snprintf(text,
                  sizeof(text),
                  "Resumed from the checkpoint at t = %.6g s, after %ld steps%s",
                  run.clock.time(),
                  run.summary.steps,
                  run.clock.at_end()
                    ? ", the end of the run (a later one: -s \"Time/End time=...\")"
                    : "");
    log.info(text);
    warn_of_missing_pictures(run);
    const RunStatus status = advance(run, interruption);
    return finish(run, status);
  }
} // namespace hybrid
