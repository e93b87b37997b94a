// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_yield.h>
#include <hybrid/scene/material.h>
#include <hybrid/scene/types.h>

#include <Eigen/Core>

namespace hybrid::dda
{
  /// The six unknowns of a first-order block: (u, v, r, ex, ey, gxy) about its centroid [m, m, rad,
  /// -, -, -].
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;


  /// What a block is made of; constant through a run.
  struct BlockProperties
  {
    double mass = 0.; ///< [kg per m thickness]
    double weight =
      0.; ///< mass that gravity acts on [kg/m]; differs from mass for buoyant unit weights
    double pushed_mass =
      0.; ///< mass that the horizontal coefficient acts on [kg/m]; none of the bedrock's blocks
    double weight_at_rest =
      0.; ///< likewise, of a block of the bedrock, whose weight is borne from the start [kg/m]
    double area = 0.;                    ///< initial area A_0 [m2]
    double size = 0.;                    ///< square root of the area [m]
    double sxx = 0., sxy = 0., syy = 0.; ///< initial mass moments about the centroid [kg m2/m]
    Eigen::Matrix3d elasticity =
      Eigen::Matrix3d::Zero();             ///< (xx, yy, xy) stress from (ex, ey, gxy) [Pa]
    BlockStrength strength;                ///< of its inside; unlimited unless blocks yield
    double        damping_time       = 0.; ///< beta_K of stiffness-proportional damping [s]
    double        loose_damping_time = 0.; ///< the least beta_K while no joint holds the block [s]
    double        modulus_factor     = 1.; ///< on the material's Young modulus [-]
    int           region             = 0;  ///< index of the mesh region
    bool          saturated          = false; ///< initial centroid below the water level
  };


  /// Where a block is and how it moves; part of the mutable state.
  struct BlockState
  {
    Vec2   centroid             = Vec2::Zero(); ///< [m]
    double rotation             = 0.;           ///< since the start [rad]
    Vec6   velocity             = Vec6::Zero(); ///< rates of the six unknowns, in the current frame
    Vec6   acceleration         = Vec6::Zero();
    Vec6   contact_acceleration = Vec6::Zero(); ///< contacts' part of it, see Springs
    Vec6   acceleration_change  = Vec6::Zero(); ///< remembered by a Newmark::filter, of all but
                                                ///< contacts; turned with the block
    Vec6 velocity_change = Vec6::Zero();        ///< remembered by a Newmark::velocity_filter while
                                                ///< the block touches others; turned with it
    Eigen::Vector3d stress =
      Eigen::Vector3d::Zero(); ///< elastic (xx, yy, xy) [Pa], tension positive
    Eigen::Vector3d viscous_stress =
      Eigen::Vector3d::Zero(); ///< of the damping, in the last step [Pa]
    double plastic_strain =
      0.; ///< sum of the sizes of plastic shear strain, see shear_strain() [-]
    double rest_plastic_strain = 0.; ///< of it what the static stage has brought [-]
  };


  /**
   * Mass matrix of a first-order block, exact (Shi 1988), with the mass
   * moments turned by @p rotation.
   *
   * Kinetic energy 1/2 v^T M v stays the same to round-off when
   * moments, strain rates and accelerations are turned together: that is how
   * a step ends, so a rotation update neither gains nor loses energy.
   */
  class BlockMass
  {
  public:
    BlockMass() = default;

    BlockMass(const BlockProperties &block, double rotation);

    /// M x
    Vec6 operator*(const Vec6 &x) const
    {
      const double half = 0.5 * sxy, difference = 0.5 * (sxx - syy), sum = sxx + syy;
      Vec6         y;
      y << mass * x[0], mass * x[1], sum * x[2] - sxy * x[3] + sxy * x[4] + difference * x[5],
        sxx * x[3] - sxy * x[2] + half * x[5], syy * x[4] + sxy * x[2] + half * x[5],
        difference * x[2] + half * (x[3] + x[4]) + 0.25 * sum * x[5];
      return y;
    }

    /// M^-1 f
    Vec6 solve(const Vec6 &f) const;

    Mat6 matrix() const;

  private:
    double mass = 0.;                    ///< [kg/m]
    double sxx = 0., sxy = 0., syy = 0.; ///< moments of the mass, turned [kg m]
  };


  /// BlockMass as a matrix.
  Mat6 mass_matrix(const BlockProperties &block, double rotation);


  /**
   * What the joints around a block add to the compliance of a jointed mass:
   * joints of density L_v [1/m] and isotropic directions, in series with the
   * blocks, add L_v / k_n to 1 / (lambda + G) and L_v (1/k_n + 1/k_s) / 2 to
   * 1 / G (mean of n n n n over all directions; for k_n = k_s this is
   * L_v / (2k) on S_1111 and S_2222, nothing on S_1122).
   */
  struct JointCompliance
  {
    double stretch = 0.; ///< [1/Pa]
    double shear   = 0.; ///< [1/Pa]
  };


  /**
   * Plane-strain elasticity of @p material, stiffened so that the jointed
   * mass has the material's wave speeds.
   *
   * @throws InputError if the joints alone are softer than the material.
   */
  Eigen::Matrix3d block_elasticity(const Material &material, const JointCompliance &joints);


  /// 1/2 s : D^-1 : s per area of an isotropic elasticity [J/m2].
  double strain_energy_density(const Eigen::Matrix3d &d, const Eigen::Vector3d &s);


  /// Components (xx, yy, xy) of a symmetric stress tensor, turned by the angle with cosine @p c and
  /// sine @p s.
  Eigen::Vector3d rotated_stress(const Eigen::Vector3d &stress, double c, double s);


  /// Rates of the six unknowns as seen after a rotation: the strain part is turned as a tensor.
  Vec6 rotated_rates(const Vec6 &rates, double c, double s);


  /// Rates that turn with the block: those of its centroid as well.
  Vec6 carried_rates(const Vec6 &rates, double c, double s);
} // namespace hybrid::dda
