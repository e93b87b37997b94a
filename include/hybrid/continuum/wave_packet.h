// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/start_parameters.h>

namespace hybrid::continuum
{
  /**
   * A packet of P or SV waves with a Gaussian envelope at t = 0, in endless rock.
   *
   * With the potential phi = Re[A / (i k) exp(i k s - s^2 / (2 l^2) - t^2 / (2 b^2))], s along the
   * direction and t across it from the centre, u = grad phi is a P wave, u = (-d phi/dy, d phi/dx)
   * an SV wave without any part of the other (Helmholtz; Aki & Richards 2002, section 4.1). It
   * moves as d phi/dt = -c d phi/ds, exact for a plane front; of a packet of width b the part 1 /
   * (2 k b)^2 of the amplitude, at most, goes the other direction.
   */
  class WavePacket
  {
  public:
    /// @param speed c of the waves [m/s].
    WavePacket(const scene::InitialWaveParameters &parameters, double speed);

    /// Displacement [m] and velocity [m/s] at t = 0.
    struct Motion
    {
      Vec2 displacement, velocity;
    };

    Motion at(const Vec2 &position) const;

    /// Envelope: its part of the amplitude at the centre [-].
    double envelope(const Vec2 &position) const;

  private:
    bool   turns; ///< the displacement of SV waves is that of P waves, turned by 90 degrees
    Vec2   centre, direction;
    double speed, amplitude;
    double wave_number;   ///< k [1/m]
    double along, across; ///< 1 / l^2 and 1 / b^2 [1/m2]
  };
} // namespace hybrid::continuum
