// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/end_text.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/line_card.h>
#include <hybrid/output/memory_estimate.h>
#include <hybrid/output/monitor_card.h>
#include <hybrid/output/scene_card.h>
#include <hybrid/run_directory.h>
#include <hybrid/run_report.h>
#include <hybrid/scene/checks/doubtful_values.h>
#include <hybrid/scene/checks/free_field_check.h>
#include <hybrid/scene/checks/geometry_warnings.h>
#include <hybrid/scene/checks/joint_line_warnings.h>
#include <hybrid/scene/checks/settings_without_effect.h>
#include <hybrid/scene/checks/water_check.h>
#include <hybrid/scene/mesh/unit_check.h>

#include <algorithm>
#include <cmath>

namespace hybrid
{
  namespace
  {
    std::string residual_text(const dda::StaticResult &settled)
    {
      if (settled.steps == 0)
        return "not settled";
      return output::formatted("relative residual %.1e", settled.residual);
    }



    /// Where and how the dynamic stage starts without an equilibrium.
    std::string starts_there(const dda::StaticResult &settled)
    {
      constexpr double  told = 0.01; // m
      const std::string text = "; the dynamic stage starts from rest there";
      if (settled.largest_displacement < told)
        return text;
      return text + output::formatted(
                      ", up to %.3g m from where the blocks were drawn: displacements count from "
                      "there, and the speed that this way would have given them is not in them",
                      settled.largest_displacement);
    }
  } // namespace



  RunReport::RunReport(const SceneModel &scene_model, output::Log &run_log)
    : model(scene_model)
    , log(run_log)
  {}



  void RunReport::card() const
  {
    const scene::InputMotion &input = model.input;
    const output::SceneCard   card  = output::make_scene_card(model.scene,
                                                           model.motion.outcrop(),
                                                           model.blocks.get(),
                                                           model.continuum.get());
    log.info(card.text);
    const std::string lines = output::describe_lines(model.mesh, model.scene);
    if (!lines.empty())
      log.info(lines);
    const std::string monitors = model.blocks != nullptr
                                   ? output::describe_monitors(model.scene.monitors.monitors,
                                                               model.monitor_blocks,
                                                               *model.blocks)
                                   : "";
    if (!monitors.empty())
      log.info(monitors);
    if (!input.scaling.empty())
      log.info("Motion     " + input.scaling);
    for (const std::string &note : input.notes)
      log.info("Motion     " + note);
    for (const std::string &warning : input.warnings)
      log.warning(warning);
    for (const std::string &warning : scene::unit_warnings(model.mesh, model.scene))
      log.warning(warning);
    for (const std::string &warning : scene::geometry_warnings(model.mesh, model.scene))
      log.warning(warning);
    for (const std::string &warning : scene::joint_line_warnings(model.mesh, model.scene))
      log.warning(warning);
    for (const std::string &warning : scene::free_field_warnings(model.mesh, model.scene))
      log.warning(warning);
    for (const std::string &warning : scene::doubtful_values(model.scene, input.motion))
      log.warning(warning);
    for (const std::string &warning : scene::settings_without_effect(model.scene))
      log.warning(warning);
    for (const std::string &warning : scene::water_warnings(model.mesh, model.scene))
      log.warning(warning);
    for (const std::string &warning : card.warnings)
      log.warning(warning);
  }



  void RunReport::memory(const bool warning_only, const int processes) const
  {
    const auto estimate =
      output::estimate_memory(model.scene, model.mesh, model.blocks.get(), model.continuum.get());
    if (!warning_only)
      log.info(output::describe(estimate, processes));
    const std::string warning =
      output::memory_warning(estimate, processes, output::available_memory());
    if (!warning.empty())
      log.warning(warning);
  }



  void RunReport::lifts(const dda::LiftResult &result) const
  {
    log.info(output::formatted(
      "Lifts: %d with blocks; largest displacement of a block since its lift was placed "
      "%.3g m, at (%.2f, %.2f)",
      result.lifts,
      result.largest_displacement,
      result.place.x(),
      result.place.y()));
  }



