// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /// What a block looks at besides the bodies that it never shared a vertex with.
  enum class ContactScope : char
  {
    no,        ///< nothing: all its joints hold
    to_blocks, ///< neighbours of the mesh: a joint at one of its corners has yielded
    to_all ///< the ground too: a joint of its has failed, or it was never bonded, or it has slid on
           ///< its belt into an edge of the ground that rises there, or it only touches the ground
           ///< with a corner and a joint of its has yielded
  };
} // namespace hybrid::dda
