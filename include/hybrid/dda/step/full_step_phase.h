// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hybrid::dda
{
  /**
   * How long the iterations of a step take full steps, before the line search begins.
   *
   * Whole updates let all contacts change their states at once, and the residual with them: it may
   * rise, and falls at once when the states are right. They are given up after so many, when they
   * lead away (the residual has become a hundred times that of the start), or when they go round in
   * a circle (a residual comes back). A step that begins near balance, where few contacts change,
   * takes none.
   */
  class FullStepPhase
  {
  public:
    /// A step begins. @param max_steps number, 0: none. @param residual [-] at the start
    /// @return go_on()
    bool begin(int max_steps, double residual);

    /// The next update shall be taken as a whole.
    bool go_on() const
    {
      return left > 0;
    }

    /// A full step has led to this residual [-].
    void judge(double residual);

    /// Residual at the start [-].
    double first_residual() const
    {
      return residuals.front();
    }

  private:
    int                 left = 0;
    std::vector<double> residuals; ///< since the step began
  };
} // namespace hybrid::dda
