// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using Eigen::Vector3d;

  Material soil(const double phi, const double psi)
  {
    Material m;
    m.young_modulus  = 2e7;
    m.poisson_ratio  = 0.3;
    m.cohesion       = 1e4;
    m.friction_angle = phi;
    m.dilation_angle = psi;
    return m;
  }

  struct Soil
  {
    Material        material;
    BlockStrength   strength;
    Eigen::Matrix3d elasticity;

    explicit Soil(const double phi, const double psi = 0.)
      : material(soil(phi, psi))
      , strength(block_strength(material, 1.))
      , elasticity(block_elasticity(material, {}))
    {}

    YieldResponse operator()(const Vector3d &trial) const
    {
      return return_to_yield(strength, elasticity, trial);
    }

    double radians(const double degrees) const
    {
      return degrees * M_PI / 180.;
    }

    /// F / (c cos phi): positive beyond the strength.
    double excess(const Vector3d &s) const
    {
      const double q = std::hypot(0.5 * (s[0] - s[1]), s[2]);
      const double c = strength.cohesion * strength.cos_phi;
      return (q + 0.5 * (s[0] + s[1]) * strength.sin_phi - c) / c;
    }
  };

  /// Stresses of all kinds, from deep compression to tension.
  std::vector<Vector3d> stresses()
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> size(-1e5, 1e5);
    std::vector<Vector3d>                  result;
    for (int k = 0; k < 300; ++k)
      result.push_back({size(random), size(random), size(random)});
    return result;
  }
} // namespace



TEST(BlockYield, unlimited_strength_is_the_default)
{
  EXPECT_FALSE(BlockStrength{}.is_limited());
  EXPECT_TRUE(Soil(20.).strength.is_limited());
}



TEST(BlockYield, within_the_strength_nothing_changes)
{
  const Soil          earth(20.);
  const Vector3d      s(-3e4, -2e4, 2e3);
  const YieldResponse r = earth(s);
  EXPECT_EQ(r.region, YieldRegion::elastic);
  EXPECT_EQ(r.stress, s);
  EXPECT_EQ(r.plastic_strain, Vector3d(Vector3d::Zero()));
  EXPECT_EQ(r.tangent, earth.elasticity);
}



TEST(BlockYield, biaxial_compression_reaches_the_strength_of_mohr_coulomb)
{
  // Compressed along y with the lateral stress held: s1 = s3 K_p + 2 c sqrt(K_p).
  for (const double psi : {0., 10., 20.})
    {
      const Soil   earth(20., psi);
      const double lateral = 3e4;
      const double passive =
        std::pow(std::tan(earth.radians(45. + 0.5 * earth.material.friction_angle)), 2);
      Vector3d stress(-lateral, -lateral, 0.), strain = Vector3d::Zero();
      Vector3d plastic = Vector3d::Zero();
      for (int step = 0; step < 50; ++step)
        {
          Vector3d increment(0., -4e-4, 0.);
          for (int iteration = 0; iteration < 20; ++iteration) // ex so that s_xx stays
            {
              const YieldResponse r = earth(stress + earth.elasticity * increment);
              if (std::abs(r.stress[0] + lateral) < 1e-6)
                break;
              increment[0] -= (r.stress[0] + lateral) / r.tangent(0, 0);
            }
          const YieldResponse r = earth(stress + earth.elasticity * increment);
          stress                = r.stress;
          strain += increment;
          plastic += r.plastic_strain;
        }
      const double expected = lateral * passive + 2. * earth.material.cohesion * std::sqrt(passive);
      EXPECT_NEAR(-stress[1], expected, 1e-9 * expected);
      EXPECT_NEAR(stress[0], -lateral, 1e-5);
      // It grows by sin(psi) of its shear.
      EXPECT_NEAR(plastic[0] + plastic[1],
                  std::sin(earth.radians(psi)) * shear_strain(plastic),
                  1e-12);
      EXPECT_GT(plastic[0] - plastic[1], 0.01);
    }
}



