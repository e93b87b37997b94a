// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/history_file.h>
#include <hybrid/output/sole_slip.h>
#include <hybrid/output/summary.h>

#include <limits>
#include <string>

namespace hybrid::output
{
  /// Slip on the sliding surface and the force on it, in run.h5 and in the summary; a run without
  /// soles has none.
  class SlipRecorder
  {
  public:
    /// @param blocks may be nullptr.  @param threshold what slides farther has slipped [m].
    SlipRecorder(const dda::Model *blocks, double threshold);

    void add_series(HistoryFile &file);

    /// Slip counts from @p state.
    void set_reference(const dda::DdaState &state, HistoryFile &file);

    /// Slip and force, every step.
    void record(const dda::DdaState &state, HistoryFile &file);

    /// Slip of every sole at @p time [s].
    void record_profile(const dda::DdaState &state, double time, HistoryFile &file) const;

    /// The table of the farthest slips, and the summary.
    void finish(const dda::DdaState &state, HistoryFile &file, Summary &summary) const;

    /// Of each block: the largest size of the slip of its soles so far; 0 without soles [m].
    std::vector<double> largest_of_blocks() const;

    /// Reference and the largest values so far, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    const dda::Model *model;
    const bool        is_level; ///< downhill is nowhere
    const double      threshold;
    SoleSlip          slip;
    int               mean_series = -1, largest_series = -1, part_series = -1, time_series = -1,
        profile_series  = -1;
    int    force_series = -1, shear_series = -1, normal_series = -1, strength_series = -1;
    double largest_mean = 0., largest = 0.;     ///< so far, with their signs [m]
    Vec2   where = Vec2::Zero();                ///< the largest, as drawn [m]
    std::vector<double> farthest;               ///< of each sole, the size of its slip so far [m]
    double              largest_shear     = 0.; ///< so far, with its sign [N/m]
    double              mobilised_at_rest = MonitorSummary::unknown; ///< downhill [-]
    double              largest_mobilised = -std::numeric_limits<double>::infinity(); ///< the same

    /// Shear over strength, downhill positive; on level ground its size [-].
    double mobilised(const dda::SurfaceForce &force) const;

    /// See Summary::Slip.
    std::string downhill_words() const;
  };
} // namespace hybrid::output
