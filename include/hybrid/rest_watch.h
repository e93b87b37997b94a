// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

namespace hybrid
{
  /// Tells when a mass has come to rest: no corner of a block was faster than a speed for a
  /// second.
  class RestWatch
  {
  public:
    /// @param speed [m/s]; 0: never.  @param earliest when shaking has ended [s].
    RestWatch(double speed, double earliest);

    /// After each step. @param fastest largest speed of a block [m/s].
    void look(double time, double fastest);

    bool is_on() const
    {
      return speed > 0.;
    }

    bool is_at_rest() const
    {
      return resting;
    }

    /// For the checkpoint. What has come to rest is looked at anew after a resume.
    void serialize(restart::Archive &archive);

  private:
    static constexpr double waiting_time = 1.; ///< [s]

    const double speed, earliest;
    double       still_since = 0.; ///< [s]
    bool         resting     = false;
  };
} // namespace hybrid
