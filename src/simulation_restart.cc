// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/simulation_run.h>

#include <cstdio>

namespace hybrid
{
  Simulation::Run::Run(Simulation &simulation, const output::HistoryFile::Mode mode)
    : solver(simulation.model.blocks != nullptr
               ? std::make_unique<dda::BlockSolver>(*simulation.model.blocks)
               : nullptr)
    , step(solver.get(), simulation.model.foundation.get(), simulation.model.continuum.get())
    , clock(simulation.model.scene.time.time_step,
            simulation.model.scene.time.end_time,
            simulation.model.scene.time.maximum_halvings)
    , schedule(simulation.model.scene.checkpoint)
    , energy(simulation.model.scene.output.energy_warning,
             simulation.model.scene.output.energy_limit)
    , rest(solver != nullptr ? simulation.model.scene.time.rest_speed : 0.,
           simulation.model.end_of_loads())
  {
    clock.follow(simulation.plan);
    const SceneModel &model = simulation.model;
    if (simulation.is_first())
      recorder.emplace(output::RunParts{model.scene,
                                        model.mesh,
                                        model.motion,
                                        model.input.fit,
                                        model.blocks.get(),
                                        model.continuum.get(),
                                        model.foundation.get()},
                       mode);
    const continuum::Ownership *ownership =
      model.continuum != nullptr ? model.continuum->ownership() : nullptr;
    if (ownership == nullptr)
      return;
    if (!recorder)
      shared_pictures.emplace(*model.continuum);
    if (!model.scene.monitors.has_peak_fields)
      return;
    shared_peaks.emplace(*model.continuum, model.scene.monitors.filter_frequency);
    if (recorder)
      peaks_of_first = &recorder->leave_peaks_of_bedrock();
  }



  void Simulation::Run::add_shared_peaks(std::vector<restart::SharedVector> &vectors)
  {
    if (!shared_peaks)
      return;
    for (restart::SharedVector &vector : shared_peaks->shared_vectors(peaks_of_first))
      vectors.push_back(std::move(vector));
  }



  void Simulation::serialize(restart::Archive &archive, Run &run)
  {
    archive(state);
    if (model.continuum != nullptr)
      model.continuum->serialize_rest(archive);
    if (run.solver != nullptr)
      archive(*run.solver);
    if (!archive.is_reading())
      run.count_processor_time("writing");
    double        wall_time      = run.wall_time();
    double        processor_time = run.processor_time();
    std::uint64_t log_length     = log.file_length();
    archive(run.step, run.clock, wall_time, processor_time, log_length);
    output::Summary &summary                          = run.summary;
    auto &[cuts, retries, moved_too_far, unconverged] = summary.wasted;
    archive(summary.steps, summary.iterations, summary.few_iterations);
    archive(summary.timings, summary.stages);
    archive(cuts, retries, moved_too_far, unconverged);
    output::Summary::StaticStage &stage = summary.static_stage;
    archive(stage.settled, stage.equilibrium, stage.planes_hold, stage.slid);
    archive(stage.residual, stage.iterations, stage.displacement, stage.lifts_moved);
    if (run.recorder)
      archive(*run.recorder, run.energy, run.rest);
    if (!archive.is_reading())
      return;
    run.earlier_wall_time      = wall_time;
    run.earlier_processor_time = processor_time;
    run.counted_processor_time = processor_time;
    run.count_processor_time("preparation"); // of the part that begins
    if (run.recorder)
      log.resume_file(model.scene.output.directory + "/log.txt", log_length);
  }



  std::uint64_t Simulation::layout(Run &run)
  {
    restart::Archive archive = restart::Archive::describer();
    serialize(archive, run);
    return restart::checksum(archive.content());
  }



  void Simulation::save(Run &run)
  {
    run.count_processor_time_of_steps();
    if (!run.recorder && !shares_bedrock())
      return;
    run.schedule.begins();
    if (run.recorder)
      run.recorder->flush(); // run.h5 is never behind the checkpoint
    const auto write = [&](restart::Archive &archive) {
      archive.put(model.scene.used_prm);
      archive.put(fingerprint(model.mesh, model.motion));
      serialize(archive, run);
    };
    const std::string file = checkpoint_file(model.scene.output.directory);
    if (shares_bedrock())
      {
        std::vector<restart::SharedVector> vectors =
          model.continuum->shared_vectors(state.continuum);
        vectors.push_back(model.continuum->shared_rest());
        run.add_shared_peaks(vectors);
        restart::write_shared_checkpoint(file, layout(run), write, vectors, model.processes);
      }
    else
      restart::write_checkpoint(file, layout(run), write);
    run.schedule.written();
    run.count_processor_time("writing");
  }



  void Simulation::load(const restart::CheckpointContent &checkpoint, Run &run)
  {
    if (run.recorder && checkpoint.layout != layout(run))
      throw InputError("the checkpoint '" + checkpoint_file(model.scene.output.directory) +
                       "' was written by a program whose state has other parts: resume with that "
                       "program");
    restart::Archive archive = restart::Archive::reader_of(checkpoint.state);
    std::string      parameters;
    std::uint64_t    number = 0;
    archive(parameters, number);
    std::vector<restart::SharedVector> vectors;
    if (shares_bedrock())
      {
        vectors = model.continuum->shared_vectors(state.continuum);
        vectors.push_back(model.continuum->shared_rest());
        run.add_shared_peaks(vectors);
      }
    restart::SharedReading reading(archive, vectors);
    serialize(archive, run);
    if (run.recorder && !archive.at_end())
      throw InputError("the checkpoint '" + checkpoint_file(model.scene.output.directory) +
                       "' is longer than its state");
    if (shares_bedrock())
      reading.take(checkpoint.state, model.processes);
  }



  RunStatus Simulation::resume(const restart::CheckpointContent &checkpoint,
                               const Interruption               &interruption)
  {
    restart::Archive archive = restart::Archive::reader_of(checkpoint.state);
    std::string      parameters;
    std::uint64_t    number = 0;
    archive(parameters, number);
    check_same_scene(parameters, model.scene.used_prm);
    if (number != fingerprint(model.mesh, model.motion))
      throw InputError("the mesh or the motion is not that of the run in '" +
                       model.scene.output.directory + "': a file of the scene has changed since");

    {
      // how far it has got, before any file is opened; load() reads all
      std::vector<restart::SharedVector> shared;
      if (shares_bedrock())
        shared = model.continuum->shared_vectors(state.continuum);
      const restart::SharedReading reading(archive, shared);
      archive(state);
    }
    const scene::TimeParameters &time = model.scene.time;
    if (time.end_time + time.time_step < state.time) // the end is rounded to whole steps
      throw InputError("Time/End time = " + scene::number_text(time.end_time) +
                       " s lies before the run's " + scene::number_text(state.time) +
                       " s; a run that is resumed cannot end earlier");

    Run run(*this, output::HistoryFile::Mode::resume);
    load(checkpoint, run);
    run_report.resumed(run.clock.time(), run.summary.steps, run.clock.at_end());
    if (run.recorder)
      {
        write_parameters(model.scene);
        std::remove((model.scene.output.directory + "/summary.json").c_str()); // of the part before
        run_report.missing_pictures(run.recorder->missing_pictures());
      }
    const RunStatus status = advance(run, interruption);
    return finish(run, status);
  }
} // namespace hybrid
