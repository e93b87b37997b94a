// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /// What a run of nine blocks with two monitors found.
  inline Summary a_run()
  {
    Summary run;
    run.finished = true;
    run.steps = 15000, run.simulated_time = 15., run.wall_time = 247., run.blocks = 9;
    run.energy_residual = 5e-8;
    MonitorSummary crest;
    crest.peak_displacement      = {{-16.1e-3, 2e-3}};
    crest.final_displacement     = {{-10.6e-3, 1e-3}};
    crest.peak_acceleration      = {{4.2183, 1.}};
    crest.amplification          = {{1.49, MonitorSummary::unknown}};
    run.monitors                 = {{"base", {}}, {"crest", crest}};
    run.slip                     = {0.011, 0.012, {{1., 2.}}, 10.1e-3, 10.3e-3, 0.5, 1e-3};
    run.base_shear               = {1., 1., 1., 0.7, 1., 0.65};
    run.probable_error.reason    = "blocks";
    run.mesh_error.runs_would_do = true;
    return run;
  }
} // namespace hybrid::output
