// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/bedding_rest.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/output/static_progress.h>
#include <hybrid/output/terminal.h>
#include <hybrid/simulation.h>

#include <cstdio>
#include <iostream>

// The static stage of a run.
namespace hybrid
{
  bool Simulation::settle(const Interruption &interruption)
  {
    if (blocks == nullptr)
      {
        if (continuum != nullptr && scene.environment.gravity > 0.)
          report_planes(continuum->solve_static_state(
            Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(continuum->surface_nodes().size())),
            scene.environment.gravity));
        return true;
      }
    // The bedrock has no weight of its own to settle under.
    if (scene.environment.static_stage == scene::StaticStage::none ||
        scene.environment.gravity == 0. || !scene.blocks.enabled)
      {
        state.blocks.energy = dda::held_energy(*blocks, state.blocks);
        stress_planes();
        return true;
      }
    output::StaticProgressLine line(std::cout, output::standard_output_is_terminal());
    settled = dda::settle(
      *blocks,
      state.blocks,
      scene.environment.static_stage == scene::StaticStage::held,
      [&](const dda::StaticProgress &progress) {
        line.update(progress);
        return !interruption.is_requested();
      },
      scene.environment.reset_softening);
    if (settled.stopped)
      return false;
    report_static_stage();
    if (continuum != nullptr)
      report_planes(continuum->solve_static_state(
        state.blocks.static_force +
          dda::water_on_surface(blocks->water, blocks->initial.base_nodes),
        scene.environment.gravity));
    stress_planes();
    return true;
  }



  void Simulation::stress_planes()
  {
    if (!scene.has_bedrock_blocks() || !scene.bedding.slips)
      return;
    const bool settles =
      !scene.blocks.enabled || scene.environment.static_stage != scene::StaticStage::none;
    const auto rest = dda::stress_bedding_planes(
      mesh, scene, *blocks, settles && scene.environment.gravity > 0., state.blocks);
    report_planes({rest.equilibrium, rest.slipping, rest.open, rest.largest, rest.where});
  }



  void Simulation::report_planes(const continuum::StaticSlip &planes) const
  {
    if (!scene.bedding.slips || scene.bedding.names.empty())
      return;
    char text[200];
    std::snprintf(text,
                  sizeof(text),
                  "Bedding planes at rest: %d points slip, %d are open, largest slip %.3g m",
                  planes.slipping,
                  planes.open,
                  planes.largest);
    log.info(text);
    if (planes.equilibrium)
      return;
    std::snprintf(
      text,
      sizeof(text),
      "the bedding planes cannot carry their load at rest, most of all near (%.2f, %.2f)",
      planes.where.x(),
      planes.where.y());
    log.warning(text);
  }



  void Simulation::report_static_stage() const
  {
    int    tensile = 0, shear = 0;
    double slip = 0.;
    for (const dda::JointState &joint : state.blocks.joints)
      {
        for (const dda::SpringState &point : joint.points)
          slip = std::max(slip, std::abs(point.slip));
        tensile += joint.failure == dda::FailureKind::tensile ? 1 : 0;
        shear += joint.failure == dda::FailureKind::shear ? 1 : 0;
      }
    char text[300];
    std::snprintf(
      text,
      sizeof(text),
      "Static stage: relative residual %.1e after %d steps (%d iterations), largest settlement %.3g m; "
      "joints failed: %d tensile, %d shear; largest slip of a joint %.3g m",
      settled.residual,
      settled.steps,
      settled.iterations,
      settled.largest_displacement,
      tensile,
      shear,
      slip);
    log.info(text);
    if (settled.equilibrium)
      {
        warn_of_fallen_blocks();
        return;
      }
    std::string where;
    if (settled.moving_block >= 0)
      {
        const Vec2 &c = state.blocks.blocks[settled.moving_block].centroid;
        std::snprintf(text,
                      sizeof(text),
                      ", most of all block %d at (%.2f, %.2f)",
                      settled.moving_block,
                      c.x(),
                      c.y());
        where = text;
      }
    log.warning(
      "no static equilibrium was found: the mass moves under its own weight" + where +
      (has_failed_to_stand()
         ? "; the run ends here: give it more strength (Blocks/Material, Blocks/Belt material), or "
           "set Gravity/Static stage to held (settles with unlimited strengths), none (starts "
           "unloaded) or equilibrium or move (starts from where it has got to)"
         : "; the dynamic stage starts from rest there"));
  }



  void Simulation::warn_of_fallen_blocks() const
  {
    if (settled.fallen_block < 0)
      return;
    const Vec2 &c = state.blocks.blocks[settled.fallen_block].centroid;
    char        text[200];
    std::snprintf(
      text,
      sizeof(text),
      "the mass does not stand as it was drawn: block %d has moved by %.3g m and turned by %.3g "
      "degrees before it came to rest at (%.2f, %.2f)",
      settled.fallen_block,
      settled.fallen_by,
      settled.turned_by * 180. / M_PI,
      c.x(),
      c.y());
    log.warning(
      text + std::string(
               has_failed_to_stand()
                 ? "; the run ends here: draw it where it stands, give it more strength, or set "
                   "Gravity/Static stage to equilibrium or move (starts from where it has got to) "
                   "or none (starts unloaded)"
                 : "; the dynamic stage starts from there"));
  }



  bool Simulation::has_failed_to_stand() const
  {
    return scene.environment.static_stage == scene::StaticStage::equilibrium &&
           settled.steps + settled.cuts > 0 && (!settled.equilibrium || settled.fallen_block >= 0);
  }
} // namespace hybrid
