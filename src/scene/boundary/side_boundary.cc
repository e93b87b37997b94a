// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/boundary/fixed_side.h>
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/roller_side.h>
#include <hybrid/scene/boundary/viscous_side.h>

namespace hybrid::scene
{
  const std::vector<SideBoundary> &side_boundaries()
  {
    static const std::vector<SideBoundary> sides{viscous_side(),
                                                 free_field_side(),
                                                 roller_side(),
                                                 fixed_side()};
    return sides;
  }
} // namespace hybrid::scene
