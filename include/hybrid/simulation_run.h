// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/checkpoint.h>
#include <hybrid/clock.h>
#include <hybrid/coupling/coupled_step.h>
#include <hybrid/dda/step/block_solver.h>
#include <hybrid/output/energy_watch.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/output/shared_peaks.h>
#include <hybrid/rest_watch.h>
#include <hybrid/simulation.h>

#include <chrono>
#include <memory>
#include <optional>

namespace hybrid
{
  using SteadyClock = std::chrono::steady_clock;

  inline double seconds_since(const SteadyClock::time_point start)
  {
    return std::chrono::duration<double>(SteadyClock::now() - start).count();
  }


  /// What changes while a scene runs, besides the state of its parts.
  struct Simulation::Run
  {
    Run(Simulation &simulation, output::HistoryFile::Mode mode);

    std::unique_ptr<dda::BlockSolver>      solver; ///< null without blocks
    coupling::CoupledStep                  step;
    Clock                                  clock;
    std::optional<output::RunRecorder>     recorder;        ///< of the first process only
    std::optional<output::BedrockPictures> shared_pictures; ///< of processes that share a bedrock,
                                                            ///< but the first one: its recorder
    std::optional<output::SharedPeaks> shared_peaks;        ///< of all of them
    output::PeakFields                *peaks_of_first = nullptr; ///< the first one's, without those
    output::Summary                    summary; ///< steps, iterations and timings so far
    CheckpointSchedule                 schedule;
    output::EnergyWatch                energy;
    RestWatch                          rest;
    const SteadyClock::time_point      start             = SteadyClock::now();
    double                             earlier_wall_time = 0.; ///< before the run was resumed [s]
    double                             earlier_processor_time = 0.; ///< the same, see Summary [s]

    double wall_time() const
    {
      return earlier_wall_time + seconds_since(start);
    }

    /// Those of a checkpoint.
    void add_shared_peaks(std::vector<restart::SharedVector> &vectors);

    double processor_time() const;

    /// Adds the processor time since the last call to a part of the run: what one of @p name took.
    void count_processor_time(const std::string &name);

    /// The same for the time loop: its first step, in which factors are made, and the others.
    void count_processor_time_of_steps()
    {
      if (summary.steps > 0)
        count_processor_time(summary.steps > 1 ? "steps" : "first_step");
    }

    /// No step follows: what they came to goes to the summary, and the solver's memory is free for
    /// the last output.
    void end_steps();

    double counted_processor_time = 0.; ///< [s]
  };
} // namespace hybrid
