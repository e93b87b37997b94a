// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/initial_stress.h>

namespace hybrid::scene
{
  InitialStress::InitialStress(const SectionMesh &mesh, const SceneParameters &scene)
    : overburden(mesh, scene)
  {
    if (scene.blocks.enabled)
      for (const std::string &region : mesh.block_region_names)
        {
          mass.push_back(scene.mass_material(region, false).lateral_ratio());
          saturated_mass.push_back(scene.mass_material(region, true).lateral_ratio());
        }
    if (scene.has_continuum() || scene.has_bedrock_blocks())
      for (const std::string &region : mesh.bedrock_region_names)
        bedrock.push_back(scene.bedrock_material(region).lateral_ratio());
  }
} // namespace hybrid::scene
