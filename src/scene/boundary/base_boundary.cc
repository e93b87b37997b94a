// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/boundary/compliant_base.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/rigid_base.h>

namespace hybrid::scene
{
  const std::vector<BaseBoundary> &base_boundaries()
  {
    static const std::vector<BaseBoundary> bases{compliant_base(), rigid_base(), fixed_base()};
    return bases;
  }
} // namespace hybrid::scene
