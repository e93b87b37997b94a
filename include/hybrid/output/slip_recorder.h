// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/history_file.h>
#include <hybrid/output/sole_slip.h>
#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /// Slip on the sliding surface in run.h5 and in the summary; a run without soles has none.
  class SlipRecorder
  {
  public:
    /// @param blocks may be nullptr.  @param downhill sign of x downhill, 0: level.
    SlipRecorder(const dda::Model *blocks, const double downhill)
      : slip(blocks, downhill)
    {}

    void add_series(HistoryFile &file);

    /// Slip counts from @p state.
    void set_reference(const dda::DdaState &state)
    {
      slip.set_reference(state);
    }

    /// Mean and largest slip, every step.
    void record(const dda::DdaState &state, HistoryFile &file);

    /// Slip of every sole at @p time [s].
    void record_profile(const dda::DdaState &state, double time, HistoryFile &file) const;

    void finish(const dda::DdaState &state, Summary &summary) const;

    /// Reference and the largest values so far, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    SoleSlip slip;
    int      mean_series = -1, largest_series = -1, time_series = -1, profile_series = -1;
    double   largest_mean = 0., largest = 0.; ///< so far, with their signs [m]
    Vec2     where = Vec2::Zero();            ///< the largest, as drawn [m]
  };
} // namespace hybrid::output
