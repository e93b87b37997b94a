// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/overlap.h>
#include <hybrid/restart/archive.h>

#include <string>

namespace hybrid::output
{
  /// Says when a block is deep in another one or in the ground, and keeps the deepest overlap.
  class OverlapWatch
  {
  public:
    static constexpr double warned = 0.02; ///< part of the size of the smaller block [-]

    /// @param time [s]
    void look(const dda::Geometry &geometry, double time);

    /// What is to be said now; empty: nothing, or it has been said.
    std::string warning();

    const dda::Overlap &deepest() const
    {
      return overlap;
    }

    /// When the deepest overlap was seen [s].
    double time_of_deepest() const
    {
      return seen;
    }

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    dda::Overlap overlap;
    double       seen       = 0.; ///< [s]
    bool         has_warned = false;
  };

  /// "a block of 1 m at (2.00, 3.00) is in the ground by 0.0612 m, 6.1 % of its size"
  std::string overlap_text(const dda::Overlap &overlap);
} // namespace hybrid::output
