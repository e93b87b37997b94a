// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion.h>
#include <hybrid/scene/scene_parameters.h>

#include <string>

namespace hybrid::scene
{
  /**
   * The motion that a scene asks for, its first sample at t = 0 (the start time is the caller's).
   *
   * none       an empty motion.
   * ricker     a(t) = A (1 - 2 s^2) exp(-s^2), s = pi f (t - t0), t0 = 1.5/f: starts and ends below
   * 1e-7 A. Its velocity is A (t - t0) exp(-s^2), its displacement -A exp(-s^2) / (2 pi^2 f^2).
   * synthetic  see make_synthetic_motion().
   * text       two columns t [s], a [file_unit m/s2], equally spaced.
   * at2        PEER AT2; in units of g unless the header names cm/s2 or m/s2.
   *
   * A peak >= 0 scales the motion to exactly this largest |a| [m/s2]; without one, ricker and
   * synthetic have 1 m/s2 and records stay as they are.
   *
   * @param time_step dt of the run [s]; a Ricker wavelet is sampled at an integer fraction of it.
   * @throws InputError with file and line for a file that cannot be understood.
   */
  Motion make_motion(const MotionParameters &parameters, double time_step);


  /// Read a record of two columns, time [s] and acceleration in @p unit [m/s2]; the first sample is
  /// put at t = 0.
  Motion read_text_motion(const std::string &file, double unit);


  /**
   * Read a PEER record: header lines up to one with the number of points and the time step
   * ("NPTS= 6557, dt= .00244", "NPTS=  2000, DT= .02000 SEC", "6557 .00244 NPTS, DT"), then
   * the accelerations, any number per line. 1 g = 9.80665 m/s2.
   */
  Motion read_at2_motion(const std::string &file);
} // namespace hybrid::scene
