// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/bedding_planes.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hybrid::continuum
{
  BeddingPlanes::BeddingPlanes(const RockMesh       &rock,
                               const ElementNodes   &nodes,
                               const JointStiffness &stiffness)
    : line(nodes.line)
    , k(stiffness)
    , n(nodes.line.degree() + 1)
  {
    const auto &rule = line.quadrature();
    for (const auto &point : rule.get_points())
      for (int i = 0; i < n; ++i)
        shape.push_back(line.value(i, point[0]));

    std::map<std::array<int, 2>, int> number;
    for (const auto &joint : rock.joints)
      {
        RockFace left = joint.first, right = joint.second;
        Vec2     along = rock.nodes[left.b] - rock.nodes[left.a];
        if (along.x() < 0. || (along.x() == 0. && along.y() < 0.))
          {
            std::swap(left, right);
            std::swap(left.a, left.b);
            std::swap(right.a, right.b);
            along = -along;
          }
        const auto l = nodes.along(left), r = nodes.along(right);
        const int  first = static_cast<int>(pair_of.size());
        for (int i = 0; i < n; ++i)
          {
            if (l[i] == r[i])
              {
                pair_of.push_back(-1);
                continue;
              }
            const auto found = number.emplace(std::array<int, 2>{l[i], r[i]}, pairs.size());
            if (found.second)
              pairs.push_back({l[i], r[i]});
            pair_of.push_back(found.first->second);
          }
        const Vec2 tangent = along / along.norm(), normal(-tangent.y(), tangent.x());
        for (int q = 0; q < n; ++q)
          gauss.push_back({rock.nodes[left.a] + rule.point(q)[0] * along,
                           tangent,
                           normal,
                           rule.weight(q) * along.norm(),
                           joint.plane,
                           q,
                           first});
      }
  }


  void BeddingPlanes::jumps(const std::vector<double> &u, std::vector<double> &jump) const
  {
    for (std::size_t g = 0; g < gauss.size(); ++g)
      {
        const Point &point = gauss[g];
        Vec2         sum(0., 0.);
        for (int i = 0; i < n; ++i)
          if (const int pair = pair_of[point.first + i]; pair >= 0)
            {
              const int l = 2 * pairs[pair][0], r = 2 * pairs[pair][1];
              sum += shape[point.sample * n + i] * Vec2(u[l] - u[r], u[l + 1] - u[r + 1]);
            }
        jump[2 * g]     = sum.dot(point.normal);
        jump[2 * g + 1] = sum.dot(point.tangent);
      }
  }


  double BeddingPlanes::largest_displacement(const std::vector<double> &u) const
  {
    double result = 0.;
    for (const auto &pair : pairs)
      for (const int node : pair)
        result = std::max({result, std::abs(u[2 * node]), std::abs(u[2 * node + 1])});
    return result;
  }


  void BeddingPlanes::tractions(const std::vector<double> &jump,
                                std::vector<double>       &traction) const
  {
    for (std::size_t g = 0; g < gauss.size(); ++g)
      {
        traction[2 * g]     = k.normal * jump[2 * g];
        traction[2 * g + 1] = k.shear * jump[2 * g + 1];
      }
  }


  void BeddingPlanes::add_forces(const std::vector<double> &traction,
                                 const double               factor,
                                 std::vector<double>       &force) const
  {
    for (std::size_t g = 0; g < gauss.size(); ++g)
      {
        const Point &point = gauss[g];
        const Vec2   f     = factor * point.length *
                       (traction[2 * g] * point.normal + traction[2 * g + 1] * point.tangent);
        for (int i = 0; i < n; ++i)
          if (const int pair = pair_of[point.first + i]; pair >= 0)
            for (int c = 0; c < 2; ++c)
              {
                force[2 * pairs[pair][0] + c] += shape[point.sample * n + i] * f[c];
                force[2 * pairs[pair][1] + c] -= shape[point.sample * n + i] * f[c];
              }
      }
  }


  void BeddingPlanes::add_stiffness(const NodeMatrices  &matrices,
                                    const double         factor,
                                    std::vector<double> &blocks) const
  {
    for (const auto &point : gauss)
      {
        const Eigen::Matrix2d spring = factor * point.length *
                                       (k.normal * point.normal * point.normal.transpose() +
                                        k.shear * point.tangent * point.tangent.transpose());
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            {
              const int a = pair_of[point.first + i], b = pair_of[point.first + j];
              if (a < 0 || b < 0)
                continue;
              const double both = shape[point.sample * n + i] * shape[point.sample * n + j];
              for (int s = 0; s < 4; ++s)
                {
                  const int entry = matrices.entry(pairs[a][s / 2], pairs[b][s % 2]);
                  for (int c = 0; c < 4; ++c)
                    blocks[4 * entry + c] += (s / 2 == s % 2 ? both : -both) * spring(c / 2, c % 2);
                }
            }
      }
  }


  Eigen::MatrixXd BeddingPlanes::jump_matrix() const
  {
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(2 * gauss.size(), 2 * pairs.size());
    for (std::size_t g = 0; g < gauss.size(); ++g)
      for (int i = 0; i < n; ++i)
        if (const int pair = pair_of[gauss[g].first + i]; pair >= 0)
          {
            b.block<1, 2>(2 * g, 2 * pair) +=
              shape[gauss[g].sample * n + i] * gauss[g].normal.transpose();
            b.block<1, 2>(2 * g + 1, 2 * pair) +=
              shape[gauss[g].sample * n + i] * gauss[g].tangent.transpose();
          }
    return b;
  }


  Eigen::MatrixXd BeddingPlanes::relaxation(const Eigen::MatrixXd &compliance) const
  {
    const Eigen::MatrixXd b = jump_matrix();
    Eigen::VectorXd       d(2 * gauss.size()), w(2 * gauss.size());
    for (std::size_t g = 0; g < gauss.size(); ++g)
      {
        d[2 * g]     = k.normal;
        d[2 * g + 1] = k.shear;
        w[2 * g] = w[2 * g + 1] = gauss[g].length;
      }
    const Eigen::MatrixXd part = b * compliance;
    Eigen::MatrixXd       g    = -(part * b.transpose());
    g                          = d.asDiagonal() * g;
    g                          = g * (w.cwiseProduct(d)).asDiagonal();
    g.diagonal() += d;
    return g;
  }
} // namespace hybrid::continuum
