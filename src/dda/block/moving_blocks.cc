// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/scene/input_error.h>

#include <string>

namespace hybrid::dda
{
  std::vector<MovingBlocks>
  find_moving_blocks(const std::vector<scene::InitialVelocity> &parameters,
                     const Geometry                            &geometry,
                     const int                                  n_mass)
  {
    std::vector<MovingBlocks> result;
    std::vector<int>          taken(n_mass, -1); // by a box
    for (std::size_t k = 0; k < parameters.size(); ++k)
      {
        const scene::InitialVelocity &given = parameters[k];
        MovingBlocks                  moving{{}, given.velocity, given.spin};
        for (int b = 0; b < n_mass; ++b)
          {
            const int  first = geometry.offset[b];
            const Vec2 x =
              polygon_moments(&geometry.vertices[first], geometry.offset[b + 1] - first).centroid;
            if (!((x.array() >= given.lower.array()).all() &&
                  (x.array() <= given.upper.array()).all()))
              continue;
            if (taken[b] >= 0)
              throw InputError("Blocks/Initial velocities: the block at (" + std::to_string(x.x()) +
                               ", " + std::to_string(x.y()) + ") m lies in the boxes of '" +
                               parameters[taken[b]].name + "' and '" + given.name + "'");
            taken[b] = static_cast<int>(k);
            moving.blocks.push_back(b);
          }
        if (moving.blocks.empty())
          throw InputError("Blocks/Initial velocities: no block has its centroid in the box of '" +
                           given.name + "'");
        result.push_back(std::move(moving));
      }
    return result;
  }
} // namespace hybrid::dda
