// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/overburden.h>

#include <vector>

namespace hybrid::scene
{
  /// Stress that the section has before the static stage (Gravity/Initial stress): vertical that of
  /// the overburden, horizontal K0 of it (Material::lateral_ratio()), no shear.
  class InitialStress
  {
  public:
    InitialStress(const SectionMesh &mesh, const SceneParameters &scene);

    /// Effective [Pa], compression positive.
    struct Stress
    {
      double horizontal, vertical;
    };

    /// At a place in a block of the mass, or on its outline.
    /// @param region see SectionMesh::block_region
    /// @param saturated the block is below the water level
    /// @param inside a point in the block
    Stress
    in_mass(const int region, const bool saturated, const Vec2 &place, const Vec2 &inside) const
    {
      const double vertical = overburden.in_mass(place, inside);
      return {(saturated ? saturated_mass : mass)[region] * vertical, vertical};
    }

    /// The same in the bedrock. @param region see SectionMesh::bedrock_region
    Stress in_bedrock(const int region, const Vec2 &place, const Vec2 &inside) const
    {
      const double vertical = overburden.in_bedrock(place, inside);
      return {bedrock[region] * vertical, vertical};
    }

  private:
    Overburden          overburden;
    std::vector<double> mass, saturated_mass; ///< K0 per region [-]
    std::vector<double> bedrock;              ///< K0 per region [-]; empty: rigid
  };
} // namespace hybrid::scene
