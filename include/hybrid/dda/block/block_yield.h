// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <limits>

namespace hybrid
{
  struct Material;
}

namespace hybrid::dda
{
  /// Mohr-Coulomb strength of the inside of a block, without softening; unlimited by default.
  struct BlockStrength
  {
    double cohesion = std::numeric_limits<double>::infinity(); ///< c [Pa]
    double sin_phi  = 0.; ///< sine of the friction angle [-], in [0, 1)
    double cos_phi  = 1.; ///< its cosine [-]
    double sin_psi  = 0.; ///< sine of the dilation angle [-], in [0, sin_phi]

    bool is_limited() const
    {
      return cohesion < std::numeric_limits<double>::infinity();
    }
  };

  /// Peak strength of a material with its cohesion times a factor.
  BlockStrength block_strength(const Material &material, double cohesion_factor);


  /// Where a stress is after the return to the yield surface.
  enum class YieldRegion
  {
    elastic, ///< within the strength
    shear,   ///< on the cone
    apex     ///< pulled to its tip: no shear, the isotropic tension c / tan(phi)
  };


  /// What a strained block answers.
  struct YieldResponse
  {
    YieldRegion     region         = YieldRegion::elastic;
    Eigen::Vector3d stress         = Eigen::Vector3d::Zero(); ///< (xx, yy, xy) [Pa]
    Eigen::Vector3d plastic_strain = Eigen::Vector3d::Zero(); ///< added: (ex, ey, gxy) [-]
    Eigen::Matrix3d tangent        = Eigen::Matrix3d::Zero(); ///< of stress by strain [Pa]
  };


  /**
   * Return of a trial stress to the Mohr-Coulomb yield surface in the plane, in closed form
   * (backward Euler; de Souza Neto, Peric and Owen 2008, chapter 8, for the principal stresses in
   * the plane alone).
   *
   * With tension positive, mean stress p = (xx + yy)/2 and radius q of Mohr's circle,
   * @f[ F = q + p \sin\varphi - c \cos\varphi \le 0, \qquad
   *     \dot\gamma^p = \lambda, \quad \dot\epsilon_v^p = \lambda \sin\psi, @f]
   * with the plastic shear strain gamma along the deviator. Isotropic plane-strain elasticity
   * parts into p = K e_v and q = G gamma, so lambda = F_trial / (G + K sin(phi) sin(psi)). Where
   * that leaves no shear (q < 0) the stress goes to the apex.
   *
   * The stress across the plane is taken for the intermediate one. Plastic work
   * lambda (c cos(phi) - p (sin(phi) - sin(psi))) is never negative for psi <= phi.
   *
   * Pure. @param elasticity isotropic, as of block_elasticity() [Pa]
   */
  YieldResponse return_to_yield(const BlockStrength   &strength,
                                const Eigen::Matrix3d &elasticity,
                                const Eigen::Vector3d &trial);


  /// Size of a shear strain (engineering): the diameter of Mohr's circle of (ex, ey, gxy) [-].
  double shear_strain(const Eigen::Vector3d &strain);
} // namespace hybrid::dda
