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

  constexpr double size       = 1.;   ///< of a cell of two triangles [m]
  constexpr double wavelength = 28.;  ///< dominant: 28 cells, 40 blocks of size sqrt(1/2) m [m]
  constexpr int    length     = 115;  ///< cells along the strip
  constexpr int    rows       = 4;    ///< cells across
  constexpr double dt         = 1e-3; ///< [s]
  constexpr double amplitude  = 1e-4; ///< of the velocity [m/s]
  constexpr double start      = 40.;  ///< middle of the wave at first [m]
  constexpr double places[]   = {50., 80.}; ///< of the stations [m]

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
      for (int n = 0; n + 1 < static_cast<int>(g.foundation_nodes.size()); ++n)
        if (g.vertices[v] == g.foundation_nodes[n] &&
            g.vertices[g.next(v)] == g.foundation_nodes[n + 1])
          model.joints.push_back(
            {g.block_of[v], v, dda::foundation_body, size, {{0., n}, {1., n + 1}}, law});
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

    /// Mean place of the blocks [m].
    double middle(const double place) const
    {
      double sum = 0.;
      for (const double away : offset)
        sum += away;
      return place + sum / static_cast<double>(offset.size());
    }

    void record(const dda::DdaState &state, const int component)
    {
      double sum = 0.;
      for (const int b : blocks)
        sum += state.blocks[b].velocity[component];
      history.push_back(sum / static_cast<double>(blocks.size()));
    }

    /// Highest sample, with a parabola through its neighbours.
    Arrival arrival() const
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



  scene::SceneParameters strong_rock()
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.materials["rock"].cohesion         = 1e9;
    p.materials["rock"].tensile_strength = 1e9;
    p.environment.gravity                = 0.;
    return p;
  }



  /// Plane wave to the right: u' = -v / c, and the stresses of the continuum.
  struct PlaneWave
  {
    Material material;
    bool     shear;

    double speed() const
    {
      return shear ? material.s_wave_speed() : material.p_wave_speed();
    }

    double velocity(const double x) const
    {
      return amplitude * ricker(x - start);
    }

    /// s_xx, s_yy, s_xy [Pa].
    Eigen::Vector3d stress(const double x) const
    {
      const double strain  = -velocity(x) / speed();
      const double modulus = material.density * speed() * speed();
      return shear ? Eigen::Vector3d(0., 0., modulus * strain)
                   : Eigen::Vector3d(modulus * strain, material.lame_lambda() * strain, 0.);
    }

    void put_into(dda::BlockState &block) const
    {
      constexpr double h     = 1e-3; // m
      const double     x     = block.centroid.x();
      const double     slope = (velocity(x + h) - velocity(x - h)) / (2. * h);
      const int        along = shear ? 1 : 0;
      block.velocity[along]  = velocity(x);
      block.stress           = stress(x);
      if (shear)
        block.velocity[2] = 0.5 * slope;
      block.velocity[shear ? 5 : 3] = slope;
      block.acceleration[along]     = -speed() * slope;
    }

    /// Jumps that carry the tractions of the wave.
    void put_into(const dda::Joint    &joint,
                  const dda::Geometry &geometry,
                  dda::JointState     &joint_state) const
    {
      const Vec2 a = geometry.vertices[joint.edge],
                 b = geometry.vertices[geometry.next(joint.edge)];
      const Vec2 t = (b - a).normalized(), n(t.y(), -t.x());
      for (int end = 0; end < 2; ++end)
        {
          const Vec2            x = a + joint.points[end].position * (b - a);
          const Eigen::Vector3d s = stress(x.x());
          const Vec2            traction(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y());
          joint_state.points[end].jump = n.dot(traction) / joint.law.normal_stiffness() * n +
                                         t.dot(traction) / joint.law.shear_stiffness() * t;
        }
    }
  };



  /// Blocks with their middle within a cell of @p place.
  Station station_at(const double place, const dda::DdaState &state)
  {
    Station station;
    for (std::size_t b = 0; b < state.blocks.size(); ++b)
      {
        const double away = state.blocks[b].centroid.x() - place;
        if (std::abs(away) < size)
          {
            station.blocks.push_back(b);
            station.offset.push_back(away);
          }
      }
    return station;
  }



  void check_wave(const bool shear, const double jitter)
  {
    const scene::SceneParameters p    = strong_rock();
    const scene::SectionMesh     mesh = triangles(length, rows, jitter);
    const PlaneWave              wave{p.materials.at("rock"), shear};
    FixedBaseRun                 run(mesh, p, walls(mesh));
    add_wall_joints(run.model, shear);
    run.state           = dda::initial_state(run.model);
    Station stations[2] = {station_at(places[0], run.state), station_at(places[1], run.state)};
    for (dda::BlockState &block : run.state.blocks)
      wave.put_into(block);
    for (std::size_t j = 0; j < run.model.joints.size(); ++j)
      wave.put_into(run.model.joints[j], run.state.geometry, run.state.joints[j]);

    const double tail = (places[1] - start + 15.) / wave.speed(); // s
    for (int k = 0; k < static_cast<int>(tail / dt); ++k)
      {
        ASSERT_TRUE(run.advance(dt, 0));
        for (Station &station : stations)
          station.record(run.state, shear ? 1 : 0);
      }
    const double  distance = stations[1].middle(places[1]) - stations[0].middle(places[0]);
    const Arrival one = stations[0].arrival(), two = stations[1].arrival();
    const double  expected = distance / wave.speed();
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
