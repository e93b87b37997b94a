// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/scene/parameters/start_parameters.h>

#include <vector>

namespace hybrid::dda
{
  /// The blocks that a scene sets in motion, together, as one rigid body.
  struct MovingBlocks
  {
    std::vector<int> blocks;
    Vec2             velocity = Vec2::Zero(); ///< of their centre of mass [m/s]
    double           spin     = 0.;           ///< about it, anticlockwise [rad/s]
  };

  /**
   * Blocks of the sliding mass, the first @p n_mass, with their centroid in the boxes of the scene.
   *
   * @throws InputError if a box has none, or one that another box has.
   */
  std::vector<MovingBlocks>
  find_moving_blocks(const std::vector<scene::InitialVelocity> &parameters,
                     const Geometry                            &geometry,
                     int                                        n_mass);
} // namespace hybrid::dda
