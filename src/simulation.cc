// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/stopped.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/resolution.h>
#include <hybrid/output/step_difference.h>
#include <hybrid/restart/archive.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/simulation_run.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <sys/resource.h>

namespace hybrid
{
  namespace
  {
    constexpr double least_steps_to_compare = 20.;



    /// Largest resident memory so far [MB].
    double peak_memory()
    {
      rusage usage;
      return getrusage(RUSAGE_SELF, &usage) == 0 ? usage.ru_maxrss / 1024. : 0.;
    }



    void summarize(const output::Resolutions &resolutions, output::Summary &summary)
    {
      summary.resolved_frequency = resolutions.lowest();
      for (const output::Resolution &part : resolutions.parts)
        summary.resolved_by_part[output::name(part.part)] = part.resolved;
      summary.motion_frequency = resolutions.wanted;
    }



    /// Parts of steps of blocks, by name.
    void add_parts(const dda::PartTimes          &times,
                   const std::string             &prefix,
                   std::map<std::string, double> &timings)
    {
      timings[prefix + "contact_search"]   = times.search;
      timings[prefix + "springs"]          = times.springs;
      timings[prefix + "assembly"]         = times.assembly;
      timings[prefix + "factors"]          = times.factors;
      timings[prefix + "products"]         = times.products;
      timings[prefix + "surface_products"] = times.surface_products;
    }



    double seconds(const timeval &time)
    {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  } // namespace



  double Simulation::Run::processor_time() const
  {
    rusage usage;
    if (getrusage(RUSAGE_SELF, &usage) != 0)
      return earlier_processor_time;
    return earlier_processor_time + seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }



  void Simulation::Run::count_processor_time(const std::string &name)
  {
    const double now = processor_time();
    summary.stages[name] += now - counted_processor_time;
    counted_processor_time = now;
  }



  void Simulation::Run::end_steps()
  {
    summary.timings["continuum"] = step.timings().continuum;
    summary.timings["blocks"]    = step.timings().blocks;
    if (solver == nullptr)
      return;
    add_parts(solver->part_times(), "", summary.timings);
    const dda::BlockSolver::SearchSummary &search = solver->search();
    summary.contact_search                        = {search.steps, search.searches, search.lists};
    solver.reset();
  }



  Simulation::Simulation(const scene::SceneParameters &scene,
                         output::Log                  &run_log,
                         MPI_Comm                      communicator)
    : log(run_log)
    , model(scene, log, communicator)
    , run_report(model, log)
    , state(model.initial_state())
  {}



  bool Simulation::is_first() const
  {
    int rank = 0;
    MPI_Comm_rank(model.processes, &rank);
    return rank == 0;
  }



  bool Simulation::is_alone() const
  {
    int size = 1;
    MPI_Comm_size(model.processes, &size);
    return size == 1;
  }



  Simulation::Call Simulation::agree(const Call &mine) const
  {
    if (is_alone())
      return mine;
    const std::uint64_t blocks   = fingerprint_of_blocks();
    std::uint64_t       calls[6] = {
            mine.energy_limit, mine.interruption, mine.checkpoint, mine.rest, blocks, ~blocks};
    MPI_Allreduce(MPI_IN_PLACE, calls, 6, MPI_UINT64_T, MPI_MAX, model.processes);
    if (calls[4] != ~calls[5])
      throw std::runtime_error(
        "the processes have come to different results at t = " + scene::number_text(state.time) +
        " s: several processes compute blocks on machines of one kind only");
    return {calls[0] != 0, calls[1] != 0, calls[2] != 0, calls[3] != 0};
  }



  std::uint64_t Simulation::fingerprint_of_blocks() const
  {
    // Not the energy: all have the same sums of what each has found. Any bit that differs changes
    // the hash, but for chance (the multiplier is that of splitmix64, Steele, Lea & Flood 2014).
    std::uint64_t hash = 0;
    for (const dda::BlockState &block : state.blocks.blocks)
      for (const double v : block.velocity)
        {
          std::uint64_t bits;
          std::memcpy(&bits, &v, sizeof(bits));
          hash = (hash ^ bits) * 0xbf58476d1ce4e5b9u;
          hash ^= hash >> 29;
        }
    return hash;
  }



  RunStatus Simulation::agreed_status(const RunStatus of_first) const
  {
    int status = static_cast<int>(of_first);
    if (!is_alone())
      MPI_Bcast(&status, 1, MPI_INT, 0, model.processes);
    return static_cast<RunStatus>(status);
  }



  void Simulation::set_in_motion()
  {
    if (model.continuum != nullptr)
      model.continuum->start_wave(state.continuum);
    if (model.blocks != nullptr)
      dda::set_in_motion(*model.blocks, state.blocks);
  }