TEST(BlockYield, simple_shear_reaches_the_radius_of_the_cone)
{
  const Soil          earth(25.);
  const double        p = -5e4;
  const YieldResponse r = earth(Vector3d(p, p, 0.) + earth.elasticity * Vector3d(0., 0., 0.02));
  const double q = earth.material.cohesion * earth.strength.cos_phi - p * earth.strength.sin_phi;
  EXPECT_EQ(r.region, YieldRegion::shear);
  EXPECT_NEAR(r.stress[2], q, 1e-9 * q);
  EXPECT_NEAR(r.stress[0], p, 1e-9 * q); // no dilation: the mean stress stays
  EXPECT_NEAR(r.plastic_strain[2], 0.02 - q / earth.elasticity(2, 2), 1e-12);
}



TEST(BlockYield, without_friction_it_is_trescas)
{
  const Soil earth(0.);
  for (const Vector3d &s : stresses())
    {
      const YieldResponse r = earth(s);
      EXPECT_NEAR(r.stress[0] + r.stress[1], s[0] + s[1], 1e-7);
      const double q = std::hypot(0.5 * (r.stress[0] - r.stress[1]), r.stress[2]);
      EXPECT_LE(q, earth.material.cohesion * (1. + 1e-12));
      EXPECT_NE(r.region, YieldRegion::apex);
    }
}



TEST(BlockYield, isotropic_tension_ends_at_the_apex)
{
  const Soil          earth(20.);
  const YieldResponse r    = earth({1e5, 1e5, 10.});
  const double        apex = earth.material.cohesion / std::tan(earth.radians(20.));
  EXPECT_EQ(r.region, YieldRegion::apex);
  EXPECT_LT((r.stress - Vector3d(apex, apex, 0.)).norm(), 1e-9 * apex);
  EXPECT_EQ(r.tangent, Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}



TEST(BlockYield, the_return_ends_on_the_surface_and_strains_add_up)
{
  int seen[3] = {0, 0, 0};
  for (const double phi : {5., 20., 45.})
    for (const double psi : {0., 0.5 * phi, phi})
      {
        const Soil earth(phi, psi);
        for (const Vector3d &s : stresses())
          {
            const YieldResponse r = earth(s);
            ++seen[static_cast<int>(r.region)];
            if (r.region == YieldRegion::elastic)
              continue;
            EXPECT_NEAR(earth.excess(r.stress), 0., 1e-12 * (1. + s.norm() / 1e4));
            const Vector3d back = s - r.stress - earth.elasticity * r.plastic_strain;
            EXPECT_LT(back.norm(), 1e-10 * s.norm());
            EXPECT_GE(r.stress.dot(r.plastic_strain), 0.) << "plastic work";
            const YieldResponse again = earth((1. - 1e-9) * r.stress);
            EXPECT_LT((again.stress - r.stress).norm(), 1e-8 * s.norm()); // a projection
          }
      }
  for (const int count : seen)
    EXPECT_GT(count, 50);
}



TEST(BlockYield, the_tangent_is_the_derivative)
{
  for (const double psi : {0., 10., 20.})
    {
      const Soil earth(20., psi);
      for (const Vector3d &s : stresses())
        {
          const YieldResponse r = earth(s);
          constexpr double    h = 1e-8;
          for (int k = 0; k < 3; ++k)
            {
              const Vector3d      strain = h * Vector3d::Unit(k);
              const YieldResponse more   = earth(s + earth.elasticity * strain);
              const YieldResponse less   = earth(s - earth.elasticity * strain);
              if (more.region != r.region || less.region != r.region)
                continue;
              const Vector3d difference = (more.stress - less.stress) / (2. * h);
              EXPECT_LT((difference - r.tangent.col(k)).norm(), 1e-5 * earth.elasticity.norm());
            }
        }
    }
  // Associated flow has a potential.
  const YieldResponse r = Soil(20., 20.)({-2e4, -9e4, 1e4});
  EXPECT_EQ(r.region, YieldRegion::shear);
  EXPECT_LT((r.tangent - r.tangent.transpose()).norm(), 1e-9 * r.tangent.norm());
}



TEST(BlockYield, it_does_not_know_the_axes)
{
  const Soil   earth(30., 7.);
  const double angle = 0.7;
  for (const Vector3d &s : stresses())
    {
      const Vector3d turned = rotated_stress(s, std::cos(angle), std::sin(angle));
      const Vector3d back   = rotated_stress(earth(s).stress, std::cos(angle), std::sin(angle));
      EXPECT_LT((earth(turned).stress - back).norm(), 1e-9 * s.norm());
    }
}
