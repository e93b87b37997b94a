// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>
#include <hybrid/scene/types.h>

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
   * Vectors in the direction of shaking; all are zero before the start and without a motion. The
   * motion may come several times (Motion/Repetitions).
   */
  class GroundMotion
  {
  public:
    /// Nothing shakes.
    GroundMotion() = default;

    /// @param given first sample at the start.  @param parameters meaning, angle and start.
    GroundMotion(const Motion &given, const MotionParameters &parameters);

    bool empty() const
    {
      return record.empty();
    }

    /// Of an outcrop along the direction of shaking, its first sample at the start.
    const Motion &outcrop() const
    {
      return record;
    }

    /// From the start of the run to the end of the last event [s].
    double end() const
    {
      return start + (repetitions - 1) * interval + record.duration();
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
    Motion record; ///< at an outcrop
    Vec2   direction   = Vec2::UnitX();
    double start       = 0.; ///< of the record [s]
    int    repetitions = 1;
    double interval    = 0.; ///< from one start to the next [s]

    /// Sum over all events of what one has done at a time since its start [s]: after its record
    /// displacement goes on with the velocity that is left.
    template <typename Value>
    Vec2 sum(double time, const Value &value) const;
  };
} // namespace hybrid::scene
