// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/error_runs.h>
#include <hybrid/output/end_text.h>
#include <hybrid/output/mesh_difference.h>
#include <hybrid/output/step_difference.h>
#include <hybrid/output/told_errors.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/voice.h>

#include <cmath>
#include <cstdio>
#include <iostream>

namespace hybrid
{
  namespace
  {
    /// Of the blocks, or without any of the unknowns, in a mesh twice as coarse; a quarter is
    /// ideal.
    constexpr double most_blocks_left = 0.5, most_unknowns_left = 0.65;
    constexpr double least_time = 0.1; ///< of steps, that tells what finer ones take [s]



    const std::string was_interrupted =
      "the further run did not come to its end, --resume begins it anew";



    /// Of a time step: 0.0005 s.
    std::string step_text(const double step)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.6g s", step);
      return text;
    }



    /// The scene of a finished run, computed once more with other parameters.
    class FurtherRuns
    {
    public:
      /// @param of_all parameters of all runs
      FurtherRuns(std::string              run_directory,
                  std::vector<std::string> of_all,
                  const SimulationMaker   &maker,
                  const Processes         &all_processes,
                  const Interruption      &user)
        : directory(std::move(run_directory))
        , watched(std::move(of_all))
        , make(maker)
        , processes(all_processes)
        , interruption(user)
      {}

      /// Up to a time @p end [s]. @return its record on the first process; nothing if it did not
      /// come to its end, or its mesh keeps more than @p most_left of so many blocks or unknowns:
      /// why_not() then says why.
      std::optional<output::StepRecord> run(const std::vector<std::string> &overrides,
                                            const double                    end,
                                            const double                    many,
                                            const double                    most_left)
      {
        if (processes.from_first(interruption.is_requested() ? 1. : 0.) != 0.)
          return fail(was_interrupted);
        if (processes.count() > 1) // one that fails ends all
          return compute(scene_with(overrides, end), many, most_left);
        try
          {
            return compute(scene_with(overrides, end), many, most_left);
          }
        catch (const std::exception &error) // no failure may spoil a run that has finished
          {
            return fail(std::string("the further run failed: ") + error.what());
          }
      }

      const std::string &why_not() const
      {
        return reason;
      }

      /// None was interrupted or failed.
      bool came_to_their_ends() const
      {
        return none_failed;
      }

      /// Of the last run [s].
      double processor_time() const
      {
        return time;
      }

      void leave_nothing() const
      {
        processes.on_first([&] { forget_further_runs(directory); });
      }

    private:
      const std::string              directory;
      const std::vector<std::string> watched;
      const SimulationMaker         &make;
      const Processes               &processes;
      const Interruption            &interruption;
      std::string                    reason;
      double                         time        = 0.;
      bool                           none_failed = true;

      std::optional<output::StepRecord> fail(const std::string &why)
      {
        reason      = why;
        none_failed = false;
        return {};
      }

      /// Nobody looks at what it would write besides the histories of its monitors.
      scene::SceneParameters scene_with(std::vector<std::string> overrides, const double end) const
      {
        for (const char *quiet : {"Output/Picture interval=0",
                                  "Monitors/Peak fields=false",
                                  "Monitors/Lines=",
                                  "Monitors/Lines file=",
                                  "Output/Energy warning=0",
                                  "Output/Energy limit=0",
                                  "Checkpoint/Wall interval=0",
                                  "Checkpoint/Step interval=0"})
          overrides.emplace_back(quiet);
        overrides.insert(overrides.end(), watched.begin(), watched.end());
        overrides.push_back("Time/End time=" + scene::number_text(end));
        overrides.push_back("Output/Directory=" + further_run_directory(directory));
        return scene::read_scene(parameters_file(directory), overrides);
      }