  RunStatus Simulation::run(const Interruption &interruption)
  {
    Run        run(*this, output::HistoryFile::Mode::create);
    const auto start = SteadyClock::now();
    run.count_processor_time("preparation");
    if (!settle(interruption))
      {
        log.info("Interrupted in the static stage: there are no results and no checkpoint yet; to "
                 "begin anew: " +
                 resume_command(model.scene.output.directory));
        return RunStatus::interrupted;
      }
    run.summary.timings["static_stage"] = seconds_since(start);
    run.summary.static_stage            = static_summary();
    run.count_processor_time("static_stage");
    if (settled.steps > 0)
      add_parts(settled.times, "static_", run.summary.timings);
    if (has_failed_to_stand())
      {
        start_recording(run);
        finish(run, RunStatus::no_equilibrium);
        return RunStatus::no_equilibrium;
      }
    set_in_motion();
    start_recording(run);
    if (model.scene.checkpoint.is_on())
      save(run);
    else if (run.recorder)
      run.recorder->flush();
    run.count_processor_time("writing");
    const RunStatus status = advance(run, interruption);
    return finish(run, status);
  }



  void Simulation::watch_search(const Interruption &interruption)
  {
    if (model.continuum != nullptr)
      model.continuum->watch_search([this, &interruption]() {
        return !agree({false, interruption.is_requested(), false}).interruption;
      });
  }



  std::optional<dda::StepResult> Simulation::try_step(Run &run, const double dt)
  {
    try
      {
        return run.step.solve(state, dt);
      }
    catch (const continuum::Stopped &)
      {
        return {};
      }
  }



  RunStatus Simulation::advance(Run &run, const Interruption &interruption)
  {
    output::Summary &summary     = run.summary;
    double          &output_time = summary.timings["output"];
    std::ostream     screen(is_first() ? std::cout.rdbuf() : nullptr);
    output::Progress progress(screen,
                              is_first() && output::standard_output_is_terminal(),
                              run.clock.time(),
                              model.scene.time.end_time);
    watch_search(interruption);
    const long first_step = summary.steps, first_iteration = summary.iterations;
    RunStatus  status = RunStatus::finished;
    bool       rests = false, ends_search = false;
    while (!run.clock.at_end() && !rests && status == RunStatus::finished)
      {
        const auto   begin = SteadyClock::now();
        const double dt    = run.clock.next_step();
        const auto   tried = try_step(run, dt);
        ends_search        = !tried;
        if (ends_search)
          break;
        const dda::StepResult &result = *tried;
        summary.iterations += result.iterations;
        summary.few_iterations += result.few_iterations;
        if (!result.converged)
          {
            const bool too_far = result.is_passed || result.displacement_ratio >
                                                       model.scene.time.maximum_displacement_ratio;
            summary.wasted.moved_too_far += too_far ? 1 : 0;
            summary.wasted.iterations += too_far ? 0 : result.iterations;
            if (run.clock.shorten_step())
              {
                ++summary.wasted.retries;
                continue;
              }
            progress.finish();
            run_report.no_convergence(result, run.clock.time());
            status = RunStatus::no_convergence;
            break;
          }
        run.clock.accept();
        state.set_time(run.clock.time());
        ++summary.steps;

        const auto accepted = SteadyClock::now();
        record_step(run, result, dt, std::chrono::duration<double>(accepted - begin).count());
        progress.update(state.time,
                        summary.steps - first_step,
                        summary.iterations - first_iteration);
        output_time += seconds_since(accepted);
        if (summary.steps == 1)
          run.count_processor_time("first_step");
        if (run.rest.is_on())
          run.rest.look(run.clock.time(), dda::fastest_block(state.blocks));
        const Call call = agree({!watch_energy(run),
                                 interruption.is_requested(),
                                 is_first() && run.schedule.is_due(summary.steps),
                                 is_first() && run.rest.is_at_rest()});
        rests           = call.rest;
        if (call.energy_limit)
          status = RunStatus::energy_limit;
        else if (call.interruption)
          status = RunStatus::interrupted;
        else if (call.checkpoint)
          save(run);
      }
    if (ends_search)
      status = RunStatus::interrupted;
    run.count_processor_time_of_steps();
    if (status != RunStatus::no_convergence)
      progress.finish();
    if (rests)
      run_report.at_rest(run.clock.time());
    if (status == RunStatus::interrupted || status == RunStatus::energy_limit ||
        model.scene.checkpoint.is_on())
      save(run);
    if (ends_search)
      run_report.search_stopped(run.clock.time(), run.clock.next_step());
    return status;
  }



  StepChoice Simulation::next_step_size() const
  {
    constexpr double             percent = 0.01;
    const scene::TimeParameters &time    = model.scene.time;
    if (time.error_target == 0.)
      return {};
    return choose_step(found.probable_error, time.time_step, percent * time.error_target);
  }



