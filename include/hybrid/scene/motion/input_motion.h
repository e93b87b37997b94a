// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// The motion of a scene and what its user should know of it.
  struct InputMotion
  {
    Motion                   motion;
    SpectrumFit              fit;      ///< of a spectrum-compatible motion; else empty
    std::string              scaling;  ///< of a record or spectrum: its peak and factor, in words
    std::vector<std::string> notes;    ///< one sentence each
    std::vector<std::string> warnings; ///< likewise
  };


  /**
   * The motion that a scene asks for, its first sample at t = 0 (the start time is the caller's).
   *
   * none       an empty motion.
   * ricker     a(t) = A (1 - 2 s^2) exp(-s^2), s = pi f (t - t0), t0 = 1.5/f: starts and ends below
   * 1e-7 A. Its velocity is A (t - t0) exp(-s^2), its displacement -A exp(-s^2) / (2 pi^2 f^2).
   * sine       see make_sine_burst().
   * synthetic  see make_synthetic_motion().
   * spectrum   see make_spectrum_motion().
   * text       two columns t [s], a [file_unit m/s2], equally spaced.
   * at2        PEER AT2; in units of g unless the header names cm/s2 or m/s2.
   *
   * A peak >= 0 scales the motion to exactly this largest |a| [m/s2]; without one, ricker, sine and
   * synthetic have 1 m/s2, records and spectrum-compatible motions stay as they are.
   *
   * Said about it: an offset of a record (its velocity would end at more than a tenth of the
   * corrected record's largest); how well a spectrum is met; a motion shorter or longer than the
   * run; a motion that does not end at rest.
   *
   * @throws InputError with file and line for a file that cannot be understood.
   */
  InputMotion make_input_motion(const MotionParameters &parameters, const TimeParameters &time);


  /// Only the motion, for steps of @p time_step [s].
  Motion make_motion(const MotionParameters &parameters, double time_step);
} // namespace hybrid::scene
