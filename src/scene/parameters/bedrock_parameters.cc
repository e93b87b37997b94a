// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void check_bedrock(const SceneParameters &scene, const ParameterTable &table)
  {
    if (!scene.has_bedrock_blocks())
      return;
    const bool          layers = scene.bedrock == BedrockModel::layers;
    const SideBoundary &sides  = scene.continuum.sides;
    if (layers && (sides.is_held() || sides.has_free_field))
      throw table.error("Continuum/Sides", "must be viscous with Model/Bedrock = layers");
    if (!layers && sides.is_held())
      throw table.error("Continuum/Sides",
                        "must be viscous or free field with Model/Bedrock = triangles");
    if (scene.continuum.boundary_springs)
      throw table.error("Continuum/Boundary springs", "must be false with a bedrock of blocks");
    if (scene.continuum.rayleigh_mass > 0.)
      throw table.error("Continuum/Rayleigh mass",
                        "must be 0 with a bedrock of blocks, which have stiffness-proportional "
                        "damping only");
    if (layers && scene.bedding.names.empty())
      throw table.error("Bedding planes/Names",
                        "must name the planes that cut the bedrock with Model/Bedrock = layers");
  }
} // namespace hybrid::scene
