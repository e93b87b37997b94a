// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/monitor_summary.h>
#include <hybrid/restart/archive_forward.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hybrid::output
{
  /// What is kept of a run to compare it with one in shorter steps.
  struct StepRecord
  {
    struct Monitor
    {
      std::string name;
      /// Displacement, velocity, acceleration: pairs, one per time [m, m/s, m/s2].
      std::array<std::vector<double>, 3> histories;
    };

    double               step = 0.; ///< Time/Time step [s]
    std::vector<double>  time;      ///< end of each step [s]
    std::vector<Monitor> monitors;
    double least_motion = 1e-3; ///< of the largest: monitors that move less are left out [-]
    int    base         = -1;   ///< monitor that displacements are relative to; -1: none
    double corner       = 0.;   ///< of the zero-phase low-pass before peaks [Hz]; 0: none
    double until = MonitorSummary::unknown; ///< what is later is left out [s]; NaN: nothing is

    double slip_left = MonitorSummary::unknown; ///< mean on the sliding surface, at the end [m]

    /// From the run before in longer steps: displacement, velocity, acceleration, as
    /// step_difference() has it [-]; NaN: there was none.
    std::array<double, 3> difference = {
      {MonitorSummary::unknown, MonitorSummary::unknown, MonitorSummary::unknown}};
  };


  void serialize(restart::Archive &archive, StepRecord::Monitor &monitor);
  void serialize(restart::Archive &archive, StepRecord &record);

  /// Safe from a kill. @throws WriteError.
  void write_step_record(const std::string &file_name, const StepRecord &record);

  /// Nothing if there is no file, or one of another program. @throws InputError if it is damaged.
  std::optional<StepRecord> read_step_record(const std::string &file_name);
} // namespace hybrid::output
