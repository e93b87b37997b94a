// SPDX-License-Identifier: GPL-3.0-or-later
// What a run says of its energy audit.
#include <hybrid/dda/statics/elastic_settlement.h>
#include <hybrid/simulation_run.h>

namespace hybrid
{
  bool Simulation::watch_energy(Run &run) const
  {
    if (!run.recorder)
      return true;
    const output::EnergyLedger &ledger = run.recorder->energy();
    const std::string           text   = run.energy.look(ledger, run.clock.time());
    if (!text.empty())
      log.warning(text);
    return !run.energy.is_over(ledger);
  }



  RunStatus Simulation::judge_energy(Run &run, const RunStatus status) const
  {
    const bool acts_at_once =
      model.blocks != nullptr && model.scene.environment.static_stage == scene::StaticStage::none;
    const double settling =
      acts_at_once ? dda::work_of_settlement(*model.blocks, state.blocks) : 0.;
    const std::string of_scheme =
      run.recorder ? run.energy.of_scheme(run.recorder->energy(), settling) : std::string();
    if (!of_scheme.empty())
      log.warning(of_scheme);
    if (status == RunStatus::energy_limit || watch_energy(run))
      return status;
    return status == RunStatus::finished ? RunStatus::energy_limit : status;
  }
} // namespace hybrid
