// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <map>

namespace hybrid::scene
{
  /// How thick the cells of the bedrock are (area over extent along x), in the mean of each of
  /// the geometry's surfaces [m]. Empty where the mesh has not come from surfaces.
  std::map<int, double> cell_thickness(const SectionMesh &mesh);

  /**
   * Whether the cells of some surface among several are hardly thicker in a @p coarser mesh of the
   * same section (less than sqrt(2) times), as where a layer is one cell thick in both: then the
   * difference of the two tells nothing of what these cells leave.
   */
  bool keeps_thin_layers(const std::map<int, double> &thickness,
                         const std::map<int, double> &coarser);
} // namespace hybrid::scene
