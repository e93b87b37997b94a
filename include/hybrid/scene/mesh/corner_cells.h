// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/reentrant_corner.h>

namespace hybrid::scene
{
  /**
   * Where the outline of the bedrock turns inwards by more than 10 degrees, at nodes that no block
   * has.
   *
   * Beside a corner displacements of a body with free sides go with r^lambda, lambda between 1/2
   * (a crack) and 1 (no corner), the distance r from it (Williams 1952): 0.54 at a turn of 90
   * degrees, 0.70 at 40, 0.91 at 10. Elements of the size h err by h^lambda there and by
   * h^(2 lambda) elsewhere (Strang & Fix 1973, chapter 8).
   */
  std::vector<ReentrantCorner> corners_of_bedrock(const SectionMesh &mesh);

  /**
   * Halve the cells at each corner of the bedrock towards it, so many @p times: what the corner
   * leaves of the error falls, and that of waves stays.
   *
   * Each edge from the corner V to A or B gets a node m in its middle, each cell V A C B there one
   * in its centre c. It gives way to V mA c mB, mA A C c and c C B mB, so neighbours beyond A, C
   * and B stay as they are.
   */
  void halve_corner_cells(SectionMesh &mesh, int times);

  /**
   * Whether some corner of the bedrock has edges on the outline that a @p coarser mesh of the same
   * section has hardly longer (less than sqrt(2) times), as where a slope is one cell long in both:
   * then the difference of the two tells nothing of what the corner leaves.
   */
  bool keeps_corner_cells(const std::vector<ReentrantCorner> &corners,
                          const std::vector<ReentrantCorner> &coarser);
} // namespace hybrid::scene
