// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/error_text.h>
#include <hybrid/output/formatted.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    const std::string indent = "\n          ";
    const char *const strikes =
      "; blocks strike each other, runs in other steps may go another way";



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
             (error.blocks_strike ? strikes : "") +
             (std::isnan(error.until) ? "" : "; hybrid accuracy tells of what comes later");
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
        "; at least, as blocks with little damping slide, and may flutter in yet shorter steps "
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



  std::string bedrock_mesh_text(const Summary &summary)
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
} // namespace hybrid::output
