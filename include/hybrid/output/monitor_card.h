// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * Which monitors follow the mass and which the ground below it, in one line: a point drawn on the
   * sliding surface may belong to either. Empty without monitors or without a mass.
   * @param blocks the block that each monitor belongs to; -1: none (Probes::block)
   */
  std::string describe_monitors(const std::vector<scene::Monitor> &monitors,
                                const std::vector<int>            &blocks,
                                const dda::Model                  &model);
} // namespace hybrid::output
