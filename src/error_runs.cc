// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/error_runs.h>
#include <hybrid/output/error_text.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/mesh_difference.h>
#include <hybrid/output/step_difference.h>
#include <hybrid/output/told_errors.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/crash_guard.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/corner_cells.h>
#include <hybrid/scene/mesh/thin_layers.h>
#include <hybrid/scene/parameters/corner_levels.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/step_plan.h>
#include <hybrid/voice.h>

#include <cmath>
#include <limits>

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
      return output::formatted("%.6g s", step);
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
      /// @param plan of cuts of its steps
      std::optional<output::StepRecord> run(const std::vector<std::string> &overrides,
                                            const double                    end,
                                            const double                    many,
                                            const double                    most_left,
                                            const std::vector<StepLevel>   &plan = {})
      {
        if (processes.from_first(interruption.is_requested() ? 1. : 0.) != 0.)
          return fail(was_interrupted);
        leave_nothing();           // of the run before
        if (processes.count() > 1) // one that fails ends all
          return compute(scene_with(overrides, end), many, most_left, plan);
        try
          {
            return compute(scene_with(overrides, end), many, most_left, plan);
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

      /// Unknowns or blocks of the last run.
      double count() const
      {
        return count_of_last;
      }

      /// Of the mesh of the last run.
      const std::vector<scene::ReentrantCorner> &corners() const
      {
        return corners_of_last;
      }

      /// Of its cells, by surfaces [m].
      const std::map<int, double> &cell_thickness() const
      {
        return thickness_of_last;
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
      double                         time = 0., count_of_last = 0.;
      bool                           none_failed = true;

      std::vector<scene::ReentrantCorner> corners_of_last;
      std::map<int, double>               thickness_of_last;

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

      std::optional<output::StepRecord> compute(const scene::SceneParameters &scene,
                                                const double                  many,
                                                const double                  most_left,
                                                const std::vector<StepLevel> &plan)
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
        simulation->follow(plan);
        corners_of_last   = simulation->corners_of_bedrock();
        thickness_of_last = simulation->cell_thickness();
        const double left = simulation->mesh_count();
        count_of_last     = left;
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
      double             count; ///< of the mesh's blocks or unknowns
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
        error.reason = runs.why_not();
      else if (other->step > run.record.step)
        output::measure_error(*other, run.record, error);
      else
        output::measure_error_by_shorter_steps(run.record, *other, error);
      error.runs_would_do = error.reason.empty(); // no other follows
      say(output::error_text(run.summary), run, log);
    }



    /// What other meshes are compared with, and made from.
    struct OwnMesh
    {
      double                              count;     ///< of blocks, or without any of the unknowns
      double                              most_left; ///< of them in a mesh twice as coarse
      std::string                         coarser[2];
      std::vector<scene::ReentrantCorner> corners;
      std::map<int, double>               thickness; ///< of cells, by surfaces [m]
      /// Cells at corners smaller, steps as they are; empty: the run's integrator would cut these,
      /// or there are blocks, whose constant strain leaves more.
      std::vector<std::string> smaller_at_corners;

      explicit OwnMesh(const Simulation &run)
        : count(run.mesh_count())
        , most_left(run.n_blocks() > 0 ? most_blocks_left : most_unknowns_left)
        , coarser{run.coarser_mesh(2.), run.coarser_mesh(4.)}
        , corners(run.corners_of_bedrock())
        , thickness(run.cell_thickness())
      {
        const int levels = run.corner_levels() + output::corner_halvings;
        if (!run.takes_explicit_steps() && run.n_blocks() == 0 &&
            levels <= scene::most_corner_levels)
          smaller_at_corners = {"Mesh/Corner levels=" + std::to_string(levels),
                                "Continuum/Time integrator=implicit"};
      }
    };



    struct MeshRuns
    {
      std::vector<output::StepRecord>   coarser;               ///< twice and four times
      double                            time          = 0.;    ///< of the first of them [s]
      double                            count         = 0.;    ///< of its unknowns or blocks
      bool                              keeps_corners = false; ///< their cells are as large in all
      bool                              keeps_layers  = false; ///< some are one cell thick in all
      std::optional<output::StepRecord> smaller_at_corners;
    };



    MeshRuns compute_meshes(const OwnMesh   &mesh,
                            const double     end,
                            FurtherRuns     &runs,
                            const Processes &processes)
    {
      MeshRuns   found;
      auto       corners   = mesh.corners;
      auto       thickness = mesh.thickness;
      double     many      = mesh.count;
      const auto from_all  = [&](const bool of_first) {
        return processes.from_first(of_first ? 1. : 0.) != 0.;
      };
      for (const std::string &numbers : mesh.coarser)
        {
          const auto record = runs.run({"Mesh/Numbers=" + numbers}, end, many, mesh.most_left);
          many *= mesh.most_left;
          if (!from_all(record.has_value()))
            break;
          if (found.coarser.empty())
            {
              found.time  = runs.processor_time();
              found.count = runs.count();
            }
          found.coarser.push_back(record.value_or(output::StepRecord()));
          found.keeps_corners =
            found.keeps_corners || scene::keeps_corner_cells(corners, runs.corners());
          found.keeps_layers =
            found.keeps_layers || scene::keeps_thin_layers(thickness, runs.cell_thickness());
          corners   = runs.corners();
          thickness = runs.cell_thickness();
        }
      found.keeps_layers  = from_all(found.keeps_layers);
      found.keeps_corners = from_all(found.keeps_corners);
      if (found.keeps_corners && !mesh.smaller_at_corners.empty())
        found.smaller_at_corners =
          runs.run(mesh.smaller_at_corners, end, mesh.count, std::numeric_limits<double>::max());
      return found;
    }



    void
    tell_mesh_error(MeshRuns found, const FurtherRuns &runs, FinishedRun &run, output::Log &log)
    {
      for (output::StepRecord &record : found.coarser) // watched points are monitors there
        record.least_motion = run.record.least_motion;
      output::Summary::MeshError &error = run.summary.mesh_error;
      if (found.coarser.empty())
        error.reason = runs.why_not();
      else
        {
          error.coarsened = output::coarsened_part(found.count / run.count, run.mesh_orders);
          output::measure_mesh_error(run.record, found.coarser, run.mesh_orders, error);
        }
      error.keeps_corners = found.keeps_corners;
      error.keeps_layers  = found.keeps_layers;
      if (found.smaller_at_corners && error.reason.empty())
        {
          found.smaller_at_corners->least_motion = run.record.least_motion;
          output::add_corner_error(run.record, *found.smaller_at_corners, error);
        }
      const double own = run.summary.stages["steps"];
      if (found.time > least_time && std::isnan(run.record.until)) // both are whole
        error.cost = own * std::max(1., own / found.time);
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
                              output::Log                &log,
                              DirectoryLock              &lock,
                              const Interruption         &interruption)
  {
    const std::string        directory = simulation->directory();
    std::vector<std::string> said      = log.warnings();
    std::unique_ptr<Voice>   voice; // of the last run, if it is not the first
    StepChoice               choice = simulation->next_step_size();
    const auto wanted = [&] { return processes.from_first(choice.step.value_or(0.)); };
    for (double step = wanted(); step > 0.; step = wanted())
      {
        const scene::SceneParameters scene =
          read_scene_of_run(directory, {"Time/Time step=" + scene::number_text(step)});
        auto next = std::make_unique<Voice>(processes);
        next->log.info("Repeated in steps of " + step_text(step) + ": " + choice.why);
        next->log.be_quiet(said);
        processes.on_first([&] {
          if (simulation->step_record())
            output::write_step_record(step_record_file(directory), *simulation->step_record());
        });
        simulation.reset(); // its memory
        voice      = std::move(next);
        simulation = make(directory, scene, voice->log);
        processes.on_first([&] { prepare_directory(scene, true, voice->log, lock); });
        simulation->report().card();
        said = voice->log.warnings();
        voice->log.speak();
        const RunStatus status = simulation->run(interruption);
        if (status != RunStatus::finished)
          return status;
        choice = simulation->next_step_size();
      }
    if (!choice.unmet.empty())
      (voice ? voice->log : log)
        .warning("Time/Error target is not known to be met: " + choice.unmet);
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
    const OwnMesh     own_mesh(*simulation);
    const auto        watched = simulation->watched_points();
    FinishedRun       run{simulation->directory(),
                    simulation->mesh_orders(),
                    simulation->mesh_count(),
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
        const auto other =
          runs.run({"Time/Time step=" + second_step},
                   end_of_second,
                   own_mesh.count,
                   1.,
                   from_first(step_plan(run.record.time, run.record.step), processes));
        processes.on_first([&] { tell_step_error(other, runs, run, log); });
      }
    if (end_of_coarser > 0.)
      {
        scene::CrashGuard::spoils_nothing(
          "          of the mesh: not told, gmsh crashes on a coarser mesh\nResults   " +
          run.directory +
          " are complete; Mesh/Error estimate = one run leaves this out. The mesh is of ");
        const MeshRuns found = compute_meshes(own_mesh, end_of_coarser, runs, processes);
        scene::CrashGuard::spoils_nothing("");
        processes.on_first([&] { tell_mesh_error(found, runs, run, log); });
      }
    runs.leave_nothing();
    processes.on_first([&] {
      if (runs.came_to_their_ends())
        keep(run);
    });
  }
} // namespace hybrid
