// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/block_bedrock.h>
#include <hybrid/coupling/condensed_base.h>
#include <hybrid/coupling/rigid_base.h>
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/model/bedrock_blocks.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/output/line_card.h>
#include <hybrid/output/memory_estimate.h>
#include <hybrid/output/mesh_progress.h>
#include <hybrid/output/probes.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/scene_card.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/checks/doubtful_values.h>
#include <hybrid/scene/checks/free_field_check.h>
#include <hybrid/scene/checks/geometry_warnings.h>
#include <hybrid/scene/checks/mesh_check.h>
#include <hybrid/scene/checks/settings_without_effect.h>
#include <hybrid/scene/mesh/edge_chain.h>
#include <hybrid/scene/mesh/unit_check.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/simulation_run.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <sys/resource.h>

namespace hybrid
{
  namespace
  {
    /// Largest resident memory so far [MB].
    double peak_memory()
    {
      rusage usage;
      return getrusage(RUSAGE_SELF, &usage) == 0 ? usage.ru_maxrss / 1024. : 0.;
    }



    /// What of the slip on the sliding surface is left at the end, in the last line of a run.
    std::string describe(const output::Summary::Slip &slip)
    {
      if (std::isnan(slip.mean_left))
        return "";
      char text[100];
      std::snprintf(text,
                    sizeof(text),
                    "slip left on the sliding surface %.3g m, at most %.3g m, ",
                    slip.mean_left,
                    slip.largest_left);
      return text;
    }



    /// The polyline of a rigid base: sliding surface and ground of the mesh, left to right.
    std::vector<Vec2> surface_of(const scene::SectionMesh &mesh)
    {
      std::vector<scene::SectionMesh::Edge> edges;
      for (const char *name : {"ground", "sliding_surface"})
        {
          const auto line = mesh.lines.find(name);
          if (line != mesh.lines.end())
            edges.insert(edges.end(), line->second.begin(), line->second.end());
        }
      std::vector<Vec2> nodes;
      int               last = -1;
      for (const auto &edge :
           scene::chain_edges(edges, mesh.nodes, "of ground and sliding_surface"))
        {
          if (last >= 0 && edge[0] != last)
            break; // another path, farther right
          if (last < 0)
            nodes.push_back(mesh.nodes[edge[0]]);
          nodes.push_back(mesh.nodes[last = edge[1]]);
        }
      return nodes;
    }
  } // namespace



  Simulation::Simulation(const scene::SceneParameters &parameters,
                         output::Log                  &run_log,
                         MPI_Comm                      communicator)
    : scene(parameters)
    , log(run_log)
    , mesh(output::read_section_mesh(parameters.mesh, log))
    , input(scene::make_input_motion(parameters.motion, parameters.time))
    , motion(input.motion, parameters.motion)
  {
    const auto heartbeat = output::tell_of_preparation(mesh, log);
    scene::check_section_mesh(mesh, scene);
    if (scene.continuum_model == scene::ContinuumModel::elastic)
      continuum = std::make_unique<continuum::Continuum>(mesh, scene, motion, communicator);
    if (scene.has_blocks())
      make_blocks();
    else if (continuum != nullptr)
      state.continuum = continuum->initial_state();
    check_points();
  }



  void Simulation::make_blocks()
  {
    if (scene.has_bedrock_blocks())
      {
        make_bedrock_blocks();
        return;
      }
    if (continuum != nullptr)
      {
        base            = std::make_unique<coupling::CondensedBase>(*continuum);
        state.continuum = continuum->initial_state();
      }
    else
      base = std::make_unique<coupling::RigidBase>(surface_of(mesh), motion);
    blocks = std::make_unique<dda::Model>(dda::build_model(mesh, scene, base->surface_nodes()));
    blocks->initial.base_shares = base->surface_shares();
    state.blocks                = dda::initial_state(*blocks);
  }



