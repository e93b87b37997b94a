// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block_scenes.h"

#include <hybrid/scene/option_registry.h>

#include <string>
#include <vector>

/// Bedrock of unit squares for tests of a bedrock of blocks.
namespace hybrid::test
{
  /// Layers of unit squares, each a surface of its own; @p rows of each from the base at y = 0
  /// upwards; bedding_1 is the lowest plane.
  inline scene::SectionMesh layered_section(const int columns, const std::vector<int> &rows)
  {
    scene::SectionMesh mesh;
    int                height = 0;
    const auto         node   = [&](const int i, const int j) { return j * (columns + 1) + i; };
    mesh.bedrock_region_names = {"bedrock"};
    for (std::size_t layer = 0; layer < rows.size(); ++layer)
      {
        if (layer > 0)
          for (int i = 0; i < columns; ++i)
            mesh.lines["bedding_" + std::to_string(layer)].push_back(
              {node(i, height), node(i + 1, height)});
        for (int j = height; j < height + rows[layer]; ++j)
          for (int i = 0; i < columns; ++i)
            {
              mesh.bedrock_cells.push_back(
                {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
              mesh.bedrock_region.push_back(0);
              mesh.bedrock_surface.push_back(static_cast<int>(layer) + 1);
            }
        height += rows[layer];
      }
    for (int j = 0; j <= height; ++j)
      for (int i = 0; i <= columns; ++i)
        mesh.nodes.emplace_back(i, j);
    for (int i = 0; i < columns; ++i)
      {
        mesh.lines["base"].push_back({node(i, 0), node(i + 1, 0)});
        mesh.lines["ground"].push_back({node(i, height), node(i + 1, height)});
      }
    for (int j = 0; j < height; ++j)
      {
        mesh.lines["left"].push_back({node(0, j), node(0, j + 1)});
        mesh.lines["right"].push_back({node(columns, j), node(columns, j + 1)});
      }
    return mesh;
  }



  /// The recipe of the developer guide: every cell is a block.
  inline scene::BedrockModel cells_bedrock()
  {
    scene::BedrockModel bedrock{"cells", "cells"};
    bedrock.carries_waves = true;
    bedrock.cut           = [](const scene::SectionMesh &mesh, const scene::SceneParameters &) {
      scene::BedrockBlocks blocks;
      for (const auto &cell : mesh.bedrock_cells)
        blocks.outlines.emplace_back(cell.begin(), cell.end());
      blocks.region = mesh.bedrock_region;
      return blocks;
    };
    return bedrock;
  }



  /// No sliding mass, a bedrock of @p kind ("cells", or one of the program's) of the material
  /// "rock", the plane bedding_1.
  inline scene::SceneParameters bedrock_parameters(const std::string &kind)
  {
    scene::SceneParameters s                = block_parameters(30.);
    s.blocks.enabled                        = false;
    std::vector<scene::BedrockModel> models = scene::bedrock_models();
    models.push_back(cells_bedrock());
    s.bedrock                        = *scene::find_option(kind, models);
    s.continuum.region_material["*"] = "rock";
    s.bedding.names                  = {"bedding_1"};
    return s;
  }
} // namespace hybrid::test
