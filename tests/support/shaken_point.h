// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/step_record.h>

#include <cmath>

namespace hybrid::output
{
  /// A run of 2 s in steps of @p step in which "point" moves by sin(2 pi t) (1 + error) relative
  /// to "base", and along.
  inline StepRecord run_with(const double step, const double error)
  {
    StepRecord record;
    record.step     = step;
    record.corner   = 25.;
    record.base     = 1;
    record.monitors = {{"point", {}}, {"base", {}}};
    for (int i = 1; i * step < 2. + 1e-9; ++i)
      {
        const double t = i * step, w = 2. * M_PI, base = 0.3 * std::sin(5. * t);
        const double motion[] = {std::sin(w * t), w * std::cos(w * t), -w * w * std::sin(w * t)};
        record.time.push_back(t);
        for (int q = 0; q < 3; ++q)
          for (auto [monitor, x] : {std::make_pair(0, (1. + error) * motion[q]), {1, 0.}})
            {
              auto &history = record.monitors[monitor].histories[q];
              history.insert(history.end(), {x + (q == 0 ? base : 0.), 0.});
            }
      }
    return record;
  }
} // namespace hybrid::output
