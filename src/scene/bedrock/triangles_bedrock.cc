// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/triangles_bedrock.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    BedrockBlocks triangles(const SectionMesh &mesh, const SceneParameters &scene)
    {
      BedrockBlocks    blocks;
      std::vector<int> diagonals(mesh.nodes.size(), 0); // that end at each node
      for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
        {
          const auto  &n        = mesh.bedrock_cells[c];
          const double first    = (mesh.nodes[n[2]] - mesh.nodes[n[0]]).norm();
          const double second   = (mesh.nodes[n[3]] - mesh.nodes[n[1]]).norm();
          const bool   is_equal = std::abs(first - second) <= 1e-6 * (first + second);
          const bool   take_first =
            is_equal ? diagonals[n[0]] + diagonals[n[2]] >= diagonals[n[1]] + diagonals[n[3]]
                       : first < second;
          const int k = take_first ? 0 : 1; // the diagonal from corner k to corner k + 2
          ++diagonals[n[k]];
          ++diagonals[n[k + 2]];
          blocks.outlines.push_back({n[k], n[k + 1], n[k + 2]});
          blocks.outlines.push_back({n[k + 2], n[(k + 3) % 4], n[k]});
          blocks.region.insert(blocks.region.end(), 2, mesh.bedrock_region[c]);
        }
      if (!scene.has_compliant_base())
        for (const auto &edge : mesh.lines.at("base"))
          {
            if (blocks.foundation.empty())
              blocks.foundation.push_back(edge[0]);
            blocks.foundation.push_back(edge[1]);
          }
      return blocks;
    }
  } // namespace



  BedrockModel triangles_bedrock()
  {
    BedrockModel bedrock{"triangles", "triangles"};
    bedrock.cut           = triangles;
    bedrock.carries_waves = true;
    return bedrock;
  }
} // namespace hybrid::scene
