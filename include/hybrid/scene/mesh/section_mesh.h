// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * The meshed vertical section, as plain arrays.
   *
   * Bedrock cells and blocks share the nodes along the sliding surface (same
   * node index on both sides). Node lists of cells and blocks run counter-clockwise.
   * Lines are the named physical groups: sliding_surface, bedding_<n>, joint_<suffix>, base, left,
   * right, ground.
   */
  struct SectionMesh
  {
    /// One straight mesh edge of a named line, node indices in the order of the geometry's line.
    using Edge = std::array<int, 2>;

    std::vector<Vec2> nodes; ///< coordinates [m]

    std::vector<std::array<int, 4>> bedrock_cells;  ///< quadrilaterals
    std::vector<int>                bedrock_region; ///< per cell: index into bedrock_region_names
    std::vector<std::string>        bedrock_region_names; ///< "bedrock", "bedrock_<suffix>", ...
    std::vector<int> bedrock_surface; ///< per cell: number of the geometry's surface that it fills

    std::vector<std::vector<int>> blocks;        ///< simple polygons (triangles from gmsh)
    std::vector<int>              block_region;  ///< per block: index into block_region_names
    std::vector<std::string> block_region_names; ///< "sliding_mass", "sliding_mass_<suffix>", ...

    std::vector<std::string> block_names; ///< as the file of polygons calls them; else empty

    std::map<std::string, std::vector<Edge>> lines; ///< edges of each named line

    /// Numbers Resolution/... of the .geo file, which set the sizes of its elements [m].
    std::map<std::string, double> resolutions;

    /// What to call a block in a message: by its name in the file of polygons, or its number.
    std::string block_name(const int block) const
    {
      const auto b = static_cast<std::size_t>(block);
      return b < block_names.size() ? block_names[b] : std::to_string(block);
    }
  };
} // namespace hybrid::scene
