// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block.h>
#include <hybrid/scene/input_error.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::dda
{
  namespace
  {
    constexpr double max_joints = 5.; ///< the material's compliance over a sound share of joints
  }



  BlockMass::BlockMass(const BlockProperties &block, const double rotation)
    : mass(block.mass)
  {
    const double c = std::cos(rotation), s = std::sin(rotation);
    sxx = c * c * block.sxx - 2. * c * s * block.sxy + s * s * block.syy;
    syy = s * s * block.sxx + 2. * c * s * block.sxy + c * c * block.syy;
    sxy = c * s * (block.sxx - block.syy) + (c * c - s * s) * block.sxy;
  }



  Vec6 BlockMass::solve(const Vec6 &f) const
  {
    return matrix().llt().solve(f);
  }



  Mat6 BlockMass::matrix() const
  {
    Mat6 m  = Mat6::Zero();
    m(0, 0) = m(1, 1) = mass;
    m(2, 2)           = sxx + syy;
    m(2, 3) = m(3, 2) = -sxy;
    m(2, 4) = m(4, 2) = sxy;
    m(2, 5) = m(5, 2) = 0.5 * (sxx - syy);
    m(3, 3)           = sxx;
    m(3, 5) = m(5, 3) = 0.5 * sxy;
    m(4, 4)           = syy;
    m(4, 5) = m(5, 4) = 0.5 * sxy;
    m(5, 5)           = 0.25 * (sxx + syy);
    return m;
  }



  Mat6 mass_matrix(const BlockProperties &block, const double rotation)
  {
    return BlockMass(block, rotation).matrix();
  }



  Eigen::Matrix3d block_elasticity(const Material &material, const JointCompliance &joints)
  {
    // The two eigenvalues of isotropic plane strain, as compliances.
    const double shear = 1. / material.shear_modulus() - joints.shear;
    const double stretch =
      1. / (material.lame_lambda() + material.shear_modulus()) - joints.stretch;
    if (shear <= 0. || stretch <= 0.)
      {
        // The joints' compliance falls as the ratio grows.
        const double factor =
          std::max(joints.shear * material.shear_modulus(),
                   joints.stretch * (material.lame_lambda() + material.shear_modulus()));
        std::ostringstream text;
        text.precision(3);
        text << "Blocks/Penalty ratio: the joints alone are softer than the material '"
             << material.name << "', so no block stiffness gives its wave speeds; a ratio "
             << max_joints * factor << " times as large would do";
        throw InputError(text.str());
      }

    const double    g = 1. / shear, bulk = 1. / stretch;
    Eigen::Matrix3d d = Eigen::Matrix3d::Zero();
    d(0, 0) = d(1, 1) = bulk + g;
    d(0, 1) = d(1, 0) = bulk - g;
    d(2, 2)           = g;
    return d;
  }



  double strain_energy_density(const Eigen::Matrix3d &d, const Eigen::Vector3d &s)
  {
    const double determinant = d(0, 0) * d(0, 0) - d(0, 1) * d(0, 1);
    const double ex          = (d(0, 0) * s[0] - d(0, 1) * s[1]) / determinant;
    const double ey          = (d(0, 0) * s[1] - d(0, 1) * s[0]) / determinant;
    return 0.5 * (s[0] * ex + s[1] * ey + s[2] * s[2] / d(2, 2));
  }



  Eigen::Vector3d rotated_stress(const Eigen::Vector3d &stress, const double c, const double s)
  {
    const double xx = stress[0], yy = stress[1], xy = stress[2];
    return {c * c * xx + s * s * yy - 2. * c * s * xy,
            s * s * xx + c * c * yy + 2. * c * s * xy,
            c * s * (xx - yy) + (c * c - s * s) * xy};
  }



  Vec6 rotated_rates(const Vec6 &rates, const double c, const double s)
  {
    const Eigen::Vector3d strain = rotated_stress({rates[3], rates[4], 0.5 * rates[5]}, c, s);
    Vec6                  result = rates;
    result[3]                    = strain[0];
    result[4]                    = strain[1];
    result[5]                    = 2. * strain[2];
    return result;
  }


  Vec6 carried_rates(const Vec6 &rates, const double c, const double s)
  {
    Vec6 result = rotated_rates(rates, c, s);
    result[0]   = c * rates[0] - s * rates[1];
    result[1]   = s * rates[0] + c * rates[1];
    return result;
  }
} // namespace hybrid::dda