  std::optional<double> Simulation::end_of_further_run(const double step) const
  {
    constexpr double filter_periods = 3.;
    if (!record || !found.finished || has_error_target())
      return {};
    const double corner = model.scene.monitors.filter_frequency; // it looks ahead
    const double ahead  = corner > 0. ? filter_periods / corner : step;
    const double end    = std::fmin(record->until, found.simulated_time);
    return end >= least_steps_to_compare * step
             ? std::optional(std::min(end + ahead, found.simulated_time))
             : std::nullopt;
  }



  double Simulation::second_time_step() const
  {
    const bool is_half = model.scene.time.second_run == scene::SecondRun::half_step;
    return (is_half ? 0.5 : 2.) * time_step();
  }



  std::optional<double> Simulation::end_of_second_run() const
  {
    const bool is_explicit = model.scene.continuum.is_explicit; // its parts may stay as they are
    if (model.scene.time.second_run == scene::SecondRun::none ||
        !found.probable_error.runs_would_do || is_explicit)
      return {};
    return end_of_further_run(std::max(time_step(), second_time_step()));
  }



  std::optional<double> Simulation::end_of_coarser_runs() const
  {
    if (!model.scene.mesh.coarser_runs || !record || record->monitors.empty() ||
        !has_coarser_mesh())
      return {};
    return end_of_further_run(time_step());
  }



  bool Simulation::has_coarser_mesh() const
  {
    return !coarser_mesh(2.).empty();
  }



  int Simulation::n_blocks() const
  {
    return model.blocks != nullptr ? model.blocks->n_blocks() : 0;
  }



  void Simulation::measure_step_error(const Run &run, output::Summary &summary)
  {
    const scene::TimeParameters &time = model.scene.time;
    if (time.second_run != scene::SecondRun::none || model.scene.mesh.coarser_runs ||
        time.error_target != 0.)
      {
        record            = run.recorder->step_record(summary.first_loss_time);
        record->slip_left = summary.slip.mean_left;
      }
    if (time.error_target == 0. || !summary.probable_error.runs_would_do)
      return;
    if (const auto longer = output::read_step_record(step_record_file(directory())))
      output::measure_error(*longer, *record, summary.probable_error);
  }



  RunStatus Simulation::finish(Run &run, RunStatus status)
  {
    output::Summary &summary = run.summary;
    run.end_steps();
    const auto needs =
      collect(run.recorder ? run.recorder->needs_at_end(state.time) : output::RunRecorder::Needs());
    if (run.recorder)
      {
        run.recorder->finish(state, summary);
        measure_step_error(run, summary);
      }
    if (run.shared_pictures && needs.picture)
      run.shared_pictures->write(state.continuum, "");
    write_shared_peaks(run);
    if (!run.recorder)
      return agreed_status(status);
    status                 = agreed_status(judge_energy(run, status));
    summary.title          = model.scene.title;
    summary.finished       = status == RunStatus::finished;
    summary.simulated_time = run.clock.time();
    summary.blocks         = n_blocks();
    summary.continuum_unknowns =
      model.continuum != nullptr ? static_cast<long>(model.continuum->n_unknowns()) : 0;
    summary.interface_unknowns = model.foundation != nullptr
                                   ? 2 * static_cast<long>(model.foundation->surface_nodes().size())
                                   : 0;
    summarize(output::resolve(
                model.scene, model.motion.outcrop(), model.blocks.get(), model.continuum.get()),
              summary);
    summary.wasted.cuts = run.clock.cuts();
    if (model.continuum != nullptr)
      summary.timings["continuum_factors"] = model.continuum->factor_time();
    run.count_processor_time("writing");
    summary.wall_time      = run.wall_time();
    summary.processor_time = run.processor_time();
    summary.peak_memory    = peak_memory();
    summary.probable_error.cost =
      summary.stages["steps"]; // twice as many, which need not be harder
    if (summary.probable_error.runs_would_do && !has_error_target() && record &&
        record->until < least_steps_to_compare * std::max(time_step(), second_time_step()))
      {
        summary.probable_error.reason        = "a joint failed in the first steps";
        summary.probable_error.runs_would_do = false;
      }
    found = summary;
    if (end_of_second_run())
      summary.probable_error.second_step = second_time_step();
    summary.mesh_error.follows       = end_of_coarser_runs().has_value();
    summary.mesh_error.runs_would_do = has_coarser_mesh();
    summary.mesh_error.with_step =
      model.scene.time.newmark.corrected_step > 0. && !model.scene.continuum.is_explicit;
    summary.mesh_error.never = why_no_coarser_mesh();
    if (!summary.mesh_error.never.empty())
      summary.mesh_error.reason = summary.mesh_error.never;
    output::write_summary(summary, model.scene.output.directory + "/summary.json");

    run_report.end(summary, status);
    return status;
  }
} // namespace hybrid
