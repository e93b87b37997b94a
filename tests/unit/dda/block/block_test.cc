// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double rho = 2220.;

  const std::vector<Vec2> outline{{0., 0.}, {3., 0.5}, {2., 2.}, {0.5, 1.5}};

  BlockProperties properties(const std::vector<Vec2> &points)
  {
    const PolygonMoments m = polygon_moments(points.data(), static_cast<int>(points.size()));
    BlockProperties      p;
    p.area = m.area;
    p.mass = rho * m.area;
    p.sxx  = rho * m.sxx;
    p.sxy  = rho * m.sxy;
    p.syy  = rho * m.syy;
    return p;
  }

  /// Integral of rho T^T T over the polygon: triangles from the first corner, three-point rule
  /// (exact for quadratics).
  Mat6 integrated_mass(const std::vector<Vec2> &points, const Vec2 &centroid)
  {
    Mat6 mass = Mat6::Zero();
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
      {
        const Vec2  &a = points[0], &b = points[k], &c = points[k + 1];
        const double area = 0.5 * cross(b - a, c - a);
        for (const Vec2 &middle : {Vec2(0.5 * (a + b)), Vec2(0.5 * (b + c)), Vec2(0.5 * (c + a))})
          {
            const Vec2                  r = middle - centroid;
            Eigen::Matrix<double, 2, 6> t;
            t << 1., 0., -r.y(), r.x(), 0., 0.5 * r.y(), 0., 1., r.x(), 0., r.y(), 0.5 * r.x();
            mass += rho * area / 3. * t.transpose() * t;
          }
      }
    return mass;
  }

  Material soil()
  {
    Material m;
    m.name          = "soil";
    m.density       = rho;
    m.young_modulus = 50e6;
    m.poisson_ratio = 0.25;
    return m;
  }
} // namespace



TEST(Block, mass_matrix_equals_the_integral)
{
  const PolygonMoments m        = polygon_moments(outline.data(), static_cast<int>(outline.size()));
  const Mat6           expected = integrated_mass(outline, m.centroid);
  EXPECT_LT((mass_matrix(properties(outline), 0.) - expected).norm(), 1e-13 * expected.norm());
}



TEST(Block, mass_matrix_of_a_turned_block_equals_the_integral_over_the_turned_polygon)
{
  const PolygonMoments m     = polygon_moments(outline.data(), static_cast<int>(outline.size()));
  const double         angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  std::vector<Vec2>    turned;
  for (const Vec2 &x : outline)
    {
      const Vec2 r = x - m.centroid;
      turned.emplace_back(c * r.x() - s * r.y(), s * r.x() + c * r.y());
    }
  const Mat6 expected = integrated_mass(turned, Vec2::Zero());
  EXPECT_LT((mass_matrix(properties(outline), angle) - expected).norm(), 1e-13 * expected.norm());
}



TEST(Block, kinetic_energy_does_not_change_when_block_and_rates_turn_together)
{
  const BlockProperties p = properties(outline);
  Vec6                  rates;
  rates << 1., -2., 3., 0.1, -0.2, 0.3;
  const double energy = rates.dot(mass_matrix(p, 0.2) * rates);
  const double c = std::cos(1.1), s = std::sin(1.1);
  Vec6         turned = rotated_rates(rates, c, s);
  EXPECT_NEAR(turned.dot(mass_matrix(p, 1.3) * turned), energy, 1e-13 * energy);
}



TEST(Block, stress_turns_as_a_tensor)
{
  const Eigen::Vector3d uniaxial(1., 0., 0.);
  const double          c = std::cos(0.3), s = std::sin(0.3);
  const Eigen::Vector3d turned = rotated_stress(uniaxial, c, s);
  EXPECT_NEAR(turned[0], c * c, 1e-15);
  EXPECT_NEAR(turned[1], s * s, 1e-15);
  EXPECT_NEAR(turned[2], c * s, 1e-15);
  EXPECT_LT((rotated_stress(turned, c, -s) - uniaxial).norm(), 1e-15);
}



TEST(Block, elasticity_without_joints_is_plane_strain)
{
  const Eigen::Matrix3d d = block_elasticity(soil(), {});
  const double          E = 50e6, nu = 0.25, f = E / ((1. + nu) * (1. - 2. * nu));
  Eigen::Matrix3d       expected;
  expected << f * (1. - nu), f * nu, 0., f * nu, f * (1. - nu), 0., 0., 0., f * (0.5 - nu);
  EXPECT_LT((d - expected).norm(), 1e-14 * expected.norm());
}



TEST(Block, elasticity_and_joint_compliance_in_series_are_the_material)
{
  const double          density = 3., k = 2e9; // 1/m, Pa/m
  const Eigen::Matrix3d d   = block_elasticity(soil(), {density / k, density / k});
  Eigen::Matrix3d       sum = d.inverse();
  sum(0, 0) += density / (2. * k);
  sum(1, 1) += density / (2. * k);
  sum(2, 2) += density / k;
  const Eigen::Matrix3d expected = block_elasticity(soil(), {}).inverse();
  EXPECT_LT((sum - expected).norm(), 1e-13 * expected.norm());
}



TEST(Block, joints_softer_than_the_material_are_refused_with_the_parameters_name)
{
  try
    {
      block_elasticity(soil(), {1., 1.});
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Penalty ratio"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("soil"), std::string::npos);
    }
}
