// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/lagrange_line.h>
#include <hybrid/continuum/rock_mesh.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Bedding planes that stay elastic, as the 2 x 2 blocks between the nodes of their faces,
   *   int N_i N_j ds (k_n n n^T + k_s t t^T) on one side, with the other sign across,
   * integrated exactly. They are few: of n unknowns of the rock in the order of sqrt(n).
   *
   * A "place" is a position in nodes(); vectors of places hold x and y of each.
   */
  class ElasticJoints
  {
  public:
    /// The nodes along a face, from a to b.
    using Along = std::function<std::vector<int>(const RockFace &)>;

    /// @param degree of the elements
    ElasticJoints(const RockMesh       &rock,
                  const JointStiffness &stiffness,
                  int                   degree,
                  const Along          &along);

    /// Without repetition, in the order of places.
    const std::vector<int> &nodes() const
    {
      return list;
    }

    /// Call @p visit(row, column, block) for what is coupled: places, and a matrix [N/m per m] to
    /// be added.
    template <typename Visit>
    void for_each_block(const Visit &visit) const
    {
      const Eigen::MatrixXd &mass = line.mass();
      const int              n    = static_cast<int>(mass.rows());
      for (const Joint &joint : joints)
        for (int i = 0; i < 2 * n; ++i)
          for (int j = 0; j < 2 * n; ++j)
            visit(joint.places[i],
                  joint.places[j],
                  ((i < n) == (j < n) ? mass(i % n, j % n) : -mass(i % n, j % n)) * joint.spring);
    }

    /// f += K_joints u on the places [N/m].
    void add_product(const std::vector<double> &u, std::vector<double> &f) const;

  private:
    /// Two faces on the two sides of a plane.
    struct Joint
    {
      std::vector<int> places; ///< of the one side, then of the other
      Eigen::Matrix2d  spring; ///< over the face [N/m per m]
    };

    LagrangeLine       line;
    std::vector<Joint> joints;
    std::vector<int>   list;
  };
} // namespace hybrid::continuum
