// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/run_recorder.h>
#include <hybrid/restart/archive.h>
#include <hybrid/restart/durable_file.h>

#include <cstdio>

namespace hybrid::output
{
  void RunRecorder::serialize(restart::Archive &archive)
  {
    archive(file,
            pictures,
            probes,
            ledger,
            slip,
            joint_lines,
            lines,
            peaks,
            reference_centroids,
            peak_displacement);
    archive(overlaps);
    archive(next_picture, next_audit, last_picture, last_audit);
    for (MonitorSeries &point : watched_motion)
      for (std::vector<double> &history : point.histories)
        archive(history);
    if (!archive.is_reading())
      return;
    read_histories();
    // What was written at an earlier end is no result of the run that goes on.
    for (const char *table : {"fields",
                              "joints",
                              "filtered",
                              "slip/farthest",
                              "section/blocks_points_final",
                              "section/blocks_plastic_strain",
                              "section/blocks_displacement",
                              "section/blocks_peak_displacement"})
      file.remove(table);
    for (const char *picture : {"/peaks.vtu", "/peaks_blocks.vtu"})
      std::remove((parts.scene.output.directory + picture).c_str());
  }



  void RunRecorder::make_room_for_peaks()
  {
    const std::size_t nodes = parts.continuum->n_unknowns() / 2;
    PeakFields::declare_nodes(file, nodes, parts.continuum->n_cells());
    file.close_into(restart::temporary_name(parts.scene.output.directory + "/run.h5"));
  }



  void RunRecorder::read_histories()
  {
    times              = file.read(time_series);
    input_acceleration = file.read(input_series[0]);
    for (MonitorSeries &monitor : monitors)
      for (int k = 0; k < 3; ++k)
        monitor.histories[k] = file.read(monitor.series[k]);
  }
} // namespace hybrid::output
