// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/initial_rock_stress.h>

#include <Eigen/LU>

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
    const LagrangeLine &line = nodes.line;
    const auto         &rule = line.quadrature();
    const int           n    = line.degree() + 1;
    for (std::size_t c = 0; c < nodes.cells.size(); ++c)
      for (unsigned int q = 0; q < rule.size(); ++q)
        for (unsigned int r = 0; r < rule.size(); ++r)
          {
            const Vec2            local(rule.point(q)[0], rule.point(r)[0]);
            const Eigen::Matrix2d jacobian = nodes.jacobian(static_cast<int>(c), local);
            const Eigen::Matrix2d to_place = jacobian.inverse();
            const Eigen::Vector3d stress   = at(static_cast<int>(c), local);
            const double area = rule.weight(q) * rule.weight(r) * std::abs(jacobian.determinant());
            for (int j = 0; j < n; ++j)
              for (int i = 0; i < n; ++i)
                {
                  const Eigen::RowVector2d slope =
                    Eigen::RowVector2d(line.derivative(i, local.x()) * line.value(j, local.y()),
                                       line.value(i, local.x()) * line.derivative(j, local.y())) *
                    to_place;
                  double *node = &load[2 * nodes.cells[c][j * n + i]];
                  node[0] -= area * (stress[0] * slope[0] + stress[2] * slope[1]);
                  node[1] -= area * (stress[2] * slope[0] + stress[1] * slope[1]);
                }
          }
    planes.add_forces(traction, -1., load);
  }
} // namespace hybrid::continuum
