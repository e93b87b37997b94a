// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/slip_recorder.h>
#include <hybrid/restart/archive.h>

#include <cmath>

namespace hybrid::output
{
  void SlipRecorder::add_series(HistoryFile &file)
  {
    const std::size_t n = slip.n_soles();
    if (n == 0)
      return;
    std::vector<double> position, length;
    for (int k = 0; k < slip.n_soles(); ++k)
      {
        position.insert(position.end(), {slip.position(k).x(), slip.position(k).y()});
        length.push_back(slip.length(k));
      }
    file.write_table("slip/position", "m", position.data(), n, 2, "middle of each sole, initial");
    file.write_table("slip/length", "m", length.data(), n, 1, "of each sole");
    mean_series    = file.add_series("slip/mean", "m", 1, "of all soles, downhill positive");
    largest_series = file.add_series("slip/largest", "m", 1, "of the sole that has slid farthest");
    time_series    = file.add_series("slip/time", "s", 1, "times of the pictures");
    profile_series = file.add_series("slip/profile", "m", n, "of each sole");
  }



  void SlipRecorder::record(const dda::DdaState &state, HistoryFile &file)
  {
    if (slip.n_soles() == 0)
      return;
    const std::vector<double> now      = slip.values(state);
    const int                 farthest = SoleSlip::farthest(now);
    const double              mean     = slip.mean(now);
    file.append(mean_series, &mean);
    file.append(largest_series, &now[farthest]);
    if (std::abs(mean) > std::abs(largest_mean))
      largest_mean = mean;
    if (std::abs(now[farthest]) > std::abs(largest))
      {
        largest = now[farthest];
        where   = slip.position(farthest);
      }
  }



  void SlipRecorder::record_profile(const dda::DdaState &state,
                                    const double         time,
                                    HistoryFile         &file) const
  {
    if (slip.n_soles() == 0)
      return;
    file.append(time_series, &time);
    file.append(profile_series, slip.values(state).data());
  }



  void SlipRecorder::finish(const dda::DdaState &state, Summary &summary) const
  {
    if (slip.n_soles() == 0)
      return;
    const std::vector<double> now = slip.values(state);
    summary.slip.mean             = largest_mean;
    summary.slip.largest          = largest;
    summary.slip.where            = {{where.x(), where.y()}};
    summary.slip.mean_left        = slip.mean(now);
    summary.slip.largest_left     = now[SoleSlip::farthest(now)];
  }



  void SlipRecorder::serialize(restart::Archive &archive)
  {
    archive(slip, largest_mean, largest, where);
  }
} // namespace hybrid::output
