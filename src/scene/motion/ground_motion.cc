// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/ground_motion.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// An outcrop's motion over that of the wave that travels up to it.
    constexpr double free_surface = 2.;
  } // namespace


  GroundMotion::GroundMotion(const Motion           &given,
                             const MotionParameters &parameters,
                             const Motion           &given_vertical)
    : record(parameters.outcrop ? given : given.scaled(free_surface))
    , vertical(parameters.outcrop ? given_vertical : given_vertical.scaled(free_surface))
    , direction(std::cos(parameters.angle * M_PI / 180.), std::sin(parameters.angle * M_PI / 180.))
    , start(parameters.start)
    , repetitions(parameters.repetitions)
    , interval(parameters.repetition_interval)
  {}


  Vec2 GroundMotion::sum(const double time, double (Motion::*const value)(double) const) const
  {
    const auto of_events = [&](const Motion &component) {
      double total = (component.*value)(time - start);
      for (int event = 1; event < repetitions && time >= start + event * interval; ++event)
        total += (component.*value)(time - start - event * interval);
      return total;
    };
    const Vec2 along = of_events(record) * direction;
    return vertical.empty() ? along : Vec2(along + of_events(vertical) * Vec2::UnitY());
  }


  Vec2 GroundMotion::outcrop_acceleration(const double time) const
  {
    return sum(time, &Motion::acceleration);
  }


  Vec2 GroundMotion::outcrop_velocity(const double time) const
  {
    return sum(time, &Motion::velocity);
  }


  Vec2 GroundMotion::outcrop_displacement(const double time) const
  {
    return sum(time, &Motion::displacement);
  }


  Vec2 GroundMotion::upgoing_velocity(const double time) const
  {
    return outcrop_velocity(time) / free_surface;
  }


  Vec2 GroundMotion::upgoing_displacement(const double time) const
  {
    return outcrop_displacement(time) / free_surface;
  }
} // namespace hybrid::scene
