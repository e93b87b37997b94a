// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <array>
#include <vector>

namespace hybrid::dda
{
  /**
   * Marks ends of released belt joints that have lost their cohesion for good (JointState::parted):
   * torn before the release, or now farther from every edge of the ground that a belt bonded than
   * an intact bond opens (from where an initial stress has stretched it).
   */
  class BeltParting
  {
  public:
    /**
     * To be called at the start of a step, after hand_over_released_joints(): asks for places only,
     * so a step that is tried again finds the same. An end that lies where it lay costs one test.
     */
    void update(const Model &model, DdaState &state);

  private:
    std::vector<int>                belts;     ///< joints of all belts
    std::vector<std::array<int, 2>> last_belt; ///< per joint and end: where it lay, in belts

    bool is_parted(const Model &model, const DdaState &state, int joint, int end);
  };
} // namespace hybrid::dda
