// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/step_choice.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace hybrid
{
  namespace
  {
    /// Displacement or velocity, whichever is farther off [-].
    double largest(const output::Summary::ErrorPart &error)
    {
      return std::fmax(error.part[0], error.part[1]); // one of them may be unknown
    }



    /// What an error that meets the target leaves open; nothing if it is known to the end.
    std::string left_open(const output::Summary::ProbableError &error)
    {
      if (std::isnan(error.until))
        return error.may_flutter
                 ? "blocks with little damping slide, and may flutter in yet shorter "
                   "steps (Blocks/Damping ratio)"
                 : "";
      std::ostringstream text;
      text << std::setprecision(3) << "it is met until a joint failed at " << error.until
           << " s, and what follows is not known";
      return text.str();
    }
  } // namespace



  StepChoice choose_step(const output::Summary::ProbableError &error,
                         const double                          time_step,
                         const double                          target)
  {
    constexpr int    most_halvings = 4;
    constexpr double second_order  = 0.25;
    if (!error.reason.empty() && error.runs_would_do)
      return {"", 0.5 * time_step, "two runs tell the error that one does not"};
    if (!error.reason.empty())
      return {"the error is not estimated, " + error.reason, {}, ""};
    const double now = largest(error.step), half = largest(error.half_step);
    if (now <= target)
      return {left_open(error), {}, ""};
    if (error.parts > 1) // only a step that is shorter than a part changes the error
      {
        int to_one_part = 1;
        while ((1 << to_one_part) <= error.parts)
          ++to_one_part;
        return {"",
                std::ldexp(time_step, -to_one_part),
                "the error of its stable parts is above Time/Error target"};
      }
    if (!(half < now))
      return {
        std::isnan(error.measured_from)
          ? "half the step would not be nearer to it"
          : "the runs do not come closer to each other, so shorter steps are not known to help",
        {},
        ""};
    const std::string why = "the error of longer ones is above Time/Error target";
    if (!std::isnan(error.measured_from))
      return {"", 0.5 * time_step, why}; // its difference to this one tells the order
    const double gain     = std::max(second_order, half / now);
    int          halvings = 1;
    for (double left = half; left > target && halvings < most_halvings; left *= gain)
      ++halvings;
    return {"", std::ldexp(time_step, -halvings), why};
  }
} // namespace hybrid
