// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/bedding_planes.h>
#include <hybrid/scene/mesh/initial_stress.h>

namespace hybrid::continuum
{
  /**
   * The stress sigma_0 that the bedrock has before the static stage (Gravity/Initial stress), and
   * the tractions that go with it on bedding planes with joints. The static model then adds to it
   * what equilibrium asks for,
   *   K u = f - int B^T sigma_0 dA - int_planes B^T t_0 ds,    sigma = sigma_0 + D B u,
   * so that level ground does not move. The integrals are exact for stress that is linear in a
   * cell.
   */
  class InitialRockStress
  {
  public:
    /// @param cell_region see scene::SectionMesh. Nodes must outlive this.
    InitialRockStress(scene::InitialStress    initial_stress,
                      const std::vector<int> &cell_region,
                      const RockMesh         &rock,
                      const ElementNodes     &element_nodes,
                      const JointStiffness   &stiffness);

    /// In a cell, at local coordinates in [0, 1]^2: xx, yy, xy, tension positive [Pa].
    Eigen::Vector3d at(int cell, const Vec2 &local) const;

    /// On the points of the planes, the mean of both sides [Pa].
    const std::vector<double> &plane_tractions() const
    {
      return traction;
    }

    /// Take what the stress itself bears off the load of the static model [N/m].
    void subtract_from(std::vector<double> &load) const;

  private:
    scene::InitialStress    initial;
    const std::vector<int> &region;
    const ElementNodes     &nodes;
    BeddingPlanes           planes;
    std::vector<double>     traction;

    Eigen::Vector3d at_place(int cell, const Vec2 &place) const;
  };
} // namespace hybrid::continuum
