// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void check_bedrock(const SceneParameters &scene, const ParameterTable &table)
  {
    if (!scene.has_bedrock_blocks())
      return;
    const BedrockModel &bedrock = scene.bedrock;
    const auto can_have = [&](const SideBoundary &sides) { return bedrock.can_have(sides); };
    if (!can_have(scene.continuum.sides))
      throw table.error("Continuum/Sides",
                        "must be " + names_in_words(side_boundaries(), can_have) +
                          " with Model/Bedrock = " + bedrock.name);
    if (scene.continuum.boundary_springs)
      throw table.error("Continuum/Boundary springs", "must be false with a bedrock of blocks");
    if (scene.continuum.rayleigh_mass > 0.)
      throw table.error("Continuum/Rayleigh mass",
                        "must be 0 with a bedrock of blocks, which have stiffness-proportional "
                        "damping only");
    if (bedrock.needs_planes && scene.bedding.names.empty())
      throw table.error("Bedding planes/Names",
                        "must name the planes that cut the bedrock with Model/Bedrock = " +
                          bedrock.name);
  }
} // namespace hybrid::scene
