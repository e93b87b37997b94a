// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/statics/lifts.h>
#include <hybrid/dda/statics/static_stage.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/output/summary.h>
#include <hybrid/run_status.h>
#include <hybrid/scene_model.h>

#include <string>
#include <vector>

namespace hybrid
{
  /// What a run says in its log.
  class RunReport
  {
  public:
    RunReport(const SceneModel &model, output::Log &log);

    /// Scene card and warnings.
    void card() const;

    /// What a run will take of the machine's memory. Only a warning belongs in the log of a run:
    /// the numbers differ a little between equal runs. @param processes on this machine that
    /// compute the scene
    void memory(bool warning_only, int processes) const;

    /// Of a mass that was placed in lifts.
    void lifts(const dda::LiftResult &result) const;

    /// @param has_failed the run ends for what the stage found.
    void static_stage(const dda::StaticResult &result,
                      const dda::DdaState     &state,
                      bool                     has_failed) const;

    /// Bedding planes at rest.
    void planes(const continuum::StaticSlip &planes) const;

    void resumed(double time, long steps, bool at_end) const;

    /// Of a run that ends as nothing moves any more (RestWatch).
    void at_rest(double time) const;

    /// The user has ended the search for the surface's stiffness for a step from @p time [s].
    void search_stopped(double time, double time_step) const;

    /// Of a run that goes on: somebody has deleted pictures.
    void missing_pictures(const std::vector<std::string> &files) const;

    /// A step failed at the smallest allowed size.
    void no_convergence(const dda::StepResult &result, double time) const;

    /// The last lines, and how to go on.
    void end(const output::Summary &summary, RunStatus status) const;

  private:
    const SceneModel &model;
    output::Log      &log;

    void fallen_blocks(const dda::StaticResult &result,
                       const dda::DdaState     &state,
                       bool                     has_failed) const;

    void slid_blocks(const dda::StaticResult &result) const;

    /// A belt that weakens with the rate of slip and has slipped at rest.
    void weakening_belt(const dda::DdaState &state) const;
  };
} // namespace hybrid