      std::optional<output::StepRecord>
      compute(const scene::SceneParameters &scene, const double many, const double most_left)
      {
        std::ostream                nowhere(nullptr);
        output::Log                 quiet(nowhere);
        DirectoryLock               lock;
        std::unique_ptr<Simulation> simulation;
        try
          {
            simulation = make(directory, scene, quiet);
          }
        catch (const InputError &error) // a mesh that cannot be made is so on all processes
          {
            return fail(std::string("the further run failed: ") + error.what());
          }
        const double left = simulation->mesh_count();
        if (left > most_left * many)
          {
            reason = "the next mesh is hardly coarser, it keeps " +
                     std::to_string(std::lround(left)) + " of " +
                     std::to_string(std::lround(many)) +
                     (simulation->n_blocks() > 0 ? " blocks" : " unknowns");
            return {};
          }
        processes.on_first([&] { prepare_directory(scene, true, quiet, lock); });
        if (simulation->is_alone() && !processes.is_first())
          return {}; // too small to be shared out, as the run itself was
        const RunStatus status = simulation->run(interruption);
        if (status != RunStatus::finished)
          return fail(status == RunStatus::interrupted ? was_interrupted
                                                       : "the further run did not come to its end");
        const auto of_steps = simulation->summary().stages.find("steps");
        time = of_steps == simulation->summary().stages.end() ? 0. : of_steps->second;
        return simulation->step_record();
      }
    };



    /// What a finished run leaves for the comparison; on the first process.
    struct FinishedRun
    {
      std::string        directory;
      output::MeshOrders mesh_orders;
      output::StepRecord record;
      output::Summary    summary;

      output::ToldErrors::Asked asked; ///< of further runs
    };



    void say(const output::EndText &text, const FinishedRun &run, output::Log &log)
    {
      output::write_summary(run.summary, run.directory + "/summary.json");
      log.info(text.on_screen, text.in_file);
    }



    void tell_step_error(const std::optional<output::StepRecord> &other,
                         const FurtherRuns                       &runs,
                         FinishedRun                             &run,
                         output::Log                             &log)
    {
      output::Summary::ProbableError &error = run.summary.probable_error;
      if (!other)
        {
          error.reason        = runs.why_not();
          error.runs_would_do = false;
        }
      else if (other->step > run.record.step)
        output::measure_error(*other, run.record, error);
      else
        output::measure_error_by_shorter_steps(run.record, *other, error);
      say(output::error_text(run.summary), run, log);
    }



    void tell_mesh_error(std::vector<output::StepRecord> coarser,
                         const FurtherRuns              &runs,
                         const double                    time_of_coarser,
                         FinishedRun                    &run,
                         output::Log                    &log)
    {
      for (output::StepRecord &record : coarser) // watched points are monitors there
        record.least_motion = run.record.least_motion;
      output::Summary::MeshError &error = run.summary.mesh_error;
      if (coarser.empty())
        error.reason = runs.why_not();
      else
        output::measure_mesh_error(run.record, coarser, run.mesh_orders, error);
      const double own = run.summary.stages["steps"];
      if (time_of_coarser > least_time && std::isnan(run.record.until)) // both are whole
        error.cost = own * std::max(1., own / time_of_coarser);
      say(output::mesh_error_text(error), run, log);
    }



    /// A run that is resumed after its end: what further runs have told. @return false: nothing.
    bool tell_again(FinishedRun &run, output::Log &log)
    {
      const auto told = output::read_told_errors(told_errors_file(run.directory));
      if (!told || !(told->asked == run.asked))
        return false;
      run.summary.probable_error = told->step;
      run.summary.mesh_error     = told->mesh;
      if (run.asked.second_step > 0.)
        say(output::error_text(run.summary), run, log);
      if (run.asked.of_mesh)
        say(output::mesh_error_text(run.summary.mesh_error), run, log);
      return true;
    }



