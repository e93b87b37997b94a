// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/side_boundary.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  struct SceneParameters;
  struct SectionMesh;


  /// The bedrock as blocks and what they stand on.
  struct BedrockBlocks
  {
    std::vector<std::vector<int>> outlines; ///< nodes of the mesh, counter-clockwise
    std::vector<int>              region;   ///< per block: index into bedrock_region_names
    std::vector<int>
      foundation; ///< nodes of a foundation that moves as prescribed, left to right; may be empty
  };


  /// What the bedrock is made of: a value of Model/Bedrock. To add one: a file that returns it, and
  /// a line in bedrock_models().
  struct BedrockModel
  {
    /// Blocks from the cells of a mesh. @throws InputError.
    using Cut = BedrockBlocks (*)(const SectionMesh &mesh, const SceneParameters &scene);

    std::string name;                  ///< of Model/Bedrock
    std::string words;                 ///< what the scene card calls its blocks
    bool        is_elements = false;   ///< finite elements
    Cut         cut         = nullptr; ///< nullptr: no blocks

    /// Waves travel through it: they may leave through a compliant base and come in with a free
    /// field. Of blocks: welds between them are a jointed mass, and their size must resolve waves.
    bool carries_waves = false;

    bool        needs_planes = false; ///< planes of the scene cut it
    std::string base_words   = "";    ///< of the line base if it moves; "": those of the base

    /// Finite elements or blocks.
    bool has_cells() const
    {
      return is_elements || cut != nullptr;
    }

    bool can_have(const SideBoundary &sides) const
    {
      return (is_elements || !sides.is_held()) && (carries_waves || !sides.has_free_field);
    }
  };


  /// deal.II finite elements: the default.
  inline BedrockModel continuum_bedrock()
  {
    BedrockModel bedrock{"continuum", "elements"};
    bedrock.is_elements = bedrock.carries_waves = true;
    return bedrock;
  }


  /// All of them, in the order of the documentation: src/scene/bedrock/.
  const std::vector<BedrockModel> &bedrock_models();


  /// Those of the scene's bedrock; none without such bedrock. @throws InputError.
  BedrockBlocks cut_bedrock(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
