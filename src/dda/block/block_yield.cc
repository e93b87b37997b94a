// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block_yield.h>
#include <hybrid/scene/material.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Columns: what (p, (xx - yy)/2, xy) make of (xx, yy, xy).
    Eigen::Matrix3d from_invariants()
    {
      Eigen::Matrix3d t;
      t << 1., 1., 0., 1., -1., 0., 0., 0., 1.;
      return t;
    }



    /// Derivative on the cone, of (p, s) by (e_v, g): the strains that belong to p and to the
    /// deviator s = q n.
    Eigen::Matrix3d cone_tangent(const BlockStrength   &strength,
                                 const double           bulk,
                                 const double           shear,
                                 const Eigen::Vector2d &n,
                                 const double           kept)
    {
      const double hardness = shear + bulk * strength.sin_phi * strength.sin_psi;
      const double by_v = bulk * strength.sin_phi / hardness, by_n = shear / hardness; // of lambda
      Eigen::Matrix3d t;
      t(0, 0)                    = bulk * (1. - strength.sin_psi * by_v);
      t.topRightCorner<1, 2>()   = -bulk * strength.sin_psi * by_n * n.transpose();
      t.bottomLeftCorner<2, 1>() = -shear * by_v * n;
      const Eigen::Matrix2d nn   = n * n.transpose();
      t.bottomRightCorner<2, 2>() =
        shear * (kept * (Eigen::Matrix2d::Identity() - nn) + (1. - by_n) * nn);
      return t;
    }
  } // namespace



  BlockStrength block_strength(const Material &material, const double cohesion_factor)
  {
    constexpr double degree = M_PI / 180.;
    BlockStrength    s;
    s.cohesion = cohesion_factor * material.cohesion;
    s.sin_phi  = std::sin(degree * material.friction_angle);
    s.cos_phi  = std::cos(degree * material.friction_angle);
    s.sin_psi  = std::sin(degree * material.dilation_angle);
    return s;
  }



  YieldResponse return_to_yield(const BlockStrength   &strength,
                                const Eigen::Matrix3d &elasticity,
                                const Eigen::Vector3d &trial)
  {
    YieldResponse r;
    r.stress                = trial;
    r.tangent               = elasticity;
    const double          p = 0.5 * (trial[0] + trial[1]);
    const Eigen::Vector2d s(0.5 * (trial[0] - trial[1]), trial[2]);
    const double          q = s.norm();
    const double          f = q + p * strength.sin_phi - strength.cohesion * strength.cos_phi;
    if (!(f > 0.))
      return r;

    const double bulk = 0.5 * (elasticity(0, 0) + elasticity(0, 1)), shear = elasticity(2, 2);
    const double lambda   = f / (shear + bulk * strength.sin_phi * strength.sin_psi);
    double       stretch  = lambda * strength.sin_psi; // plastic e_v
    double       radius   = q - shear * lambda;
    const auto   in_plane = from_invariants();
    if (radius >= 0. || strength.sin_phi == 0.)
      {
        r.region                = YieldRegion::shear;
        radius                  = std::max(radius, 0.);
        const Eigen::Vector2d n = s / q;
        r.tangent =
          in_plane * cone_tangent(strength, bulk, shear, n, radius / q) * in_plane.transpose();
      }
    else
      {
        r.region = YieldRegion::apex;
        radius   = 0.;
        stretch  = (p - strength.cohesion * strength.cos_phi / strength.sin_phi) / bulk;
        r.tangent.setZero();
      }
    const Eigen::Vector2d deviator = q > 0. ? Eigen::Vector2d(radius / q * s) : Eigen::Vector2d(s);
    const Eigen::Vector2d glide    = (s - deviator) / shear; // plastic (ex - ey, gxy)
    r.plastic_strain = {0.5 * (stretch + glide[0]), 0.5 * (stretch - glide[0]), glide[1]};
    r.stress         = in_plane * Eigen::Vector3d(p - bulk * stretch, deviator[0], deviator[1]);
    return r;
  }



  double shear_strain(const Eigen::Vector3d &strain)
  {
    return std::hypot(strain[0] - strain[1], strain[2]);
  }
} // namespace hybrid::dda