    /// For the run that is resumed after its end.
    void keep(const FinishedRun &run)
    {
      output::write_told_errors(told_errors_file(run.directory),
                                {run.asked, run.summary.probable_error, run.summary.mesh_error});
    }
  } // namespace



  RunStatus meet_error_target(std::unique_ptr<Simulation> simulation,
                              const SimulationMaker      &make,
                              const Processes            &processes,
                              const output::Log          &log,
                              DirectoryLock              &lock,
                              const Interruption         &interruption)
  {
    const std::string        directory = simulation->directory();
    std::vector<std::string> said      = log.warnings();
    StepChoice               choice    = simulation->next_step_size();
    const auto wanted = [&] { return processes.from_first(choice.step.value_or(0.)); };
    for (double step = wanted(); step > 0.; step = wanted())
      {
        const scene::SceneParameters scene =
          read_scene_of_run(directory, {"Time/Time step=" + scene::number_text(step)});
        Voice voice(processes);
        voice.log.info("Repeated in steps of " + step_text(step) + ": " + choice.why);
        voice.log.be_quiet(said);
        processes.on_first([&] {
          if (simulation->step_record())
            output::write_step_record(step_record_file(directory), *simulation->step_record());
        });
        simulation.reset(); // its memory
        simulation = make(directory, scene, voice.log);
        processes.on_first([&] { prepare_directory(scene, true, voice.log, lock); });
        simulation->report().card();
        said = voice.log.warnings();
        voice.log.speak();
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



  void tell_errors_by_further_runs(std::unique_ptr<Simulation> simulation,
                                   const SimulationMaker      &make,
                                   const Processes            &processes,
                                   output::Log                &log,
                                   const Interruption         &interruption)
  {
    const double end_of_second = processes.from_first(simulation->end_of_second_run().value_or(0.)),
                 end_of_coarser =
                   processes.from_first(simulation->end_of_coarser_runs().value_or(0.));
    if (end_of_second <= 0. && end_of_coarser <= 0.)
      return;
    const std::string second_step = scene::number_text(simulation->second_time_step());
    const std::string meshes[]    = {simulation->coarser_mesh(2.), simulation->coarser_mesh(4.)};
    const double      count       = simulation->mesh_count();
    const auto        watched     = simulation->watched_points();
    const bool        has_blocks  = simulation->n_blocks() > 0;
    const double      most_left   = has_blocks ? most_blocks_left : most_unknowns_left;
    FinishedRun       run{simulation->directory(),
                    simulation->mesh_orders(),
                    simulation->step_record().value_or(output::StepRecord()),
                    simulation->summary(),
                    {}};
    run.asked = {run.summary.steps,
                 run.summary.simulated_time,
                 end_of_second > 0. ? simulation->second_time_step() : 0.,
                 end_of_coarser > 0.};
    simulation.reset(); // its memory
    bool is_told = false;
    processes.on_first([&] { is_told = tell_again(run, log); });
    if (processes.from_first(is_told ? 1. : 0.) != 0.)
      return;
    FurtherRuns runs(run.directory, watched, make, processes, interruption);
    if (end_of_second > 0.)
      {
        const auto other = runs.run({"Time/Time step=" + second_step}, end_of_second, count, 1.);
        processes.on_first([&] { tell_step_error(other, runs, run, log); });
      }
    if (end_of_coarser > 0.)
      {
        std::vector<output::StepRecord> coarser;
        double                          many = count, time = 0.;
        for (const std::string &numbers : meshes)
          {
            const auto record =
              runs.run({"Mesh/Numbers=" + numbers}, end_of_coarser, many, most_left);
            many *= most_left;
            if (processes.from_first(record ? 1. : 0.) == 0.)
              break;
            if (coarser.empty())
              time = runs.processor_time();
            coarser.push_back(record.value_or(output::StepRecord()));
          }
        processes.on_first([&] { tell_mesh_error(coarser, runs, time, run, log); });
      }
    runs.leave_nothing();
    processes.on_first([&] {
      if (runs.came_to_their_ends())
        keep(run);
    });
  }
} // namespace hybrid
