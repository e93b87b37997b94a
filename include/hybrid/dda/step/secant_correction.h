// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /**
   * What a kept tangent is wrong by, from one secant (Broyden 1965).
   *
   * The kept tangent K knows the directions of the time when it was made. An update s with it
   * leaves a residual r, and the next update w = K^-1 r makes up for that. So
   *
   *     K - r s^T W / (s^T W s)
   *
   * has the secant of the first update, and by Sherman and Morrison its solution is that of K plus
   *
   *     w (s^T W u) / (s^T W s - s^T W w),     u = K^-1 b:
   *
   * two scalar products, no other solution. While a mass vibrates its updates are alike from step
   * to step, and so is what they leave. W: squares of the blocks' sizes for rotation and strains.
   */
  class SecantCorrection
  {
  public:
    /// Another tangent: forget.
    void reset()
    {
      is_known = false;
    }

    /// Correct an update with the tangent. @param scale sizes, as of residuals
    void correct(const Eigen::VectorXd &scale, Eigen::VectorXd &update);

    /// An update, corrected or not, that did not settle the step.
    void first(const Eigen::VectorXd &update);

    /// What the tangent makes of the residual that is left.
    void second(const Eigen::VectorXd &update);

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    bool            is_known = false;
    double          applied  = 0.; ///< part of w in the last update
    Eigen::VectorXd direction;     ///< s
    Eigen::VectorXd remedy;        ///< w
  };
} // namespace hybrid::dda
