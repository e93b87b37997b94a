// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hybrid::scene
{
  struct SectionMesh;
}

namespace hybrid::dda
{
  struct Model;

  /**
   * Which way is down for each block of the mass, from where it was drawn.
   *
   * Blocks that touch each other are one slide, which has one direction: towards the lower one of
   * the two ends of the stretch that its soles cover. So a slide on one flank of a valley falls
   * into the valley whatever the other flank does, and what runs up there slides downhill still.
   * A level stretch has that of the surface beside it, or of the mass above it
   * (scene/mesh/downhill.h), else, as slides without soles have, the direction that all others
   * share.
   */
  struct Downhill
  {
    std::vector<int>    slide; ///< per block of the mass: which slide it belongs to, from 0 on
    std::vector<double> sign;  ///< per block of the mass: sign of x downhill; 0: level

    /// Sign of x downhill of a block, 0: level.
    double sign_of(const int block) const
    {
      return block < static_cast<int>(sign.size()) ? sign[block] : 0.;
    }

    /// The sign of all slides that have one; 0: none has, or they face each other.
    double shared() const;

    /// No slide has a direction.
    bool is_level() const;
  };


  /// @pre the soles of @p model are known.
  Downhill find_downhill(const Model &model, const scene::SectionMesh &mesh);
} // namespace hybrid::dda
