// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/full_step_phase.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  bool FullStepPhase::begin(const int max_steps, const double residual)
  {
    constexpr double near_balance = 1e-3;
    left                          = residual > near_balance ? max_steps : 0;
    residuals.assign(1, residual);
    return go_on();
  }



  void FullStepPhase::judge(const double residual)
  {
    constexpr double max_growth = 100., same = 1e-6;
    const bool       comes_back =
      std::any_of(residuals.begin(), residuals.end(), [&](const double earlier) {
        return std::abs(residual - earlier) <= same * earlier;
      });
    const bool leads_away = !(residual <= max_growth * residuals.front()); // true for NaN
    left                  = comes_back || leads_away ? 0 : left - 1;
    residuals.push_back(residual);
  }
} // namespace hybrid::dda
