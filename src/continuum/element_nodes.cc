// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/element_nodes.h>

#include <Eigen/LU>

#include <stdexcept>

namespace hybrid::continuum
{
  void ElementNodes::keep_positions(const Portion &portion)
  {
    const auto first = positions.begin() - first_position;
    positions        = std::vector<Vec2>(first + static_cast<std::ptrdiff_t>(portion.begin),
                                  first + static_cast<std::ptrdiff_t>(portion.end));
    first_position   = static_cast<int>(portion.begin);
  }


  void ElementNodes::keep_cells(const std::function<bool(std::size_t)> &is_kept)
  {
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (!is_kept(c))
        cells[c] = std::vector<int>(); // {} would keep its memory
  }


  std::vector<int> ElementNodes::along(const RockFace &face) const
  {
    const int p = line.degree(), n = p + 1;
    // first and last corner, first node and stride of the four faces
    const int faces[4][4] = {{0, 2, 0, n}, {1, 3, p, n}, {0, 1, 0, 1}, {2, 3, n * p, 1}};
    for (const auto &f : faces)
      {
        const int first = corners[face.cell][f[0]], last = corners[face.cell][f[1]];
        if ((first != face.a || last != face.b) && (first != face.b || last != face.a))
          continue;
        std::vector<int> result(n);
        for (int i = 0; i < n; ++i)
          result[first == face.a ? i : p - i] = cells[face.cell][f[2] + i * f[3]];
        return result;
      }
    throw std::logic_error("ElementNodes::along(): not a face of the cell");
  }


  Vec2 ElementNodes::map(const int cell, const Vec2 &local) const
  {
    const auto  &c  = corners[cell];
    const auto  &at = corner_positions;
    const double x = local.x(), y = local.y();
    return (1. - x) * (1. - y) * at[c[0]] + x * (1. - y) * at[c[1]] + (1. - x) * y * at[c[2]] +
           x * y * at[c[3]];
  }


  Eigen::Matrix2d ElementNodes::jacobian(const int cell, const Vec2 &local) const
  {
    const auto &c  = corners[cell];
    const Vec2  p0 = corner_positions[c[0]], p1 = corner_positions[c[1]],
               p2 = corner_positions[c[2]], p3 = corner_positions[c[3]];
    Eigen::Matrix2d j;
    j.col(0) = (1. - local.y()) * (p1 - p0) + local.y() * (p3 - p2);
    j.col(1) = (1. - local.x()) * (p2 - p0) + local.x() * (p3 - p1);
    return j;
  }


  std::vector<double> ElementNodes::values(const Vec2 &local) const
  {
    std::vector<double> result;
    for (int j = 0; j <= line.degree(); ++j)
      for (int i = 0; i <= line.degree(); ++i)
        result.push_back(line.value(i, local.x()) * line.value(j, local.y()));
    return result;
  }


  Eigen::Matrix2d
  ElementNodes::gradient(const int cell, const Vec2 &local, const std::vector<double> &u) const
  {
    const int       n = line.degree() + 1;
    Eigen::Matrix2d g = Eigen::Matrix2d::Zero();
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        {
          const int k = j * n + i;
          g += Vec2(u[2 * k], u[2 * k + 1]) *
               Eigen::RowVector2d(line.derivative(i, local.x()) * line.value(j, local.y()),
                                  line.value(i, local.x()) * line.derivative(j, local.y()));
        }
    return g * jacobian(cell, local).inverse();
  }
} // namespace hybrid::continuum
