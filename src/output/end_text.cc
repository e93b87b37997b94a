// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/end_text.h>
#include <hybrid/output/error_text.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/overlap_watch.h>
#include <hybrid/output/progress.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hybrid::output
{
  namespace
  {
    constexpr std::size_t most_monitors = 4;
    constexpr double      g             = 9.80665; ///< [m/s2]
    const std::string     indent        = "\n          ";

    using NamedMonitor = std::pair<const std::string, MonitorSummary>;



    /// 3 digits, in millimetres below one metre.
    std::string length_text(const double value)
    {
      const double rounded = std::abs(value) < 1e-8 ? 0. : value;
      return std::abs(value) < 1. ? formatted("%.3g mm", 1e3 * rounded)
                                  : formatted("%.3g m", value);
    }



    double size(const MonitorSummary::Pair &pair)
    {
      return std::fmax(std::abs(pair[0]), std::abs(pair[1]));
    }



    /// The component that is larger.
    int larger(const MonitorSummary::Pair &pair)
    {
      return std::abs(pair[1]) > std::abs(pair[0]) ? 1 : 0;
    }



    /// Those that shook most, in the order of their names; the base is what others refer to.
    std::vector<const NamedMonitor *> told_monitors(const Summary &summary, const std::string &base)
    {
      std::vector<const NamedMonitor *> told;
      for (const NamedMonitor &monitor : summary.monitors)
        if (monitor.first != base && std::isfinite(size(monitor.second.peak_displacement)))
          told.push_back(&monitor);
      const auto shook = [](const NamedMonitor *m) { return size(m->second.peak_acceleration); };
      std::stable_sort(told.begin(), told.end(), [&](const NamedMonitor *a, const NamedMonitor *b) {
        return shook(a) > shook(b);
      });
      told.resize(std::min(told.size(), most_monitors));
      std::sort(told.begin(), told.end(), [](const NamedMonitor *a, const NamedMonitor *b) {
        return a->first < b->first;
      });
      return told;
    }



    /// The larger components. Displacements have the sign of their axis.
    std::string monitor_text(const MonitorSummary &monitor)
    {
      const char *const axes[] = {" along x", " along y"};
      const int   u = larger(monitor.peak_displacement), a = larger(monitor.peak_acceleration);
      std::string text =
        "peak " + length_text(monitor.peak_displacement[u]) + axes[u] + ", " +
        length_text(monitor.final_displacement[u]) + " at the end" +
        formatted(", peak acceleration %.2g g", std::abs(monitor.peak_acceleration[a]) / g) +
        axes[a];
      if (std::isfinite(monitor.amplification[a]))
        text += formatted(" = %.3g x outcrop", monitor.amplification[a]);
      return text;
    }



    std::string monitors_text(const Summary &summary, const std::string &base)
    {
      const std::vector<const NamedMonitor *> told  = told_monitors(summary, base);
      std::size_t                             width = 0, moving = 0;
      for (const NamedMonitor *monitor : told)
        width = std::max(width, monitor->first.size());
      std::string text;
      for (const NamedMonitor *monitor : told)
        text += indent + monitor->first + std::string(width - monitor->first.size() + 2, ' ') +
                monitor_text(monitor->second);
      for (const NamedMonitor &monitor : summary.monitors)
        moving += monitor.first != base ? 1 : 0;
      if (moving > told.size() && !told.empty())
        text +=
          indent + formatted("%zu more monitors shook less: summary.json", moving - told.size());
      return text;
    }



    std::string joints_text(const Summary::FailedJoints &failed)
    {
      const long all = failed.tensile + failed.shear;
      if (all == 0)
        return "no joint failed";
      return formatted("%ld joint%s failed (%ld tensile, %ld shear)",
                       all,
                       all == 1 ? "" : "s",
                       failed.tensile,
                       failed.shear);
    }



    std::string off_surface_text(const int blocks)
    {
      return blocks == 0
               ? ""
               : indent +
                   formatted("%d %s the surface no more at the end: how far %s counts as slip",
                             blocks,
                             blocks == 1 ? "block touches" : "blocks touch",
                             blocks == 1 ? "it has moved" : "they have moved");
    }



    std::string slip_text(const Summary &summary)
    {
      const Summary::Slip &slip = summary.slip;
      if (std::isnan(slip.mean_left))
        return joints_text(summary.joints);
      return "slip on the sliding surface: " + length_text(slip.mean_left) + " left (largest " +
             length_text(slip.largest_left) +
             formatted("), %.3g %% of it slipped by more than ", 100. * slip.part) +
             length_text(slip.threshold) + "; " + joints_text(summary.joints) +
             (slip.downhill == "both ways" ? indent + "slides lie on both flanks: the slip of each "
                                                      "is positive its own way downhill"
                                           : "") +
             off_surface_text(slip.off_surface);
    }



    /// Slip leaves a change of stress for good, to which dashpots alone give way.
    bool gives_way_to_lasting_load(const scene::SceneParameters &scene)
    {
      return scene.has_continuum() && scene.continuum.base.is_compliant &&
             !scene.continuum.boundary_springs;
    }



    /// A line that has slipped or opened by more than @p seen [m]; else nothing.
    std::string
    line_text(const std::string &name, const Summary::PlaneSlip &slip, const double seen)
    {
      const bool slips = std::abs(slip.largest_left) > seen, opens = slip.opening_left > seen;
      if (!slips && !opens)
        return "";
      std::string text = indent + name + "  ";
      if (slips)
        text += "has slipped by " + length_text(std::abs(slip.largest_left)) + " at most, at " +
                formatted("(%.4g, %.4g) m", slip.where[0], slip.where[1]);
      if (opens)
        text += (slips ? "; it is open by " : "is open by ") + length_text(slip.opening_left) +
                " at most";
      return text;
    }



    /// Bedding planes, and joint lines of the mass, that have slipped or opened.
    std::string lines_text(const Summary &summary, const scene::SceneParameters &scene)
    {
      constexpr double seen         = 1e-6; // m, of planes: elastic parts are not in it
      bool             slip_is_left = false;
      std::string      text;
      for (const auto &[name, slip] : summary.joint_lines)
        text += line_text(name, slip, scene.output.slip_threshold);
      for (const auto &[name, slip] : summary.planes)
        {
          text += line_text(name, slip, seen);
          slip_is_left = slip_is_left || std::abs(slip.largest_left) > seen;
        }
      if (slip_is_left && gives_way_to_lasting_load(scene))
        text +=
          indent +
          "dashpots give way to the stress that slip leaves, so what is left drifts: "
          "Continuum/Boundary springs = true, and several times as much rock around the planes";
      return text;
    }



    /// A level of the water that follows a table.
    std::string changed_water_text(const scene::SceneParameters &scene)
    {
      if (scene.environment.water_tables.level_file.empty() || !gives_way_to_lasting_load(scene))
        return "";
      return indent + "dashpots give way to the load that the level of the water changes for good, "
                      "so the ground drifts: Continuum/Boundary springs = true";
    }



    std::string off_base_text(const int blocks)
    {
      return blocks == 0
               ? ""
               : indent + formatted("%d %s beyond the end of the base, where nothing is below",
                                    blocks,
                                    blocks == 1 ? "block is" : "blocks are");
    }



    std::string deep_overlap_text(const Summary::DeepestOverlap &seen)
    {
      return seen.of.part <= OverlapWatch::warned ? ""
                                                  : indent + "overlap: " + overlap_text(seen.of) +
                                                      formatted(", at t = %.4g s", seen.time);
    }



    std::string shear_text(const Summary::BaseShear &base)
    {
      constexpr double round_off = 1e-6;
      const auto       percent   = [](const double share) {
        return formatted("%.3g %%", std::abs(share) < round_off ? 0. : 100. * share);
      };
      if (std::isnan(base.mobilised_left))
        return "";
      const std::string most = "at most " + percent(base.mobilised);
      return indent + "shear strength of the sliding surface: " +
             (std::isnan(base.mobilised_at_rest)
                ? most + " mobilised"
                : percent(base.mobilised_at_rest) + " mobilised at rest, " + most) +
             ", at the end " + percent(base.mobilised_left);
    }
  } // namespace



  EndText end_text(const Summary &summary, const scene::SceneParameters &scene)
  {
    const std::string reached =
      summary.finished
        ? formatted("Finished  %.4g s", summary.simulated_time)
        : formatted("Stopped   at %.4g s of %.4g s", summary.simulated_time, scene.time.end_time);
    std::string found = formatted(", %ld steps, %ld cuts, energy residual %.1e",
                                  summary.steps,
                                  summary.wasted.cuts,
                                  summary.energy_residual);
    if (summary.steps > 0)
      {
        found += monitors_text(summary, scene.monitors.base_monitor) + lines_text(summary, scene);
        if (summary.blocks > 0) // water acts on the ground below these alone
          found += changed_water_text(scene) + indent + slip_text(summary) +
                   shear_text(summary.base_shear) + off_base_text(summary.blocks_off_base) +
                   deep_overlap_text(summary.deepest_overlap);
      }
    const std::string &place = scene.output.directory;
    const std::string  mesh  = bedrock_mesh_text(summary);
    EndText            error = error_text(summary);
    for (std::string *text : {&error.on_screen, &error.in_file})
      if (!text->empty())
        text->insert(0, "\n");
    return {reached + " in " + format_duration(summary.wall_time) + found + error.on_screen + mesh +
              block_mesh_text(summary, place) + "\nResults   " + place + "   next: hybrid plot " +
              place,
            reached + found + error.in_file + mesh};
  }
} // namespace hybrid::output