  void RunReport::static_stage(const dda::StaticResult &settled,
                               const dda::DdaState     &state,
                               const bool               has_failed) const
  {
    int    tensile = 0, shear = 0;
    double slip = 0.;
    for (const dda::JointState &joint : state.joints)
      {
        for (const dda::SpringState &point : joint.points)
          slip = std::max(slip, std::abs(point.slip));
        tensile += joint.failure == dda::FailureKind::tensile ? 1 : 0;
        shear += joint.failure == dda::FailureKind::shear ? 1 : 0;
      }
    log.info(output::formatted(
      "Static stage: %s after %d steps (%d iterations), largest displacement %.3g m; "
      "joints failed: %d tensile, %d shear; largest slip of a joint %.3g m",
      residual_text(settled).c_str(),
      settled.steps,
      settled.iterations,
      settled.largest_displacement,
      tensile,
      shear,
      slip));
    if (settled.equilibrium)
      {
        fallen_blocks(settled, state, has_failed);
        slid_blocks(settled);
        weakening_belt(state);
        return;
      }
    const bool  is_held = model.scene.environment.static_stage == scene::StaticStage::held;
    std::string where =
      model.scene.environment.horizontal != 0. ? " and Gravity/Horizontal coefficient" : "";
    if (settled.moving_block >= 0)
      {
        const Vec2 &c = state.blocks[settled.moving_block].centroid;
        where += output::formatted(", most of all block %s at (%.2f, %.2f)",
                                   model.mesh.block_name(settled.moving_block).c_str(),
                                   c.x(),
                                   c.y());
      }
    log.warning(
      std::string(
        is_held
          ? "no static equilibrium was found, with unlimited strengths either: blocks still move"
          : "no static equilibrium was found: the mass moves under its own weight") +
      where +
      (has_failed
         ? "; the run ends here: give it more strength (Blocks/Material, Blocks/Belt material), or "
           "set Gravity/Static stage to held (settles with unlimited strengths), none (starts "
           "unloaded, and settles with inertia: loose blocks may find rest so that slide here) or "
           "equilibrium or move (starts from where it has got to)"
         : starts_there(settled)));
  }



  void RunReport::fallen_blocks(const dda::StaticResult &settled,
                                const dda::DdaState     &state,
                                const bool               has_failed) const
  {
    if (settled.fallen_block < 0)
      return;
    const Vec2       &c    = state.blocks[settled.fallen_block].centroid;
    const std::string text = output::formatted(
      "the mass does not stand as it was drawn: block %s has moved by %.3g m and turned by %.3g "
      "degrees before it came to rest at (%.2f, %.2f)",
      model.mesh.block_name(settled.fallen_block).c_str(),
      settled.fallen_by,
      settled.turned_by * 180. / M_PI,
      c.x(),
      c.y());
    log.warning(
      text + std::string(
               has_failed
                 ? "; the run ends here: draw it where it stands, give it more strength, or set "
                   "Gravity/Static stage to equilibrium or move (starts from where it has got to) "
                   "or none (starts unloaded)"
                 : "; the dynamic stage starts from there"));
  }



  void RunReport::slid_blocks(const dda::StaticResult &settled) const
  {
    if (settled.slid_block < 0 || settled.fallen_block >= 0)
      return;
    log.warning(output::formatted(
      "blocks have moved by up to %.3g m (block %s) before they came to rest, elasticity explains "
      "at most about %.2g m: they slid or turned; is this the slope that you drew?",
      settled.slid_by,
      model.mesh.block_name(settled.slid_block).c_str(),
      settled.elastic_settlement));
  }



  void RunReport::weakening_belt(const dda::DdaState &state) const
  {
    double slip = 0.; // plastic, of an end [m]
    for (std::size_t j = 0; j < state.joints.size(); ++j)
      if (model.blocks->joints[j].law.weakens_with_rate())
        for (const dda::SpringState &point : state.joints[j].points)
          slip = std::max(slip, std::abs(point.history.plastic_slip));
    if (slip > 0.)
      log.warning(output::formatted(
        "the belt weakens with the rate of slip, and parts of it have reached their strength at "
        "rest, where the rate counts as zero (slip up to %.3g m): what creeps there faster than "
        "Friction reference rate loses strength and may slide by itself; a run with Motion/Type = "
        "none shows how far",
        slip));
  }



