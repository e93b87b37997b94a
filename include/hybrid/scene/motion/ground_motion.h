// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>
#include <hybrid/scene/types.h>

#include <algorithm>

namespace hybrid::scene
{
  /**
   * How the ground shakes: the given motion, what it means, its direction and its start.
   *
   * A wave that travels up moves rock at an outcrop (a free surface) twice as much as itself. The
   * motion given may be either; here both are had at any time of the run, and everything that
   * shakes a model asks for the one it needs:
   *   compliant base    the upgoing wave (incoming traction 2 Z v_up),
   *   prescribed base   the motion of the outcrop.
   *
   * Vectors in the direction of shaking, with the vertical component of a record if there is one
   * (Motion/Vertical file); all are zero before the start and without a motion. The motion may
   * come several times (Motion/Repetitions).
   */
  class GroundMotion
  {
  public:
    /// Nothing shakes.
    GroundMotion() = default;

    /// @param given first sample at the start.  @param parameters meaning, angle and start.
    /// @param vertical component along +y beside it, likewise; empty: none
    GroundMotion(const Motion           &given,
                 const MotionParameters &parameters,
                 const Motion           &vertical = {});

    bool empty() const
    {
      return record.empty();
    }

    /// Of an outcrop along the direction of shaking, its first sample at the start.
    const Motion &outcrop() const
    {
      return record;
    }

    /// Of an outcrop along +y beside that; may be empty.
    const Motion &vertical_outcrop() const
    {
      return vertical;
    }

    /// From the start of the run to the end of the last event [s].
    double end() const
    {
      return start + (repetitions - 1) * interval +
             std::max(record.duration(), vertical.duration());
    }

    /// [m/s2] at @p time [s] of the run.
    Vec2 outcrop_acceleration(double time) const;

    /// [m/s]
    Vec2 outcrop_velocity(double time) const;

    /// [m]
    Vec2 outcrop_displacement(double time) const;

    /// Of the wave that travels up [m/s].
    Vec2 upgoing_velocity(double time) const;

    /// Of the wave that travels up [m].
    Vec2 upgoing_displacement(double time) const;

  private:
    Motion record;   ///< at an outcrop
    Motion vertical; ///< likewise, along +y
    Vec2   direction   = Vec2::UnitX();
    double start       = 0.; ///< of the record [s]
    int    repetitions = 1;
    double interval    = 0.; ///< from one start to the next [s]

    /// Sum over all events of what one has done at a time since its start [s]: after its record
    /// displacement goes on with the velocity that is left. @param value of a Motion at a time
    Vec2 sum(double time, double (Motion::*value)(double) const) const;
  };
} // namespace hybrid::scene
