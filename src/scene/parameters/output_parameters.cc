// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, OutputParameters &output)
  {
    ParameterSection     section(table, {"Output"});
    const ParameterRange not_negative = ParameterRange::at_least(0.);
    section.text("Directory",
                 output.directory,
                 "a directory; relative to the working directory",
                 "Where the results go.");
    section.number("Picture interval",
                   output.picture_interval,
                   "s",
                   not_negative,
                   "Simulated time between files for ParaView; 0: only the first and the last.");
    section.number("Flush interval",
                   output.flush_interval,
                   "s",
                   not_negative,
                   "Wall time between flushes of run.h5.");
    section.number("Audit interval",
                   output.audit_interval,
                   "s",
                   ParameterRange::above(0.),
                   "Simulated time between energy audits.");
    section.number(
      "Slip threshold",
      output.slip_threshold,
      "m",
      not_negative,
      "A part of the sliding surface counts as slipped once it has slid farther; joint lines "
      "that have slipped or opened by more are named at the end of a run.");
    section.number(
      "Energy warning",
      output.energy_warning,
      "",
      not_negative,
      "Warn when the energy audit misses this part of the energy in play or the time "
      "integration gives it, and at the end if the time integration took it; 0: never.");
    section.number(
      "Energy limit",
      output.energy_limit,
      "",
      not_negative,
      "Stop, with a checkpoint, when the energy audit misses this part of the energy in "
      "play or the time integration gives it; 0: never. To go on: hybrid --resume with a larger one.");
  }
} // namespace hybrid::scene
