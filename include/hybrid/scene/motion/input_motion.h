// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  struct MotionSource;


  /// The motion of a scene and what its user should know of it.
  struct InputMotion
  {
    Motion      motion;
    Motion      vertical;              ///< along +y, beside the motion; empty: none
    SpectrumFit fit;                   ///< of a spectrum-compatible motion; else empty
    double      first_time = 0.;       ///< of the rows of a record, before they begin at 0 [s]
    std::string scaling;               ///< of a record or spectrum: its peak and factor, in words
    std::vector<std::string> notes;    ///< one sentence each
    std::vector<std::string> warnings; ///< likewise
  };


  /**
   * The motion that a scene asks for, its first sample at t = 0 (the start time is the caller's).
   *
   * Its source is that of parameters.type (motion_source.h); none is an empty motion.
   *
   * A record of the vertical component (parameters.vertical_file) is scaled by the factor of the
   * other one, unless it has a peak of its own. The times of both must begin alike.
   *
   * A peak >= 0 scales the motion to exactly this largest |a| [m/s2]; without one, records and
   * spectrum-compatible motions stay as they are, and the others have 1 m/s2.
   *
   * Said about it: an offset of a record (its velocity would end at more than a tenth of the
   * corrected record's largest); how well a spectrum is met; a motion shorter or longer than the
   * run; a motion that does not end at rest.
   *
   * @throws InputError with file and line for a file that cannot be understood.
   */
  InputMotion make_input_motion(const MotionParameters &parameters, const TimeParameters &time);


  /// The same with other sources.
  InputMotion make_input_motion(const MotionParameters          &parameters,
                                const TimeParameters            &time,
                                const std::vector<MotionSource> &sources);


  /// Only the motion, for steps of @p time_step [s].
  Motion make_motion(const MotionParameters &parameters, double time_step);
} // namespace hybrid::scene
