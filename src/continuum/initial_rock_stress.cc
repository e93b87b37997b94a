// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/initial_rock_stress.h>
#include <hybrid/continuum/stress_load.h>

namespace hybrid::continuum
{
  InitialRockStress::InitialRockStress(scene::InitialStress    initial_stress,
                                       const std::vector<int> &cell_region,
                                       const RockMesh         &rock,
                                       const ElementNodes     &element_nodes,
                                       const JointStiffness   &stiffness)
    : initial(std::move(initial_stress))
    , region(cell_region)
    , nodes(element_nodes)
    , planes(rock, element_nodes, stiffness)
  {
    // The points follow the faces, as many on each as a face has nodes.
    const std::size_t n = nodes.line.degree() + 1;
    for (std::size_t g = 0; g < planes.points().size(); ++g)
      {
        const BeddingPlanes::Point &point  = planes.points()[g];
        const FacePair             &faces  = rock.joints[g / n];
        const Eigen::Vector3d       stress = 0.5 * (at_place(faces.first.cell, point.position) +
                                              at_place(faces.second.cell, point.position));
        const Vec2 on_left(stress[0] * point.normal.x() + stress[2] * point.normal.y(),
                           stress[2] * point.normal.x() + stress[1] * point.normal.y());
        traction.push_back(on_left.dot(point.normal));
        traction.push_back(on_left.dot(point.tangent));
      }
  }



  Eigen::Vector3d InitialRockStress::at_place(const int cell, const Vec2 &place) const
  {
    const auto stress = initial.in_bedrock(region[cell], place, nodes.map(cell, Vec2(0.5, 0.5)));
    return {-stress.horizontal, -stress.vertical, 0.};
  }



  Eigen::Vector3d InitialRockStress::at(const int cell, const Vec2 &local) const
  {
    return at_place(cell, nodes.map(cell, local));
  }



  void InitialRockStress::subtract_from(std::vector<double> &load) const
  {
    add_stress_load(
      nodes, [this](const int cell, const Vec2 &local) { return at(cell, local); }, -1., load);
    planes.add_forces(traction, -1., load);
  }
} // namespace hybrid::continuum
