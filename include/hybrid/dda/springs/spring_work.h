// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

namespace hybrid::dda
{
  /// An accepted step of the springs.
  struct SpringStep
  {
    const Model    &model;
    const DdaState &before; ///< state when the step began
    const Trial    &trial;
    const Springs  &springs;
  };


  /// What the forces of a spring do on the bodies' increments over a step, as bodies turn [J/m].
  struct TurningWork
  {
    /**
     * What a change of tractions from start to end does beyond what it does on gap and slip.
     *
     * The force turns with its bodies, while each body's increment is one vector for the whole
     * step: of a body that spins with W, -F ds W dt for a force F towards the axis and an arc ds.
     * The mean of the forces at both ends is free of it; weights w at the end and 1 - w at the
     * start take w - 1/2 of it from the motion, which is how Newmark's dissipative pairs slow a
     * spinning bonded body: dW/dt = -(gamma - 1/2) dt W^3 for masses far from each other.
     */
    double rotation = 0.;

    /**
     * What the mean of the forces at both ends does beyond what it does on the places where it
     * acts.
     *
     * A place at the distance R from the axis of a body that turns by r goes along an arc; the
     * increment goes along the tangent at its start or at its end. These are off by R r^2/2 to
     * opposite sides. So of a force that grows by dF towards the axis R r^2 dF/4 is left, and of a
     * force F along the arc -R r^3 F/12.
     */
    double arc = 0.;
  };


  /// Of a spring. @param start, end tractions of TurningWork::rotation
  TurningWork turning_work(const SpringStep        &step,
                           std::size_t              number,
                           const Springs::Traction &start,
                           const Springs::Traction &end);
} // namespace hybrid::dda
