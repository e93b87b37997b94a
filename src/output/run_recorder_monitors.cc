// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/monitor_summary.h>
#include <hybrid/output/run_recorder.h>

namespace hybrid::output
{
  namespace
  {
    /// Series of a monitor.
    constexpr const char *series_names[] = {"displacement", "velocity", "acceleration"};
    constexpr const char *series_units[] = {"m", "m/s", "m/s2"};
  } // namespace



  void RunRecorder::add_monitors()
  {
    for (const scene::Monitor &m : parts.scene.monitors.monitors)
      {
        MonitorSeries series;
        series.name  = m.name;
        series.probe = probes.add(m.position, m.name);
        for (int k = 0; k < 3; ++k)
          series.series[k] = file.add_series("monitors/" + m.name + "/" + series_names[k],
                                             series_units[k],
                                             2,
                                             "absolute, raw");
        file.set_attribute("monitors/" + m.name,
                           "position",
                           std::vector<double>{m.position.x(), m.position.y()});
        if (m.name == parts.scene.monitors.base_monitor)
          base_monitor = static_cast<int>(monitors.size());
        monitors.push_back(std::move(series));
      }
  }



  void RunRecorder::add_watched_points()
  {
    if (!monitors.empty())
      return;
    watched = watched_points(parts.mesh,
                             parts.blocks,
                             parts.continuum != nullptr || parts.scene.has_bedrock_blocks());
    for (const scene::Monitor &point : watched.points)
      {
        MonitorSeries series;
        series.name  = point.name;
        series.probe = probes.add(point.position, point.name);
        watched_motion.push_back(std::move(series));
      }
  }



  int RunRecorder::base_of_error() const
  {
    return monitors.empty() ? static_cast<int>(watched_motion.size()) * watched.base - 1
                            : base_monitor;
  }



  void RunRecorder::summarize_monitors(Summary &summary)
  {
    MonitorReference reference;
    reference.time = times;
    reference.outcrop_acceleration =
      parts.motion.empty() ? std::vector<double>{} : input_acceleration;
    if (base_monitor >= 0)
      reference.base_displacement = monitors[base_monitor].histories[0];
    reference.filter_frequency   = parts.scene.monitors.filter_frequency;
    reference.first_failure_time = summary.first_failure_time;
    const MonitorSummarizer summarizer(reference);
    summary.filter_frequency          = reference.filter_frequency;
    summary.outcrop_peak_acceleration = summarizer.outcrop_peak();
    for (const MonitorSeries &m : monitors)
      summary.monitors[m.name] =
        summarizer.summarize(m.histories[0], m.histories[1], m.histories[2]);
    if (reference.filter_frequency > 0. && times.size() > 1)
      write_filtered(summarizer);
  }



  void RunRecorder::write_filtered(const MonitorSummarizer &summarizer)
  {
    const std::vector<double> time = summarizer.filtered_time();
    file.write_table("filtered/time", "s", time.data(), time.size(), 1, "equal steps");
    file.set_attribute("filtered",
                       "corner",
                       std::vector<double>{parts.scene.monitors.filter_frequency});
    for (const MonitorSeries &m : monitors)
      for (const int k : {1, 2})
        file.write_table("filtered/monitors/" + m.name + "/" + series_names[k],
                         series_units[k],
                         summarizer.filtered(m.histories[k]).data(),
                         time.size(),
                         2,
                         "absolute, after the zero-phase low-pass");
  }
} // namespace hybrid::output
