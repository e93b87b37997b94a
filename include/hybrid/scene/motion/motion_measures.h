// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

namespace hybrid::scene
{
  /// What engineers ask of a motion.
  struct MotionMeasures
  {
    double peak_acceleration    = 0.; ///< [m/s2]
    double peak_velocity        = 0.; ///< [m/s]
    double significant_duration = 0.; ///< in which 5 to 95 % of the Arias intensity come [s]
    double spectral_peak        = 0.; ///< largest pseudo-acceleration, 5 % damping [m/s2]
    double spectral_period      = 0.; ///< where it is [s]

    /// PGV over PGA: long for far or great earthquakes [s]; 0 without a motion.
    double velocity_over_acceleration() const
    {
      return peak_acceleration > 0. ? peak_velocity / peak_acceleration : 0.;
    }
  };


  /// Periods from 0.02 to 10 s are looked at for the spectral peak.
  MotionMeasures measure(const Motion &motion);
} // namespace hybrid::scene
