// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/error_runs.h>
#include <hybrid/output/end_text.h>
#include <hybrid/output/step_difference.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/voice.h>

#include <iostream>

namespace hybrid
{
  namespace
  {
    /// Nobody looks at what the second run would write besides the histories of its monitors.
    scene::SceneParameters
    scene_of_second_run(const std::string &directory, const double step, const double end)
    {
      return scene::read_scene(parameters_file(directory),
                               {"Time/Time step=" + scene::number_text(step),
                                "Time/End time=" + scene::number_text(end),
                                "Output/Directory=" + second_run_directory(directory),
                                "Output/Picture interval=0",
                                "Monitors/Peak fields=false",
                                "Monitors/Lines=",
                                "Monitors/Lines file=",
                                "Output/Energy warning=0",
                                "Output/Energy limit=0",
                                "Checkpoint/Wall interval=0"});
    }



    /// Compute it. @return its record for the comparison; nothing if it did not come to its end.
    std::optional<output::StepRecord> second_run(const scene::SceneParameters &scene,
                                                 const SimulationMaker        &make,
                                                 const Processes              &processes,
                                                 const Interruption           &interruption)
    {
      std::ostream  nowhere(nullptr);
      output::Log   quiet(nowhere);
      DirectoryLock lock;
      const auto    simulation = make(scene.output.directory, scene, quiet);
      processes.on_first([&] { prepare_directory(scene, true, quiet, lock); });
      if (simulation->run(interruption) != RunStatus::finished)
        return {};
      return simulation->step_record();
    }



    /// The same, where no failure may spoil a run that has finished.
    std::optional<output::StepRecord> second_run_or_reason(const scene::SceneParameters &scene,
                                                           const SimulationMaker        &make,
                                                           const Processes              &processes,
                                                           const Interruption &interruption,
                                                           std::string        &reason)
    {
      if (processes.count() > 1) // one that fails ends all
        return second_run(scene, make, processes, interruption);
      try
        {
          return second_run(scene, make, processes, interruption);
        }
      catch (const std::exception &error)
        {
          reason = error.what();
          return {};
        }
    }
  } // namespace



  RunStatus meet_error_target(std::unique_ptr<Simulation> simulation,
                              const SimulationMaker      &make,
                              const Processes            &processes,
                              DirectoryLock              &lock,
                              const Interruption         &interruption)
  {
    const std::string directory = simulation->directory();
    StepChoice        choice    = simulation->next_step_size();
    for (double step = processes.from_first(choice.step.value_or(0.)); step > 0.;
         step        = processes.from_first(choice.step.value_or(0.)))
      {
               const std::string            size = scene::number_text(step);
               const scene::SceneParameters scene =
                 read_scene_of_run(directory, {"Time/Time step=" + size});
               Voice voice(processes);
               processes.on_first([&] {
          if (simulation->step_record())
            output::write_step_record(step_record_file(directory), *simulation->step_record());
        });
               simulation.reset(); // its memory
               simulation = make(directory, scene, voice.log);
               processes.on_first([&] { prepare_directory(scene, true, voice.log, lock); });
               voice.log.info("Repeated in steps of " + size + " s: " + choice.why);
               simulation->report().card();
               const RunStatus status = simulation->run(interruption);
               if (status != RunStatus::finished)
          return status;
        choice = simulation->next_step_size();
      }
    if (!choice.unmet.empty() && processes.is_first())
      std::cerr << "warning: Time/Error target is not known to be met: " << choice.unmet
                << std::endl;
    return RunStatus::finished;
  }



  void tell_error_by_second_run(std::unique_ptr<Simulation> simulation,
                                const SimulationMaker      &make,
                                const Processes            &processes,
                                output::Log                &log,
                                const Interruption         &interruption)
  {
    const double until = processes.from_first(simulation->end_of_second_run().value_or(0.));
    if (until <= 0.)
      return;
    const std::string                 directory   = simulation->directory();
    const double                      longer_step = 2. * simulation->time_step();
    std::optional<output::StepRecord> shorter     = simulation->step_record();
    output::Summary                   summary     = simulation->summary();
    simulation.reset(); // its memory
    std::string reason;
    const auto  longer = second_run_or_reason(
      scene_of_second_run(directory, longer_step, until), make, processes, interruption, reason);
    processes.on_first([&] {
      forget_second_run(directory);
      if (!longer)
        {
          log.info("The second run did not come to its end" +
                   (reason.empty() ? "" : ": " + reason) +
                   ". The first one is complete, and hybrid accuracy " + directory +
                   " --step tells its error.");
          return;
        }
      output::measure_error(*longer, *shorter, summary.probable_error);
      output::write_summary(summary, directory + "/summary.json");
      const output::EndText text = output::error_text(summary);
      log.info(text.on_screen, text.in_file);
    });
  }
} // namespace hybrid
