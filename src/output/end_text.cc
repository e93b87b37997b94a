// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/end_text.h>
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
    const char *const     strikes =
      "; blocks strike each other, runs in other steps may go another way";

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
    bool gives_way_to_slip(const scene::SceneParameters &scene)
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
      if (slip_is_left && gives_way_to_slip(scene))
        text +=
          indent +
          "dashpots give way to the stress that slip leaves, so what is left drifts: "
          "Continuum/Boundary springs = true, and several times as much rock around the planes";
      return text;
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



    /// 0.42, 12, over 100: percent without the sign. Tolerances and the steps that slip begins in
    /// leave some hundredths, of which no difference tells more.
    std::string percent(const double part)
    {
      if (!(part < 0.995))
        return std::isnan(part) ? "-" : "over 100";
      return part < 5e-4 ? "below 0.05" : formatted("%.2g", 100. * part);
    }



    /// displacement 0.42 % of its peak (crest), velocity 1 % (toe), ...
    std::string peaks_text(const Summary::ErrorPart &error)
    {
      const char *names[] = {"displacement", "velocity", "acceleration"};
      std::string text;
      for (int q = 0; q < 3; ++q)
        if (!std::isnan(error.part[q]))
          text += (text.empty() ? "" : ", ") + std::string(names[q]) + " " +
                  percent(error.part[q]) + " %" + (text.empty() ? " of the peak" : "") + " (" +
                  error.where[q] + ")";
      if (!std::isnan(error.slip_left))
        text += ", slip left " + percent(error.slip_left) + " % (mean)";
      return text;
    }



    /// Up to where an error is known.
    std::string until_text(const double until, const bool failed_in_other)
    {
      if (std::isnan(until))
        return "";
      const char *where = failed_in_other ? "in the other run " : "";
      return formatted(", until a joint failed %sat %.4g s", where, until);
    }



    /// When a joint failed in the other of two runs: how well that time is known.
    std::string later_text(const Summary::ProbableError &error)
    {
      if (std::isnan(error.until + error.measured_from) || error.until_later == error.until)
        return "";
      const double      at  = error.until_later;
      const std::string run = error.failed_in_other ? " in this one)" : " in the other run)";
      return " (" + (std::isnan(at) ? "not yet" : formatted("at %.4g s", at)) + run;
    }



    /// Equal, or both not told.
    bool is_as_much(const Summary::ErrorPart &error, const Summary::ErrorPart &half)
    {
      return std::equal(error.part.begin(),
                        error.part.end(),
                        half.part.begin(),
                        [](const double a, const double b) {
                          return a == b || (std::isnan(a) && std::isnan(b));
                        });
    }



    /// What would be left: as much by runs that do not converge, and by an explicit step whose
    /// parts stay as they are.
    std::string half_text(const Summary::ErrorPart &error,
                          const Summary::ErrorPart &half,
                          const std::string        &what,
                          const std::string        &if_as_much)
    {
      if (is_as_much(error, half)) // slip may scatter alone
        return "; " + if_as_much;
      std::string text;
      for (const double part : {half.part[0], half.part[1], half.part[2], half.slip_left})
        if (!std::isnan(part))
          text += (text.empty() ? " " : ", ") + percent(part);
      return "; with half the " + what + text + " %";
    }



    /// The error of a step that one run does not tell.
    std::string who_finds_it(const Summary &summary)
    {
      if (!summary.probable_error.runs_would_do)
        return "";
      if (summary.probable_error.second_step > 0.)
        return formatted("; the scene once more in steps of %.4g s tells it, below",
                         summary.probable_error.second_step);
      return summary.blocks == 0 ? "; Time/Error target finds it by runs in shorter steps"
                                 : "; hybrid accuracy tells it from a run with twice the step, "
                                   "Time/Error target from runs with shorter ones";
    }



    /// Points whose error can be told.
    bool has_points(const Summary &summary)
    {
      return !summary.monitors.empty() || !summary.probable_error.watched.empty();
    }



    /// What finer steps would change; nothing if nothing was watched.
    std::string step_error_text(const Summary &summary)
    {
      const Summary::ProbableError &error = summary.probable_error;
      if (!has_points(summary))
        return "";
      const std::string begin =
        std::string("Error     of the time step") +
        (error.watched.empty() ? "" : " at " + error.watched + ", as there are no monitors");
      if (!error.reason.empty())
        return begin + ": not estimated, " + error.reason + who_finds_it(summary);
      const bool        is_own  = std::isnan(error.measured_from); // told by this run
      const std::string as_much = is_own || error.blocks_strike
                                    ? "half the step leaves as much"
                                    : "the runs do not come closer to each other, this is how far "
                                      "they scatter";
      const std::string source =
        is_own ? "probably" : formatted("by the run in steps of %.4g s", error.measured_from);
      return begin + ", " + source + until_text(error.until, error.failed_in_other) +
             later_text(error) + ": " + peaks_text(error.step) +
             half_text(error.step, error.left_by_half(), "step", as_much) +
             (error.blocks_strike ? strikes : "");
    }



    /// What a finer mesh of the bedrock would change; nothing if runs with coarser ones tell it.
    std::string mesh_text(const Summary &summary)
    {
      const Summary::ProbableError &error = summary.probable_error;
      if (!has_points(summary) || !error.reason.empty() || std::isnan(error.mesh.part[1]) ||
          summary.mesh_error.follows)
        return "";
      return indent + "of the bedrock's mesh, waves alone, at least: " + peaks_text(error.mesh) +
             (error.mesh_has_corners
                ? "; what its corners and bends leave is not in it, and may be ten times as much"
                : "");
    }



    /// Who finds the error of a mesh of blocks, which one run does not tell.
    std::string block_mesh_text(const Summary &summary, const std::string &directory)
    {
      if (summary.mesh_error.follows)
        return indent + "of the mesh: the scene with coarser ones tells it, below";
      if (summary.blocks == 0 || !has_points(summary) || !summary.finished)
        return "";
      if (!summary.mesh_error.never.empty())
        return indent + "of the mesh: not told, " + summary.mesh_error.never;
      if (!summary.mesh_error.runs_would_do)
        return "";
      return indent + "of the mesh of blocks: hybrid accuracy " + directory +
             " finds it by coarser runs";
    }



    /// What half the step costs.
    std::string cost_text(const Summary::ProbableError &error)
    {
      if (!error.reason.empty() || !std::isfinite(error.cost) ||
          is_as_much(error.step, error.left_by_half()))
        return "";
      return " for at most " +
             formatted(error.cost < 100. ? "%.2g s" : "%.0f s", std::max(error.cost, 0.1)) +
             " more of processor time";
    }



    /// What the error leaves out.
    std::string left_out_text(const Summary::ProbableError &error)
    {
      if (!error.reason.empty())
        return "";
      const std::string flutters =
        "; at least, as blocks without damping slide, and may flutter in yet shorter steps "
        "(Blocks/Damping ratio)";
      return (error.may_flutter ? flutters : "") +
             (error.peak_at_end.empty()
                ? ""
                : "; the acceleration of " + error.peak_at_end +
                    " is largest at an end of the record, where nothing is filtered nor told");
    }
  } // namespace



  EndText error_text(const Summary &summary)
  {
    const std::string text = step_error_text(summary);
    if (text.empty())
      return {};
    const Summary::ProbableError &error = summary.probable_error;
    return {text + cost_text(error) + left_out_text(error), text + left_out_text(error)};
  }



  EndText mesh_error_text(const Summary::MeshError &error)
  {
    const std::string begin = "Error     of the mesh";
    if (!error.reason.empty())
      return {begin + ": not known, " + error.reason, begin + ": not known, " + error.reason};
    const std::string text =
      begin + ", by " +
      (error.meshes > 1 ? "those twice and four times as large" : "one twice as large") +
      (error.of_corners ? " and smaller cells at inward corners" : "") +
      until_text(error.until, error.failed_in_other) + ": " + peaks_text(error.size) +
      half_text(error.size,
                error.half_size,
                error.with_step ? "size and half the step" : "size",
                "half the size leaves as much");
    const std::string note =
      std::string(error.order_is_seen ? "" : ", roughly: no order is seen in these meshes") +
      (error.keeps_corners && !error.of_corners
         ? "; at least, as cells at inward corners are as large in all of them (Mesh/Corner levels)"
         : "") +
      (error.keeps_layers
         ? "; at least, as the coarser ones have cells as thick in a part of the rock (a layer of one cell)"
         : "");
    const std::string cost = std::isfinite(error.cost) && error.size.part != error.half_size.part
                               ? " in at least " +
                                   formatted(error.cost < 100. ? "%.2g s" : "%.0f s", error.cost) +
                                   " of processor time"
                               : "";
    return {text + cost + note, text + note};
  }



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
        if (summary.blocks > 0)
          found += indent + slip_text(summary) + shear_text(summary.base_shear) +
                   off_base_text(summary.blocks_off_base) +
                   deep_overlap_text(summary.deepest_overlap);
      }
    const std::string &place = scene.output.directory;
    const std::string  mesh  = mesh_text(summary);
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
