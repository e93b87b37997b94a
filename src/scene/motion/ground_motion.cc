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


  GroundMotion::GroundMotion(const Motion &given, const MotionParameters &parameters)
    : record(parameters.outcrop ? given : given.scaled(free_surface))
    , direction(std::cos(parameters.angle * M_PI / 180.), std::sin(parameters.angle * M_PI / 180.))
    , start(parameters.start)
    , repetitions(parameters.repetitions)
    , interval(parameters.repetition_interval)
  {}


  template <typename Value>
  Vec2 GroundMotion::sum(const double time, const Value &value) const
  {
    double total = value(time - start);
    for (int event = 1; event < repetitions && time >= start + event * interval; ++event)
      total += value(time - start - event * interval);
    return total * direction;
  }


  Vec2 GroundMotion::outcrop_acceleration(const double time) const
  {
    return sum(time, [this](const double t) { return record.acceleration(t); });
  }


  Vec2 GroundMotion::outcrop_velocity(const double time) const
  {
    return sum(time, [this](const double t) { return record.velocity(t); });
  }


  Vec2 GroundMotion::outcrop_displacement(const double time) const
  {
    return sum(time, [this](const double t) { return record.displacement(t); });
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