  void Simulation::make_bedrock_blocks()
  {
    std::vector<Vec2> nodes;
    for (const int node : dda::cut_bedrock(mesh, scene).base)
      nodes.push_back(mesh.nodes[node]);
    blocks       = std::make_unique<dda::Model>(dda::build_model(mesh, scene, nodes));
    auto bedrock = std::make_unique<coupling::BlockBedrock>(nodes, motion, scene, blocks->boundary);
    state.continuum = bedrock->initial_state();
    state.blocks    = dda::initial_state(*blocks);
    base            = std::move(bedrock);
  }



  void Simulation::check_points() const
  {
    output::Probes probes(blocks.get(), continuum.get(), base.get());
    for (const scene::Monitor &monitor : scene.monitors.monitors)
      probes.add(monitor.position, monitor.name);
    for (const scene::Borehole &hole : scene.monitors.boreholes)
      {
        for (const Vec2 &end : {hole.top, hole.bottom})
          probes.add(end, hole.name);
        for (int k = 1; k + 1 < hole.samples; ++k)
          probes.add(hole.top + k / (hole.samples - 1.) * (hole.bottom - hole.top),
                     hole.name + " sample " + std::to_string(k));
      }
  }



  void Simulation::print_card() const
  {
    const output::SceneCard card =
      output::make_scene_card(scene, motion.outcrop(), blocks.get(), continuum.get());
    log.info(card.text);
    const std::string lines = output::describe_lines(mesh, scene);
    if (!lines.empty())
      log.info(lines);
    if (!input.scaling.empty())
      log.info("Motion     " + input.scaling);
    for (const std::string &note : input.notes)
      log.info("Motion     " + note);
    for (const std::string &warning : input.warnings)
      log.warning(warning);
    for (const std::string &warning : scene::unit_warnings(mesh, scene))
      log.warning(warning);
    for (const std::string &warning : scene::geometry_warnings(mesh, scene))
      log.warning(warning);
    for (const std::string &warning : scene::free_field_warnings(mesh, scene))
      log.warning(warning);
    for (const std::string &warning : scene::doubtful_values(scene, input.motion))
      log.warning(warning);
    for (const std::string &warning : scene::settings_without_effect(mesh, scene))
      log.warning(warning);
    for (const std::string &warning : card.warnings)
      log.warning(warning);
  }



  void Simulation::print_memory(const bool warning_only) const
  {
    const auto estimate = output::estimate_memory(scene, blocks.get(), continuum.get());
    if (!warning_only)
      log.info(output::describe(estimate));
    const std::string warning = output::memory_warning(estimate, output::available_memory());
    if (!warning.empty())
      log.warning(warning);
  }



  void Simulation::set_in_motion()
  {
    if (continuum != nullptr)
      continuum->start_wave(state.continuum);
    if (blocks != nullptr)
      dda::set_in_motion(*blocks, state.blocks);
  }



  RunStatus Simulation::run(const Interruption &interruption)
  {
    Run        run(*this, output::HistoryFile::Mode::create);
    const auto start = SteadyClock::now();
    if (!settle(interruption))
      {
        log.info("Interrupted in the static stage: there are no results and no checkpoint yet; to "
                 "begin anew: " +
                 resume_command(scene.output.directory));
        return RunStatus::interrupted;
      }
    run.summary.timings["static_stage"] = seconds_since(start);
    if (has_failed_to_stand())
      {
        run.recorder.start(state);
        finish(run, RunStatus::no_equilibrium);
        return RunStatus::no_equilibrium;
      }
    set_in_motion();
    run.recorder.start(state);
    if (scene.checkpoint.is_on())
      save(run);
    else
      run.recorder.flush();
    const RunStatus status = advance(run, interruption);
    return finish(run, status);
  }



