// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <string>
#include <vector>

/// @file
/// What moves at t = 0: section "Initial wave" and "Blocks/Initial velocities".
namespace hybrid::scene
{
  /// An elastic wave in plane strain.
  enum class WaveType
  {
    none,
    pressure, ///< P: moves along its way
    shear     ///< SV: moves across it, within the plane
  };

  /// Section "Initial wave": a packet that is in the bedrock at t = 0 and travels.
  struct InitialWaveParameters
  {
    WaveType type      = WaveType::none;
    double   direction = -90.;         ///< of travel [deg] from +x
    Vec2     centre    = Vec2::Zero(); ///< of the packet at t = 0 [m]
    double   amplitude = 1e-3; ///< displacement at the centre [m]: P forwards, SV to the left
    double   frequency = 2.;   ///< [Hz], > 0
    double   length    = 1.;   ///< standard deviation along the way [wave lengths], > 0
    double   width     = 0.;   ///< standard deviation across it [wave lengths]; 0: a plane front
  };

  /// A rigid motion that blocks have at t = 0.
  struct InitialVelocity
  {
    std::string name;
    Vec2        lower;    ///< corner of the box that the blocks' centroids lie in [m]
    Vec2        upper;    ///< opposite corner [m]
    Vec2        velocity; ///< of their centre of mass, to the right and up [m/s]
    double      spin;     ///< about it, anticlockwise [rad/s]
  };
} // namespace hybrid::scene
