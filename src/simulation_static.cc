// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/initial_bedding_tractions.h>
#include <hybrid/dda/statics/initial_block_stress.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/output/static_progress.h>
#include <hybrid/output/terminal.h>
#include <hybrid/simulation.h>

#include <iostream>

// The static stage of a run.
namespace hybrid
{
  bool Simulation::settle(const Interruption &interruption)
  {
    const double horizontal = model.scene.environment.horizontal * model.scene.environment.gravity;
    if (model.blocks == nullptr)
      {
        if (model.continuum != nullptr && model.scene.environment.gravity > 0.)
          report_planes(model.continuum->solve_static_state(
            Eigen::VectorXd::Zero(
              2 * static_cast<Eigen::Index>(model.continuum->surface_nodes().size())),
            model.scene.environment.gravity,
            horizontal));
        return true;
      }
    // The bedrock has no weight of its own to settle under.
    if (model.scene.environment.static_stage == scene::StaticStage::none ||
        model.scene.environment.gravity == 0. || !model.scene.blocks.enabled)
      {
        state.blocks.energy = dda::stored_energy(*model.blocks, state.blocks);
        stress_planes();
        return true;
      }
    if (model.scene.environment.has_initial_stress())
      dda::prescribe_block_stress(scene::InitialStress(model.mesh, model.scene),
                                  static_cast<int>(model.mesh.block_region_names.size()),
                                  *model.blocks,
                                  state.blocks);
    if (model.scene.environment.is_staged())
      {
        lifts = dda::place_in_lifts(*model.blocks, model.scene.environment.lifts, state.blocks);
        run_report.lifts(lifts);
      }
    std::ostream               screen(is_first() ? std::cout.rdbuf() : nullptr);
    output::StaticProgressLine line(screen, is_first() && output::standard_output_is_terminal());
    settled = dda::settle(
      *model.blocks,
      state.blocks,
      model.scene.environment.static_stage == scene::StaticStage::held,
      [&](const dda::StaticProgress &progress) {
        line.update(progress);
        return !agree({false, interruption.is_requested(), false}).interruption;
      },
      model.scene.environment.reset_softening);
    if (settled.stopped)
      return false;
    run_report.static_stage(settled, state.blocks, has_failed_to_stand());
    if (model.continuum != nullptr)
      settle_bedrock();
    stress_planes();
    return true;
  }



  void Simulation::settle_bedrock()
  {
    const scene::EnvironmentParameters &environment = model.scene.environment;
    const dda::Water                   &given       = model.blocks->water;
    const bool       slips = model.scene.bedding.slips && !model.scene.bedding.names.empty();
    const dda::Water water = slips ? given.as_pressures() : given;
    report_planes(model.continuum->solve_static_state(
      state.blocks.static_force + dda::water_on_surface(water,
                                                        model.blocks->initial.foundation_nodes,
                                                        model.blocks->initial.foundation_degree),
      environment.gravity,
      environment.horizontal * environment.gravity,
      [&water](const Vec2 &place) { return dda::pore_pressure(water, place); }));
  }



  void Simulation::stress_planes()
  {
    if (!model.scene.has_bedrock_blocks() || !model.scene.bedding.slips)
      return;
    const bool settles = !model.scene.blocks.enabled ||
                         model.scene.environment.static_stage != scene::StaticStage::none;
    const auto rest = dda::stress_bedding_planes(model.mesh,
                                                 model.scene,
                                                 *model.blocks,
                                                 settles && model.scene.environment.gravity > 0.,
                                                 state.blocks);
    model.foundation->take_rest(state);
    report_planes(
      {rest.equilibrium, rest.slipping, rest.open, rest.largest, rest.where, rest.plane});
  }



  void Simulation::report_planes(const continuum::StaticSlip &rest)
  {
    planes_at_rest = rest;
    run_report.planes(rest);
  }



  output::Summary::StaticStage Simulation::static_summary() const
  {
    const scene::SceneParameters &scene = model.scene;
    const bool planes_alone             = !scene.blocks.enabled && scene.environment.gravity > 0. &&
                              scene.bedding.slips && !scene.bedding.names.empty();
    return {settled.steps + settled.cuts > 0 || planes_alone,
            planes_alone ? planes_at_rest.equilibrium
                         : settled.equilibrium && settled.fallen_block < 0,
            planes_at_rest.equilibrium,
            settled.slid_block >= 0,
            settled.residual,
            settled.iterations,
            settled.largest_displacement,
            lifts.largest_displacement};
  }



  bool Simulation::has_failed_to_stand() const
  {
    return model.scene.environment.static_stage == scene::StaticStage::equilibrium &&
           settled.steps + settled.cuts > 0 && (!settled.equilibrium || settled.fallen_block >= 0);
  }
} // namespace hybrid
