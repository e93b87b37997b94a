// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/stress_load.h>

#include <Eigen/LU>

#include <cmath>

namespace hybrid::continuum
{
  void add_stress_load(const ElementNodes  &nodes,
                       const CellStress    &stress_at,
                       const double         factor,
                       std::vector<double> &load)
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
            const Eigen::Vector3d stress   = stress_at(static_cast<int>(c), local);
            const double          part =
              factor * rule.weight(q) * rule.weight(r) * std::abs(jacobian.determinant());
            for (int j = 0; j < n; ++j)
              for (int i = 0; i < n; ++i)
                {
                  const Eigen::RowVector2d slope =
                    Eigen::RowVector2d(line.derivative(i, local.x()) * line.value(j, local.y()),
                                       line.value(i, local.x()) * line.derivative(j, local.y())) *
                    to_place;
                  double *node = &load[2 * nodes.cells[c][j * n + i]];
                  node[0] += part * (stress[0] * slope[0] + stress[2] * slope[1]);
                  node[1] += part * (stress[2] * slope[0] + stress[1] * slope[1]);
                }
          }
  }
} // namespace hybrid::continuum
