// SPDX-License-Identifier: GPL-3.0-or-later
// Plane P and S waves through a bonded mass of triangles, structured and jittered.
//
// A strip of triangles between walls that make it a part of an infinite plane wave: smooth walls
// for P (no normal displacement), walls that hold only the tangential displacement for S. The
// initial condition is the right-going plane wave itself: velocities and the stresses that go with
// them, in blocks and joints, so nothing has to be driven.
#include "block_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double size       = 1.;  ///< of a cell of two triangles [m]
  constexpr double wavelength = 28.; ///< dominant: 28 cells, 40 blocks of size sqrt(1/2) m [m]
  constexpr int    length     = 115; ///< cells along the strip
  constexpr int    rows       = 4;   ///< cells across

  /// Two triangles per cell, diagonals alternating; inner nodes moved by up to @p jitter of a cell.
  scene::SectionMesh triangles(const int nx, const int ny, const double jitter)
  {
    scene::SectionMesh                     mesh;
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> shift(-jitter, jitter);
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        {
          const double dx = shift(random), dy = shift(random);
          const bool   inner = i > 0 && i < nx && j > 0 && j < ny;
          mesh.nodes.push_back(size * Vec2(i + (inner ? dx : 0.), j + (inner ? dy : 0.)));
        }
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        {
          const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 2, d = a + nx + 1;
          if ((i + j) % 2 == 0)
            {
              mesh.blocks.push_back({a, b, c});
              mesh.blocks.push_back({a, c, d});
            }
          else
            {
              mesh.blocks.push_back({a, b, d});
              mesh.blocks.push_back({b, c, d});
            }
        }
    mesh.block_region.assign(mesh.blocks.size(), 0);
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }



  /// The lower side from left to right, then the upper side back: the mass lies on the left.
  std::vector<Vec2> walls(const scene::SectionMesh &mesh)
  {
    std::vector<Vec2> nodes(mesh.nodes.begin(), mesh.nodes.begin() + length + 1);
    nodes.insert(nodes.end(), mesh.nodes.rbegin(), mesh.nodes.rbegin() + length + 1);
    return nodes;
  }



  /// Bond the edges on the walls to them: in normal direction only, or in tangential direction
  /// only.
  void add_wall_joints(dda::Model &model, const bool tangential)
  {
    const dda::Geometry &g = model.initial;
    const double         k = 40. * 50e6 / size, none = 1e-9 * k;
    const dda::JointLaw  law(dda::JointStrength::unlimited_bond(),
                            tangential ? none : k,
                            tangential ? k : none);
    for (int v = 0; v < static_cast<int>(g.vertices.size()); ++v)
      for (int n = 0; n + 1 < static_cast<int>(g.base_nodes.size()); ++n)
        if (g.vertices[v] == g.base_nodes[n] && g.vertices[g.next(v)] == g.base_nodes[n + 1])
          model.joints.push_back(
            {g.block_of[v], v, dda::base_body, size, {{0., n}, {1., n + 1}}, law});
  }



  /// Ricker wavelet in space with unit peak [-].
  double ricker(const double x)
  {
    const double a = M_PI * x / wavelength;
    return (1. - 2. * a * a) * std::exp(-a * a);
  }



  struct Arrival
  {
    double time; ///< of the peak [s]
    double peak; ///< [m/s]
  };



  /// Mean velocity of the blocks in a column around x.
  struct Station
  {
    std::vector<int>    blocks;
    std::vector<double> offset; ///< of the centroid from x [m]
    std::vector<double> history;

    /// Highest sample, with a parabola through its neighbours.
    Arrival arrival(const double dt) const
    {
      std::size_t k = 1;
      for (std::size_t i = 1; i + 1 < history.size(); ++i)
        if (history[i] > history[k])
          k = i;
      const double l = history[k - 1], m = history[k], r = history[k + 1];
      const double part = 0.5 * (l - r) / (l - 2. * m + r);
      return {(k + 1 + part) * dt, m - 0.25 * (l - r) * part};
    }
  };



  void check_wave(const bool shear, const double jitter)
  {
    constexpr double       dt = 1e-3, amplitude = 1e-4, start = 40., first = 50., second = 80.;
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.materials["rock"].cohesion         = 1e9;
    p.materials["rock"].tensile_strength = 1e9;
    p.environment.gravity                = 0.;
    const Material &m                    = p.materials["rock"];
    const double    c                    = shear ? m.s_wave_speed() : m.p_wave_speed();
    const double    tail                 = (second - start + 15.) / c; // s

    const scene::SectionMesh mesh = triangles(length, rows, jitter);
    FixedBaseRun             run(mesh, p, walls(mesh));
    add_wall_joints(run.model, shear);
    run.state           = dda::initial_state(run.model);
    const int component = shear ? 1 : 0;
    Station   stations[2];
    for (int b = 0; b < run.model.n_blocks(); ++b)
      {
        dda::BlockState &block    = run.state.blocks[b];
        const double     x        = block.centroid.x();
        const double     v        = amplitude * ricker(x - start);
        block.velocity[component] = v;
        // right-going wave: u' = -v / c
        const double h     = 1e-3,
                     slope = amplitude * (ricker(x + h - start) - ricker(x - h - start)) / (2. * h);
        const double modulus = m.density * c * c;
        // stresses of the continuum; joints carry the same tractions
        if (shear)
          {
            block.stress[2]   = -modulus * v / c;
            block.velocity[2] = 0.5 * slope;
            block.velocity[5] = slope;
          }
        else
          {
            block.stress[0]   = -modulus * v / c;
            block.stress[1]   = -m.lame_lambda() * v / c;
            block.velocity[3] = slope;
          }
        block.acceleration[component] = -c * slope;
        for (int s = 0; s < 2; ++s)
          {
            const double away = x - (s == 0 ? first : second);
            if (std::abs(away) < 1.0 * size)
              {
                stations[s].blocks.push_back(b);
                stations[s].offset.push_back(away);
              }
          }
      }
    // Tractions of the wave in the joints.
    for (std::size_t j = 0; j < run.model.joints.size(); ++j)
      {
        const dda::Joint &joint = run.model.joints[j];
        const Vec2        a     = run.state.geometry.vertices[joint.edge],
                   b            = run.state.geometry.vertices[run.state.geometry.next(joint.edge)];
        const Vec2 t            = (b - a).normalized(), n(t.y(), -t.x());
        for (int end = 0; end < 2; ++end)
          {
            const Vec2      x = a + joint.points[end].position * (b - a);
            const double    e = -amplitude * ricker(x.x() - start) / c;
            Eigen::Matrix2d stress;
            const double    modulus = m.density * c * c;
            if (shear)
              stress << 0., modulus * e, modulus * e, 0.;
            else
              stress << modulus * e, 0., 0., m.lame_lambda() * e;
            const Vec2        traction = stress * n;
            dda::SpringState &point    = run.state.joints[j].points[end];
            point.jump                 = n.dot(traction) / joint.law.normal_stiffness() * n +
                         t.dot(traction) / joint.law.shear_stiffness() * t;
          }
      }
    const int steps = static_cast<int>(tail / dt);
    for (int k = 0; k < steps; ++k)
      {
        ASSERT_TRUE(run.advance(dt, 0));
        for (Station &s : stations)
          {
            double sum = 0.;
            for (const int b : s.blocks)
              sum += run.state.blocks[b].velocity[component];
            s.history.push_back(sum / static_cast<double>(s.blocks.size()));
          }
      }
    double distance = second - first;
    for (int s = 0; s < 2; ++s)
      for (const double away : stations[s].offset)
        distance += (s == 0 ? -1. : 1.) * away / static_cast<double>(stations[s].blocks.size());
    const Arrival one = stations[0].arrival(dt), two = stations[1].arrival(dt);
    const double  expected = distance / c;
    EXPECT_NEAR(two.time - one.time, expected, 0.01 * expected);
    EXPECT_NEAR(two.peak, one.peak, 0.02 * one.peak);
    EXPECT_NEAR(one.peak, amplitude, 0.04 * amplitude);
  }
} // namespace



TEST(BlockWave, pressure_wave_through_structured_triangles)
{
  check_wave(false, 0.);
}



TEST(BlockWave, pressure_wave_through_unstructured_triangles)
{
  check_wave(false, 0.25);
}



TEST(BlockWave, shear_wave_through_structured_triangles)
{
  check_wave(true, 0.);
}



TEST(BlockWave, shear_wave_through_unstructured_triangles)
{
  check_wave(true, 0.25);
}
