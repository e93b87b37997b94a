// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>
#include <hybrid/scene/parameters/parameter_values.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, TimeParameters &time)
  {
    ParameterSection section(table, {"Time"});
    section.number("End time",
                   time.end_time,
                   "s",
                   ParameterRange::at_least(0.),
                   "Duration of the dynamic stage; 0 computes the static state only.");
    section.number(
      "Time step",
      time.time_step,
      "s",
      ParameterRange::above(0.),
      "Size dt of a step. Steps that do not converge are halved. What steps cost in accuracy: doc/accuracy-vs-time.md.");
    section.quantity_or(
      "Error target",
      {"none", time.error_target},
      time.error_target_has_unit,
      {{"%", 1.}},
      {0., 100., false, true},
      "Largest error of the time step, of the displacements and velocities of monitors over their peaks. "
      "A run that ends with a larger probable one is repeated from the beginning with Time step over 2, 4, 8 or 16, as "
      "the estimate says. Where there is no estimate (slip, flight, an end as the motion begins) it is repeated with "
      "half the step until the difference of two runs meets it; none: the run stands.");
    section.choice(
      "Error estimate",
      time.second_run,
      {{"automatic", SecondRun::half_step},
       {"twice the step", SecondRun::twice_the_step},
       {"one run", SecondRun::none}},
      "Where a run that has ended does not tell the error of its step (slip, flight, an end as the motion begins), "
      "automatic computes the scene once more with half the step, up to the first failed joint, and tells it from the "
      "difference: one and a half to two times as much time again. Twice the step takes half as much time again, and "
      "is less sure. With one run, or an Error target, there is no second run.");
    section.number_or(
      "Rest speed",
      {"none", time.rest_speed},
      "m/s",
      ParameterRange::above(0.),
      "The run ends before End time when, after the motion and the rise of loads, no "
      "corner of a block was faster than this for a second.");
    section.integer("Maximum halvings",
                    time.maximum_halvings,
                    {0, 20},
                    "The smallest step is dt / 2^this; a run that needs a smaller one stops.");
    section.choice(
      "Scheme",
      {"automatic", "filtered", "dissipative", "trapezoidal", "fourth order", "shi"},
      "automatic",
      [&time](const std::string &name) { time.scheme = name; },
      "Newmark time integration of blocks and continuum (beta, gamma): dissipative (0.3, 0.6) is of first "
      "order and damps all frequencies, filtered is the same less a tenth of how the acceleration "
      "has changed, and of how the velocity of blocks that touch has: of second order, it damps what "
      "the step cannot resolve, "
      "trapezoidal (0.25, 0.5) damps nothing, shi (0.5, 1) is the constant acceleration of Shi "
      "(1988). Fourth order is trapezoidal with the inertia M - dt^2 K/6 in "
      "place of M, for a continuum alone whose bedding planes, if any, are elastic. Automatic is "
      "fourth order there, and filtered wherever something slides, opens or cracks.");
    section.number(
      "Maximum displacement ratio",
      time.maximum_displacement_ratio,
      "",
      ParameterRange::above(0.),
      "Largest displacement of a block in one step, as a fraction of the block size; a step "
      "that exceeds it is halved.");
    section.number(
      "Dynamic coefficient",
      time.dynamic_coefficient,
      "",
      {0., 1., false, true},
      "Factor k01 on the velocity of the blocks at the start of each step of Time step; a shorter "
      "one, where steps are cut, has its power dt / Time step. 1 is dynamic, a smaller one damps "
      "with the rate (1 - k01) / dt. It brakes absolute velocities: on ground that "
      "moves it drags the mass behind, so use it for masses that come to rest and 1 in earthquakes.");
  }

  void resolve_scheme(SceneParameters &scene, const ParameterTable &table)
  {
    const std::string fourth_order = "fourth order";
    const bool        linear =
      !scene.has_blocks() && (scene.bedding.names.empty() || !scene.bedding.slips);
    TimeParameters   &time = scene.time;
    const std::string name =
      time.scheme != "automatic" ? time.scheme : (linear ? fourth_order : "filtered");
    if (name == fourth_order && !linear)
      throw table.error("Time/Scheme",
                        "is for a continuum alone without planes that slip; allowed here: "
                        "automatic | filtered | dissipative | trapezoidal | shi");
    time.newmark = Newmark::preset(name);
    if (name == fourth_order)
      time.newmark.corrected_step = time.time_step;
  }



  void check(const TimeParameters &time, const ParameterTable &table)
  {
    const double max_steps = 1e9;
    if (time.end_time == 0.)
      return; // the static state only
    if (time.time_step > time.end_time)
      throw table.error("Time/Time step",
                        "must not exceed Time/End time = " + number_text(time.end_time) + " [s]");
    if (time.end_time / time.time_step > max_steps)
      throw table.error("Time/End time",
                        "is more than 1e9 steps of Time/Time step = " +
                          number_text(time.time_step) + " [s]");
  }
} // namespace hybrid::scene
