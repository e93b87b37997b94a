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
   * repetition is a run of its own: it can be resumed, and looks at the target at its end. Its
   * card is in its log.txt only.
   *
   * @param log of the run that has finished: warnings that it has said are not said again
   */
  RunStatus meet_error_target(std::unique_ptr<Simulation> simulation,
                              const SimulationMaker      &make,
                              const Processes            &processes,
                              output::Log                &log,
                              DirectoryLock              &lock,
                              const Interruption         &interruption);


  /**
   * Tell what one run does not tell of its errors. The results of the run stay as they are; of the
   * others nothing is left but the errors in summary.json.
   *
   * - Where slip, flight, cracks or the first of a wave decide, the error of the step: the scene
   *   once more with half or twice the step (Time/Error estimate).
   * - Where the mesh can be made coarser, that of the mesh: with it twice and four times as coarse
   *   (Mesh/Error estimate). Where these keep the cells at inward corners of the bedrock, once more
   *   with smaller ones there.
   *
   * Each goes up to the first failed joint. One that is interrupted or fails is told, and does no
   * harm.
   */
  void tell_errors_by_further_runs(std::unique_ptr<Simulation> simulation,
                                   const SimulationMaker      &make,
                                   const Processes            &processes,
                                   output::Log                &log,
                                   const Interruption         &interruption);
} // namespace hybrid
