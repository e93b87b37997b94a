// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/directory_lock.h>
#include <hybrid/interruption.h>
#include <hybrid/processes.h>
#include <hybrid/run_status.h>
#include <hybrid/simulation.h>

#include <functional>
#include <memory>
#include <string>

namespace hybrid
{
  /// Builds the model of a scene; mistakes that show only then name the file.
  using SimulationMaker =
    std::function<std::unique_ptr<Simulation>(const std::string            &file,
                                              const scene::SceneParameters &scene,
                                              output::Log                  &log)>;


  /**
   * Repeat a run that has finished, with shorter steps, until Time/Error target is met. Each
   * repetition is a run of its own: it can be resumed, and looks at the target at its end.
   */
  RunStatus meet_error_target(std::unique_ptr<Simulation> simulation,
                              const SimulationMaker      &make,
                              const Processes            &processes,
                              DirectoryLock              &lock,
                              const Interruption         &interruption);


  /**
   * Where a run that has finished does not tell the error of its step, compute the scene once more
   * with twice the step, up to the first failed joint, and tell it from the difference
   * (Time/Error estimate). The results of the run stay as they are; of the second one nothing is
   * left but the error in summary.json. If it is interrupted or fails, a line says so.
   */
  void tell_error_by_second_run(std::unique_ptr<Simulation> simulation,
                                const SimulationMaker      &make,
                                const Processes            &processes,
                                output::Log                &log,
                                const Interruption         &interruption);
} // namespace hybrid
