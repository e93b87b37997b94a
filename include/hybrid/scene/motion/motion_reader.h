// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

#include <string>

namespace hybrid::scene
{
  /// Read a record of two columns, time [s] and acceleration in @p unit [m/s2]; the first sample is
  /// put at t = 0. @param first_time the time of its first row [s]
  Motion read_text_motion(const std::string &file, double unit, double *first_time = nullptr);


  /**
   * Read a PEER record: header lines up to one with the number of points and the time step
   * ("NPTS= 6557, dt= .00244", "NPTS=  2000, DT= .02000 SEC", "6557 .00244 NPTS, DT"), then
   * the accelerations, any number per line. 1 g = 9.80665 m/s2.
   */
  Motion read_at2_motion(const std::string &file);
} // namespace hybrid::scene
