// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/wave_packet.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  const double speed = 1200.;

  scene::InitialWaveParameters packet(const scene::WaveType type, const double width)
  {
    scene::InitialWaveParameters p;
    p.type      = type;
    p.direction = -30.;
    p.centre    = Vec2(100., 50.);
    p.amplitude = 2e-3;
    p.frequency = 8.; // 150 m
    p.length    = 1.;
    p.width     = width;
    return p;
  }

  const Vec2 way(std::sqrt(0.75), -0.5), left(0.5, std::sqrt(0.75));
  const Vec2 somewhere(160., -10.);

  /// Derivatives of displacement (or velocity) at x: column k is d/dx_k.
  Eigen::Matrix2d gradient(const WavePacket &wave, const Vec2 &x, Vec2 WavePacket::Motion::*what)
  {
    constexpr double h = 0.01; // [m]
    Eigen::Matrix2d  result;
    for (int k = 0; k < 2; ++k)
      result.col(k) =
        (wave.at(x + h * Vec2::Unit(k)).*what - wave.at(x - h * Vec2::Unit(k)).*what) / (2. * h);
    return result;
  }
} // namespace



TEST(WavePacket, pressure_waves_move_forwards_and_shear_waves_to_the_left)
{
  const Vec2 centre(100., 50.);
  EXPECT_LT((WavePacket(packet(scene::WaveType::pressure, 2.), speed).at(centre).displacement -
             2e-3 * way)
              .norm(),
            1e-15);
  EXPECT_LT((WavePacket(packet(scene::WaveType::shear, 2.), speed).at(centre).displacement -
             2e-3 * left)
              .norm(),
            1e-15);
}



TEST(WavePacket, pressure_waves_do_not_turn_and_shear_waves_do_not_swell)
{
  for (const double width : {0., 1.5})
    {
      const WavePacket pressure(packet(scene::WaveType::pressure, width), speed),
        shear(packet(scene::WaveType::shear, width), speed);
      for (const auto what : {&WavePacket::Motion::displacement, &WavePacket::Motion::velocity})
        {
          const auto p = gradient(pressure, somewhere, what), s = gradient(shear, somewhere, what);
          const double size = p.norm();
          ASSERT_GT(size, 0.);
          EXPECT_LT(std::abs(p(1, 0) - p(0, 1)), 1e-6 * size);
          EXPECT_LT(std::abs(s.trace()), 1e-6 * size);
          EXPECT_GT(std::abs(p.trace()), 0.1 * size);
        }
    }
}



TEST(WavePacket, travels_along_its_way)
{
  // v = -c du/ds, whatever the width.
  for (const auto type : {scene::WaveType::pressure, scene::WaveType::shear})
    for (const double width : {0., 1.5})
      {
        const WavePacket wave(packet(type, width), speed);
        const Vec2       expected =
          -speed * gradient(wave, somewhere, &WavePacket::Motion::displacement) * way;
        EXPECT_LT((wave.at(somewhere).velocity - expected).norm(), 1e-6 * expected.norm());
      }
}



TEST(WavePacket, envelope_has_the_deviations_of_the_scene)
{
  const Vec2       centre(100., 50.);
  const WavePacket beam(packet(scene::WaveType::shear, 2.), speed),
    front(packet(scene::WaveType::shear, 0.), speed);
  const double at_deviation = std::exp(-0.5);
  EXPECT_NEAR(beam.envelope(centre + 150. * way), at_deviation, 1e-12);
  EXPECT_NEAR(beam.envelope(centre - 300. * left), at_deviation, 1e-12);
  EXPECT_NEAR(front.envelope(centre + 150. * way), at_deviation, 1e-12);
  EXPECT_NEAR(front.envelope(centre + 9e4 * left), 1., 1e-9);
}
