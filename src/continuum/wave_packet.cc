// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/wave_packet.h>

#include <cmath>
#include <complex>

namespace hybrid::continuum
{
  using Complex = std::complex<double>;

  WavePacket::WavePacket(const scene::InitialWaveParameters &parameters, const double c)
    : turns(parameters.type == scene::WaveType::shear)
    , centre(parameters.centre)
    , direction(std::cos(parameters.direction * M_PI / 180.),
                std::sin(parameters.direction * M_PI / 180.))
    , speed(c)
    , amplitude(parameters.amplitude)
    , wave_number(2. * M_PI * parameters.frequency / c)
  {
    const double wave_length = c / parameters.frequency;
    const auto   inverse     = [](const double length) { return 1. / (length * length); };
    along                    = inverse(parameters.length * wave_length);
    across                   = parameters.width > 0. ? inverse(parameters.width * wave_length) : 0.;
  }



  double WavePacket::envelope(const Vec2 &position) const
  {
    const Vec2   x = position - centre;
    const double s = direction.dot(x), t = direction.x() * x.y() - direction.y() * x.x();
    return std::exp(-0.5 * (along * s * s + across * t * t));
  }



  WavePacket::Motion WavePacket::at(const Vec2 &position) const
  {
    const Vec2   x = position - centre, side(-direction.y(), direction.x());
    const double s = direction.dot(x), t = side.dot(x);
    // Of the potential: logarithmic derivatives, its derivatives along and across the way, and the
    // derivatives of these along it.
    const Complex ds(-along * s, wave_number), dt(-across * t, 0.);
    const Complex potential =
      std::polar(amplitude * envelope(position), wave_number * s) / Complex(0., wave_number);
    const double forward = (ds * potential).real(), sideward = (dt * potential).real();
    const double forward_rate  = ((ds * ds - along) * potential).real(),
                 sideward_rate = (ds * dt * potential).real();
    const auto motion          = [&](const double f, const double g) -> Vec2 {
      return turns ? Vec2(f * side - g * direction) : Vec2(f * direction + g * side);
    };
    return {motion(forward, sideward), -speed * motion(forward_rate, sideward_rate)};
  }
} // namespace hybrid::continuum
