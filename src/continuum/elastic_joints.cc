// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/elastic_joints.h>

#include <map>

namespace hybrid::continuum
{
  ElasticJoints::ElasticJoints(const RockMesh       &rock,
                               const JointStiffness &stiffness,
                               const int             degree,
                               const Along          &along)
    : line(degree)
  {
    std::map<int, int> place_of;
    for (const FacePair &pair : rock.joints)
      {
        const Vec2   edge   = rock.nodes[pair.first.b] - rock.nodes[pair.first.a];
        const double length = edge.norm();
        const Vec2   t      = edge / length, normal(t.y(), -t.x());
        Joint        joint{{},
                    length * (stiffness.normal * normal * normal.transpose() +
                              stiffness.shear * t * t.transpose())};
        for (const RockFace &side : {pair.first, pair.second})
          for (const int node : along(side))
            {
              const auto [at, is_new] = place_of.insert({node, static_cast<int>(list.size())});
              if (is_new)
                list.push_back(node);
              joint.places.push_back(at->second);
            }
        joints.push_back(std::move(joint));
      }
  }



  void ElasticJoints::add_product(const std::vector<double> &u, std::vector<double> &f) const
  {
    for_each_block([&](const int row, const int column, const Eigen::Matrix2d &block) {
      for (int c = 0; c < 2; ++c)
        f[2 * row + c] += block(c, 0) * u[2 * column] + block(c, 1) * u[2 * column + 1];
    });
  }
} // namespace hybrid::continuum
