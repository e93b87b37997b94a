// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <string>
#include <vector>

/// @file
/// Loads besides gravity, water and motion: sections "Point loads" and "Edge loads".
namespace hybrid::scene
{
  /// A force at a point of the bedrock.
  struct PointLoad
  {
    std::string name;
    Vec2        position; ///< [m]
    Vec2        peak;     ///< at the peak of the wavelet, to the right and up [N/m]
  };

  /// Section "Point loads": Ricker wavelets, off if there are none.
  struct PointLoadParameters
  {
    std::vector<PointLoad> loads;
    double                 frequency = 10.; ///< dominant frequency f [Hz], > 0
    double                 start     = 0.;  ///< of the wavelet, 1.5 / f before its peak [s], >= 0
  };

  /// A traction on free edges of blocks.
  struct EdgeTraction
  {
    std::string name;
    Vec2        lower;    ///< corner of the box that the edges lie in, initial position [m]
    Vec2        upper;    ///< opposite corner [m]
    Vec2        traction; ///< to the right and up, per length of the initial edge [Pa]
  };

  /// Section "Edge loads": dead loads on blocks in the dynamic stage, off if there are none.
  struct EdgeLoadParameters
  {
    std::vector<EdgeTraction> tractions;
    double                    start = 0.; ///< the loads begin to rise [s], >= 0
    double rise_time = 0.; ///< they rise linearly over this time, then stay [s], >= 0
  };
} // namespace hybrid::scene
