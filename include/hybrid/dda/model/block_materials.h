// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/joint_lines.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>
#include <hybrid/scene/types.h>
#include <hybrid/scene/weibull.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /// Materials of the sliding mass and its belt, above and below the water level.
  class BlockMaterials
  {
  public:
    /// Both must outlive this.
    BlockMaterials(const scene::SectionMesh &section, const scene::SceneParameters &parameters)
      : mesh(section)
      , scene(parameters)
      , joint_lines(section)
    {}

    /// Of a block. @param region see SectionMesh::block_region
    /// @throws InputError if the scene has no such material.
    const Material &mass(const int region, const bool saturated) const
    {
      return scene.mass_material(mesh.block_region_names[region], saturated);
    }

    /// @throws InputError if the scene has no such material.
    const Material &belt(const bool saturated) const
    {
      return scene.belt_material(saturated);
    }

    /// What bonds blocks of two regions: where their materials differ, the smaller of each
    /// strength.
    Material bond(int region, int other, bool saturated) const;

    /// Line joint_<suffix> that the edge between two nodes of the mesh is on; nullptr: none.
    const std::string *joint_line(const int node, const int other) const
    {
      return joint_lines.of(node, other);
    }

    /// Of joints and contacts on the edge between two nodes of the mesh; nullptr: those of the
    /// blocks.
    const Material *joint(const int node, const int other, const bool saturated) const
    {
      const std::string *line = joint_line(node, other);
      return line == nullptr ? nullptr : scene.joint_material(*line, saturated);
    }

    /// Properties that scatter, each with numbers of its own.
    static constexpr int modulus_number = 0, body_strength_number = 1, belt_strength_number = 2,
                         block_strength_number = 3;

    /// Factor of a property with Weibull's @p shape (0: 1) at a place.
    double factor(const double shape, const int property, std::vector<Vec2> places) const
    {
      if (shape == 0.)
        return 1.;
      const std::uint64_t seed =
        16 * static_cast<std::uint64_t>(scene.heterogeneity.seed) + property;
      return scene::Weibull(shape).quantile(scene::number_of_place(seed, std::move(places)));
    }

    bool below_water(const Vec2 &x) const
    {
      return x.y() < scene.environment.water_at(x.x());
    }

  private:
    const scene::SectionMesh     &mesh;
    const scene::SceneParameters &scene;
    const scene::JointLines       joint_lines;
  };
} // namespace hybrid::dda
