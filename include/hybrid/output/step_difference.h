// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/step_record.h>
#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /**
   * Largest difference of two runs of one scene at any time, over the peak of the same monitor in
   * the run in @p shorter steps.
   *
   * Displacements (relative to the base), velocities and accelerations of all monitors that both
   * have, after the low-pass that peaks are taken after, until the first of the two ends, or a step
   * before its first joint fails. Monitors that move less than the least_motion of a record are
   * left out. Accelerations near the ends of a record, where the low-pass has nothing to
   * look at, are left out: filter_reach().
   */
  Summary::ErrorPart step_difference(const StepRecord &longer, const StepRecord &shorter);

  /**
   * The error of the run in @p shorter steps from its difference d to the one in longer steps:
   * d / (r^p - 1), with r the ratio of the steps and p the order (Richardson 1911).
   *
   * p is error.assumed_order, 1.45 as a rule, for which d is divided by sqrt(3) where r is 2: what
   * is of first order is underestimated by that, what is of second overestimated. p is less, down
   * to 1, if the difference to a third run says so: differences that fall more slowly do so by
   * chance, as slip and contacts begin within steps, and p below 1 told three to ten times too
   * much. If the differences fall by less than a factor of r^(1/4) the runs do not converge: d
   * tells how far they scatter, and half the step would leave as much.
   *
   * @param shorter its difference is set.
   */
  void measure_error(const StepRecord &longer, StepRecord &shorter, Summary::ProbableError &error);

  /**
   * The error of a @p run from its difference d to the one in @p shorter steps: d r^p / (r^p - 1),
   * and d / (r^p - 1) of what half the step leaves, with r the ratio of the steps and p
   * error.assumed_order. With r = 2 the order hardly matters: 2 d of first, 4 d / 3 of second.
   */
  void measure_error_by_shorter_steps(const StepRecord       &run,
                                      const StepRecord       &shorter,
                                      Summary::ProbableError &error);
} // namespace hybrid::output
