// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/elastic_assembly.h>

#include "rectangle_mesh.h"

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  /// 3 x 2 cells on 6 m x 4 m with a crooked inner node and a joint at y = 2.
  struct Fixture
  {
    explicit Fixture(const int degree, const bool joint = false)
      : section(
          test::rectangle_mesh(test::equal_spacing(0., 6., 3), test::equal_spacing(0., 4., 2)))
    {
      section.nodes[5] += Vec2(0.4, joint ? 0. : 0.3);
      section.lines["bedding_1"] = {{4, 5}, {5, 6}, {6, 7}};
      rock                       = split_bedding_planes(section,
                                  joint ? std::vector<std::string>{"bedding_1"}
                                                              : std::vector<std::string>{});
      space = std::make_unique<ElementSpace>(rock, section, degree, MPI_COMM_WORLD);
      material.assign(6, test::rock_material());
      matrices = assemble_elastic(*space, rock, material, {8e9, 3e9});
    }

    template <typename Field>
    std::vector<double> interpolate(const Field &field) const
    {
      std::vector<double> x;
      for (const Vec2 &p : space->nodes.positions)
        {
          const Vec2 u = field(p);
          x.push_back(u.x());
          x.push_back(u.y());
        }
      return x;
    }

    double energy(const std::vector<double> &x) const
    {
      std::vector<double> y(x.size());
      matrices.multiply_stiffness(x.data(), y.data());
      double sum = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += 0.5 * x[i] * y[i];
      return sum;
    }

    scene::SectionMesh            section;
    RockMesh                      rock;
    std::unique_ptr<ElementSpace> space;
    std::vector<Material>         material;
    NodeMatrices                  matrices;
  };
} // namespace


TEST(ElasticAssembly, nodes_of_all_degrees)
{
  for (const int p : {1, 2, 3, 4})
    {
      const Fixture f(p);
      EXPECT_EQ(f.space->nodes.size(), (3 * p + 1) * (2 * p + 1));
      const auto nodes = f.space->nodes.along({0, 0, 1});
      ASSERT_EQ(static_cast<int>(nodes.size()), p + 1);
      for (int i = 0; i <= p; ++i)
        EXPECT_NEAR(f.space->nodes.positions[nodes[i]].x(),
                    2. * f.space->nodes.line.nodes()[i],
                    1e-14);
    }
}


TEST(ElasticAssembly, mass_of_the_section)
{
  for (const int p : {1, 2, 4})
    {
      const Fixture f(p);
      double        sum = 0.;
      for (const double m : f.matrices.mass)
        sum += m;
      EXPECT_NEAR(sum, 2000. * 24., 1e-8);
    }
}


TEST(ElasticAssembly, rigid_motion_has_no_energy)
{
  const Fixture f(3);
  const auto    scale = f.energy(f.interpolate([](const Vec2 &p) { return Vec2(p.x(), 0.); }));
  EXPECT_LT(std::abs(f.energy(f.interpolate([](const Vec2 &) { return Vec2(1., 2.); }))),
            1e-12 * scale);
  EXPECT_LT(std::abs(f.energy(f.interpolate([](const Vec2 &p) { return Vec2(-p.y(), p.x()); }))),
            1e-11 * scale);
}


TEST(ElasticAssembly, uniform_strain_energy)
{
  const Material rock = test::rock_material();
  for (const int p : {1, 2, 3})
    {
      const Fixture f(p);
      const double  e    = 1e-3;
      const double  m    = rock.lame_lambda() + 2. * rock.shear_modulus();
      const auto    bulk = f.interpolate([&](const Vec2 &x) { return Vec2(e * x.x(), 0.); });
      EXPECT_NEAR(f.energy(bulk) / (0.5 * m * e * e * 24.), 1., 1e-12);
      const auto shear = f.interpolate([&](const Vec2 &x) { return Vec2(e * x.y(), 0.); });
      EXPECT_NEAR(f.energy(shear) / (0.5 * rock.shear_modulus() * e * e * 24.), 1., 1e-12);
      const Eigen::Matrix2d g = f.space->nodes.gradient(0, Vec2(0.3, 0.8), shear);
      EXPECT_NEAR(g(0, 1), e, 1e-15);
      EXPECT_NEAR(g(1, 0), 0., 1e-15);
    }
}


TEST(ElasticAssembly, joint_energy)
{
  const Fixture f(2, true);
  EXPECT_EQ(f.space->nodes.size(), 7 * 3 * 2);
  // The upper half moves rigidly by (1, 2) mm: 1/2 (k_s 1^2 + k_n 2^2) 6 m.
  std::vector<double> x(2 * f.space->nodes.size(), 0.);
  for (int cell = 3; cell < 6; ++cell)
    for (const int node : f.space->nodes.cells[cell])
      {
        x[2 * node]     = 1e-3;
        x[2 * node + 1] = 2e-3;
      }
  EXPECT_NEAR(f.energy(x), 0.5 * (3e9 * 1e-6 + 8e9 * 4e-6) * 6., 1e-6);
}