  void RunReport::planes(const continuum::StaticSlip &planes) const
  {
    if (!planes.solved)
      log.warning("the static stress of the bedrock was not found: pictures show that of the waves "
                  "only");
    if (!model.scene.bedding.slips || model.scene.bedding.names.empty())
      return;
    std::string found = output::formatted("Bedding planes at rest: %d points slip, %d are open",
                                          planes.slipping,
                                          planes.open);
    if (planes.equilibrium)
      found += output::formatted(", largest slip %.3g m", planes.largest);
    log.info(found);
    if (model.scene.environment.horizontal != 0. && model.continuum != nullptr)
      log.warning("Gravity/Horizontal coefficient: at rest the sides of the bedrock, which are on "
                  "rollers, bear a part of the push that planes would bear in a wider section");
    if (planes.pull > 0.)
      log.warning(output::formatted(
        "the side of the section near (%.2f, %.2f) holds the rock there back at rest, by a pull of %.3g N/m: "
        "sides are on rollers, which do not let go, and what slides away on a plane, or is let go by an "
        "initial stress, hangs on them. Name that part of the side ground if nothing holds it there (a "
        "crack), or let the planes and the section go on to where the rock stands by itself",
        planes.pulled.x(),
        planes.pulled.y(),
        planes.pull));
    if (planes.equilibrium)
      return;
    log.warning("the bedding planes cannot carry their load at rest, most of all " +
                model.scene.bedding.names[planes.plane] +
                output::formatted(" near (%.2f, %.2f)", planes.where.x(), planes.where.y()) +
                ": what lies on them slides from the start");
  }



  void RunReport::resumed(const double time, const long steps, const bool at_end) const
  {
    log.info(output::formatted("Resumed from the checkpoint at t = %.6g s, after %ld steps%s",
                               time,
                               steps,
                               at_end
                                 ? ", the end of the run (a later one: -s \"Time/End time=...\")"
                                 : ""));
  }



  void RunReport::at_rest(const double time) const
  {
    log.info(output::formatted(
      "At rest    at t = %.4g s: no corner of a block was faster than %g m/s for a second",
      time,
      model.scene.time.rest_speed));
  }



  void RunReport::missing_pictures(const std::vector<std::string> &files) const
  {
    if (files.empty())
      return;
    const bool one = files.size() == 1;
    log.warning(std::to_string(files.size()) + (one ? " picture" : " pictures") +
                " of the part before " + (one ? "is" : "are") + " gone from '" +
                model.scene.output.directory + "'" + (one ? ", " : ", the first is ") +
                files.front() + ": the .pvd files list the others, and all other results go on");
  }



  void RunReport::no_convergence(const dda::StepResult &result, const double time) const
  {
    if (result.is_passed)
      {
        log.warning(output::formatted(
          "stopped at t = %.6g s: in the smallest step %.3g s a corner would go into a body "
          "before it has a contact; a shorter Time/Time step or more Time/Maximum halvings do",
          time,
          std::ldexp(model.scene.time.time_step, -model.scene.time.maximum_halvings)));
        return;
      }
    log.warning(output::formatted(
      "stopped at t = %.6g s: the open-close iteration does not settle at the smallest step %.3g s "
      "(relative residual %.2e after %d iterations, largest displacement ratio %.3g)",
      time,
      std::ldexp(model.scene.time.time_step, -model.scene.time.maximum_halvings),
      result.residual,
      result.iterations,
      result.displacement_ratio));
  }



  void RunReport::search_stopped(const double time, const double time_step) const
  {
    log.info(output::formatted(
      "Stopped at t = %.6g s while the stiffness of the surface was found for steps of "
      "%.4g s: all steps before are kept, and a run that goes on finds it anew",
      time,
      time_step));
  }



  void RunReport::end(const output::Summary &summary, const RunStatus status) const
  {
    const output::EndText text = output::end_text(summary, model.scene);
    log.info(text.on_screen, text.in_file);
    if (status == RunStatus::interrupted)
      log.info("Interrupted; to continue: " + resume_command(model.scene.output.directory));
    if (status == RunStatus::energy_limit)
      log.info("To go on nevertheless: " + resume_command(model.scene.output.directory) +
               " -s \"Output/Energy limit=0\"");
  }
} // namespace hybrid
