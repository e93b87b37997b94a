// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/bedrock/triangles_bedrock.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  const std::vector<BedrockModel> &bedrock_models()
  {
    static const std::vector<BedrockModel> models{continuum_bedrock(),
                                                  layers_bedrock(),
                                                  triangles_bedrock(),
                                                  rigid_bedrock()};
    return models;
  }



  BedrockBlocks cut_bedrock(const SectionMesh &mesh, const SceneParameters &scene)
  {
    return scene.bedrock.cut == nullptr ? BedrockBlocks() : scene.bedrock.cut(mesh, scene);
  }
} // namespace hybrid::scene
