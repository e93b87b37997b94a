// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// What the base of the bedrock does: a value of Continuum/Base. To add one: a file that returns
  /// it, and a line in base_boundaries().
  struct BaseBoundary
  {
    std::string name;                 ///< of Continuum/Base
    std::string words;                ///< what the card of the mesh's lines calls it
    bool        is_compliant = false; ///< dashpots over a half space; else displacement prescribed
    bool        takes_motion = false; ///< the motion arrives through the half space, or is that of
                                      ///< the base; else it brings nothing, or does not move

    /// The base itself is moved.
    bool moves() const
    {
      return takes_motion && !is_compliant;
    }
  };


  /// All of them, in the order of the documentation.
  const std::vector<BaseBoundary> &base_boundaries();
} // namespace hybrid::scene