  RunStatus Simulation::advance(Run &run, const Interruption &interruption)
  {
    output::Summary &summary     = run.summary;
    double          &output_time = summary.timings["output"];
    output::Progress progress(std::cout,
                              output::standard_output_is_terminal(),
                              run.clock.time(),
                              scene.time.end_time);
    const long       first_step = summary.steps, first_iteration = summary.iterations;
    RunStatus        status = RunStatus::finished;
    while (!run.clock.at_end() && status == RunStatus::finished)
      {
        const auto            begin  = SteadyClock::now();
        const double          dt     = run.clock.next_step();
        const dda::StepResult result = run.step.solve(state, dt);
        summary.iterations += result.iterations;
        if (!result.converged)
          {
            const bool too_far = result.displacement_ratio > scene.time.maximum_displacement_ratio;
            summary.wasted.moved_too_far += too_far ? 1 : 0;
            summary.wasted.iterations += too_far ? 0 : result.iterations;
            if (run.clock.shorten_step())
              {
                ++summary.wasted.retries;
                continue;
              }
            progress.finish();
            say_why(result, run.clock.time());
            status = RunStatus::no_convergence;
            break;
          }
        run.clock.accept();
        state.set_time(run.clock.time());
        ++summary.steps;

        const auto accepted = SteadyClock::now();
        run.recorder.record_step(state,
                                 result,
                                 dt,
                                 std::chrono::duration<double>(accepted - begin).count());
        progress.update(state.time(),
                        summary.steps - first_step,
                        summary.iterations - first_iteration);
        output_time += seconds_since(accepted);
        if (!watch_energy(run))
          status = RunStatus::energy_limit;
        else if (interruption.is_requested())
          status = RunStatus::interrupted;
        else if (run.schedule.is_due(summary.steps))
          save(run);
      }
    if (status != RunStatus::no_convergence)
      progress.finish();
    if (status == RunStatus::interrupted || status == RunStatus::energy_limit ||
        scene.checkpoint.is_on())
      save(run);
    return status;
  }



  RunStatus Simulation::finish(Run &run, RunStatus status)
  {
    output::Summary &summary = run.summary;
    run.recorder.finish(state, summary);
    status                 = judge_energy(run, status);
    summary.title          = scene.title;
    summary.finished       = status == RunStatus::finished;
    summary.simulated_time = run.clock.time();
    summary.blocks         = blocks != nullptr ? blocks->n_blocks() : 0;
    summary.continuum_unknowns =
      continuum != nullptr ? static_cast<long>(continuum->n_unknowns()) : 0;
    summary.interface_unknowns =
      base != nullptr ? 2 * static_cast<long>(base->surface_nodes().size()) : 0;
    summary.wasted.cuts          = run.clock.cuts();
    summary.timings["continuum"] = run.step.timings().continuum;
    summary.timings["blocks"]    = run.step.timings().blocks;
    if (run.solver != nullptr)
      {
        const dda::BlockSolver::SearchSummary &search = run.solver->search();
        summary.contact_search            = {search.steps, search.searches, search.lists};
        summary.timings["contact_search"] = search.time;
      }
    summary.wall_time   = run.wall_time();
    summary.peak_memory = peak_memory();
    output::write_summary(summary, scene.output.directory + "/summary.json");

    char text[300];
    std::snprintf(
      text,
      sizeof(text),
      "%s: %ld steps, %.4g s simulated, %ld cuts, joints failed %ld tensile %ld shear, %senergy residual %.2e",
      summary.finished ? "Finished" : "Stopped",
      summary.steps,
      summary.simulated_time,
      summary.wasted.cuts,
      summary.joints.tensile,
      summary.joints.shear,
      describe(summary.slip).c_str(),
      summary.energy_residual);
    log.info(text);
    if (status == RunStatus::interrupted)
      log.info("Interrupted; to continue: " + resume_command(scene.output.directory));
    if (status == RunStatus::energy_limit)
      log.info("To go on nevertheless: " + resume_command(scene.output.directory) +
               " -s \"Output/Energy limit=0\"");
    return status;
  }



  void Simulation::say_why(const dda::StepResult &result, const double time) const
  {
    char text[400];
    std::snprintf(
      text,
      sizeof(text),
      "stopped at t = %.6g s: the open-close iteration does not settle at the smallest step %.3g s "
      "(relative residual %.2e after %d iterations, largest displacement ratio %.3g)",
      time,
      std::ldexp(scene.time.time_step, -scene.time.maximum_halvings),
      result.residual,
      result.iterations,
      result.displacement_ratio);
    log.warning(text);
  }
} // namespace hybrid
