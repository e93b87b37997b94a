// SPDX-License-Identifier: GPL-3.0-or-later
// A Ricker pulse up a column, half rock, half bonded blocks of the same material, 20 blocks per
// dominant wavelength: no reflection from the interface, twice the incident motion at the surface,
// in time.
//
// The column is truly one-dimensional: walls hold the displacement that the plane wave does not
// have (WalledFoundation), in the rock by stiff springs on its side nodes and in the blocks by
// joints to the wall. Free sides of the blocks would let the column bend, and a free field beside
// the rock alone would reflect at the interface.
#include "coupled_scenes.h"

#include <hybrid/scene/boundary/fixed_side.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::test;

  constexpr double frequency = 4.; ///< dominant [Hz]
  constexpr int    cells     = 20; ///< rows of blocks per dominant wavelength
  constexpr int    rock_rows = 40, mass_rows = 30;
  constexpr double amplitude = 1e-4; ///< of the incident velocity [m/s]

  /// Outcrop motion whose incident velocity is a Ricker wavelet of the amplitude, peak at @p
  /// peak_time.
  scene::Motion pulse(const double peak_time)
  {
    const double        sampling = 1e-3 / frequency;
    std::vector<double> a;
    for (double t = 0.; t < 2. * peak_time; t += sampling)
      {
        const double x = M_PI * frequency, s = x * x * (t - peak_time) * (t - peak_time);
        a.push_back(2. * amplitude * x * x * (t - peak_time) * (4. * s - 6.) * std::exp(-s));
      }
    return {sampling, a};
  }



  /// Largest |v| in a window of a history, with a parabola through its neighbours.
  struct Peak
  {
    double time, value;
  };

  Peak peak_of(const std::vector<double> &v, const double dt, const double from, const double to)
  {
    std::size_t k = static_cast<std::size_t>(from / dt) + 1;
    for (std::size_t i = k; i + 1 < v.size() && i * dt <= to; ++i)
      if (std::abs(v[i]) > std::abs(v[k]))
        k = i;
    const double l = v[k - 1], m = v[k], r = v[k + 1], part = 0.5 * (l - r) / (l - 2. * m + r);
    return {(k + part) * dt, m - 0.25 * (l - r) * part};
  }



  void expect_no_reflection(const Wave wave, const std::string &scheme)
  {
    scene::SceneParameters scene = coupled_parameters();
    scene.time.newmark           = Newmark::preset(scheme);
    scene.environment.gravity    = 0.;
    scene.continuum.sides        = scene::fixed_side(); // of the separate cell only
    scene.motion.angle           = wave == Wave::shear ? 0. : 90.;
    const Material &m            = scene.materials.at("mass");
    const double    c            = wave == Wave::shear ? m.s_wave_speed() : m.p_wave_speed();
    const double    wavelength   = c / frequency;

    Section layout;
    layout.rows            = rock_rows;
    layout.mass_rows       = mass_rows;
    layout.size            = wavelength / cells;
    layout.walled          = true;
    const double peak_time = 1.5 / frequency, dt = 1. / (1000. * frequency);
    CoupledRun   run(layout, scene, pulse(peak_time), wave);
    const double x         = layout.size; // middle
    const auto   station   = run.rock.point(Vec2(x, -wavelength));
    const int    component = wave == Wave::shear ? 0 : 1;
    const int    surface   = run.block_at(Vec2(x, layout.size * mass_rows));
    const double surface_y = run.state.blocks.blocks[surface].centroid.y();

    const double        depth = layout.size * rock_rows, height = layout.size * mass_rows;
    const double        end = peak_time + (depth + height) / c + 1. / frequency;
    std::vector<double> below{0.}, above{0.};
    for (int k = 0; k < static_cast<int>(end / dt); ++k)
      {
        ASSERT_TRUE(run.advance(dt));
        below.push_back(run.rock.sample(run.state.continuum, station).velocity[component]);
        // Velocity of the block at the free surface.
        const dda::BlockState &block = run.state.blocks.blocks[surface];
        const Vec2             p(block.centroid.x(), block.centroid.y() + height - surface_y);
        const dda::BlockMotion rest(block.centroid, dda::Vec6::Zero());
        above.push_back(rest.gradient(p, Vec2::Unit(component)).dot(block.velocity));
      }
    const double passes   = peak_time + (depth - wavelength) / c;
    const Peak   incident = peak_of(below, dt, passes - 0.5 / frequency, passes + 0.5 / frequency);
    const Peak   back     = peak_of(below, dt, passes + 1. / frequency, passes + 3. / frequency);
    const Peak   top      = peak_of(above, dt, 0., end);
    const double travel   = (wavelength + height) / c;
    testing::Test::RecordProperty("reflection", std::to_string(back.value / incident.value));
    std::printf("reflection %.4f  incident %.5f  surface/incident %.4f  arrival %.4f late\n",
                back.value / incident.value,
                incident.value / amplitude,
                top.value / incident.value,
                (top.time - incident.time) / travel - 1.);
    EXPECT_NEAR(incident.value, amplitude, 0.01 * amplitude);
    EXPECT_LT(std::abs(back.value), 0.02 * incident.value);
    EXPECT_NEAR(top.value / incident.value, 2., 0.02 * 2.);
    EXPECT_NEAR(top.time - incident.time, travel, 0.01 * travel);
    EXPECT_LT(run.audit(), 1e-3);
  }
} // namespace



TEST(CouplingWave, shear_pulse_is_not_reflected)
{
  expect_no_reflection(Wave::shear, "trapezoidal");
}



TEST(CouplingWave, pressure_pulse_is_not_reflected)
{
  expect_no_reflection(Wave::pressure, "trapezoidal");
}



TEST(CouplingWave, shear_pulse_with_the_default_scheme)
{
  expect_no_reflection(Wave::shear, "dissipative");
}
