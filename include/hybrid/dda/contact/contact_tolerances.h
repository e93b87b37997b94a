// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /**
   * Lengths and angles that decide which vertex-edge pairs are contacts (PairTolerances: of which
   * two bodies).
   *
   * The small lengths follow from the reach: positions nearer than
   * coincidence() are the same, hysteresis() keeps a vertex that rests exactly
   * over an end from changing edges at every step, extension() bridges the
   * cracks of a row of blocks.
   */
  struct ContactTolerances
  {
    static constexpr double smooth_angle = 1e-3; ///< turns up to this are no corners [rad]

    double reach;      ///< largest gap of a contact [m]
    double max_depth;  ///< largest penetration of a new contact [m]
    double held_depth; ///< of one with a surface that has been there, >= max_depth [m]

    static constexpr double entry_sine = 0.0523; ///< sin 3 deg: angle test of a new contact
    static constexpr double hold_sine  = 0.0872; ///< sin 5 deg: of a contact that persists
    static constexpr double continuing_cosine =
      0.9848; ///< cos 10 deg: edges that continue one another
    static constexpr double continuing_sine = 0.1736; ///< sin 10 deg

    /// An edge whose nearest point is farther from a vertex than this is no new partner [m]: what
    /// edges give way to each other at a ridge adds less than 5 %.
    double search_distance() const
    {
      return 1.05 * (reach > max_depth ? reach : max_depth) + extension();
    }

    double coincidence() const
    {
      return 1e-6 * reach;
    }

    double hysteresis() const
    {
      return 1e-3 * reach;
    }

    /// Edges that pass a vertex at heights nearer than this go on along each other [m]: where it
    /// presses by -@p gap, one that it does not press on yet may stand higher by half of that.
    double seam_height(const double gap) const
    {
      return hysteresis() + (gap < 0. ? -0.5 * gap : 0.);
    }

    double extension() const
    {
      return 1e-2 * reach;
    }
  };
} // namespace hybrid::dda
