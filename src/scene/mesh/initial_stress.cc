// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/initial_stress.h>

namespace hybrid::scene
{
  InitialStress::InitialStress(const SectionMesh &mesh, const SceneParameters &scene)
    : overburden(mesh, scene)
  {
    const BlockParameters &b = scene.blocks;
    if (b.enabled)
      {
        mass = scene.material(b.material, "Blocks/Material").lateral_ratio();
        saturated_mass =
          b.saturated_material.empty()
            ? mass
            : scene.material(b.saturated_material, "Blocks/Saturated material").lateral_ratio();
      }
    if (scene.has_continuum() || scene.has_bedrock_blocks())
      for (const std::string &region : mesh.bedrock_region_names)
        bedrock.push_back(scene.bedrock_material(region).lateral_ratio());
  }
} // namespace hybrid::scene
