// SPDX-License-Identifier: GPL-3.0-or-later
// Plane P and SV waves at 0 to 60 degrees onto a viscous base: the reflected waves are those of
// Lysmer & Kuhlemeyer (1969), i.e. of a half space whose boundary has the tractions s_yy = rho c_p
// v_y, s_xy = rho c_s v_x (y into the rock).
//
// A wave (k_x, -k_y) and its mirror image (-k_x, -k_y) together meet rollers at x = 0 and pi/k_x: a
// strip of that width is a box without sides. The wave is a packet along y, exact at t = 0 (a sum
// of plane waves with one k_x), that goes down to the base and comes back; what it lost is the
// square of the reflection coefficient.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <Eigen/LU>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;
  using Complex = std::complex<double>;

  const double c_s = 1000., c_p = 1000. * std::sqrt(3.), density = 2000.;
  const double frequency  = 10.;
  const double wavelength = c_s / frequency; ///< of S waves, the finer ones [m]

  enum class Wave
  {
    pressure,
    shear
  };


  /// Parts of the incident energy that come back as P and as S wave.
  struct Reflected
  {
    double pressure, shear;
  };


  /// Amplitudes of displacement of the two reflected waves from the two conditions at the boundary,
  /// exp(i (k.x - w t)).
  Reflected reflected_energy(const Wave wave, const double kx, const double omega)
  {
    const double  mu = density * c_s * c_s, lambda = density * c_p * c_p - 2. * mu;
    const Complex kp = omega / c_p, ks = omega / c_s, i(0., 1.);
    const Complex py = std::sqrt(kp * kp - kx * kx), sy = std::sqrt(ks * ks - kx * kx);
    // What a wave of wave vector (kx, ky) and displacement u leaves unbalanced.
    const auto residual = [&](const Complex ky, const Complex ux, const Complex uy) {
      const Complex shear  = mu * i * (ky * ux + kx * uy);
      const Complex normal = lambda * i * (kx * ux + ky * uy) + 2. * mu * i * ky * uy;
      return Eigen::Vector2cd(shear + i * omega * density * c_s * ux,
                              normal + i * omega * density * c_p * uy);
    };
    Eigen::Matrix2cd up;
    up.col(0) = residual(py, kx / kp, py / kp);
    up.col(1) = residual(sy, -sy / ks, kx / ks);
    const Eigen::Vector2cd down =
      wave == Wave::pressure ? residual(-py, kx / kp, -py / kp) : residual(-sy, sy / ks, kx / ks);
    const Eigen::Vector2cd amplitude = -up.fullPivLu().solve(down);
    // Energy through the boundary: amplitude^2 c cos(angle), c cos = c^2 k_y / w; a P wave beyond
    // its angle carries none.
    const double of_p = c_p * c_p * py.real(), of_s = c_s * c_s * sy.real();
    const double in = wave == Wave::pressure ? of_p : of_s;
    return {std::norm(amplitude[0]) * of_p / in, std::norm(amplitude[1]) * of_s / in};
  }


  /// A packet of plane waves with one k_x that goes down, Gaussian in k_y.
  struct Packet
  {
    Packet(const Wave kind, const double angle)
      : wave(kind)
      , speed(kind == Wave::pressure ? c_p : c_s)
      , kx(2. * test::pi * frequency / speed * std::sin(angle))
      , length(2.5 * speed / frequency)
    {
      const double centre = 2. * test::pi * frequency / speed * std::cos(angle);
      for (int j = -60; j <= 60; ++j)
        {
          ky.push_back(centre + 4.5 / length * j / 60.);
          amplitude.push_back(std::exp(-0.5 * std::pow(4.5 * j / 60., 2)));
        }
    }

    double omega(const double k) const
    {
      return speed * std::hypot(kx, k);
    }

    /// Displacement, velocity and acceleration at x when the packet's centre is at @p centre.
    std::array<Vec2, 3> at(const Vec2 &x, const double centre) const
    {
      std::array<Vec2, 3> result{Vec2(0., 0.), Vec2(0., 0.), Vec2(0., 0.)};
      for (std::size_t j = 0; j < ky.size(); ++j)
        {
          const double  k = std::hypot(kx, ky[j]), w = omega(ky[j]);
          const Complex turn = std::polar(amplitude[j], -ky[j] * (x.y() - centre));
          const Complex ux   = Complex(0., (wave == Wave::pressure ? kx : ky[j]) / k) * turn;
          const Complex uy   = (wave == Wave::pressure ? -ky[j] : kx) / k * turn;
          const Complex rate(0., -w);
          Complex       factor = 1.;
          for (Vec2 &motion : result)
            {
              motion += Vec2((kx > 0. ? std::sin(kx * x.x()) : 1.) * (factor * ux).real(),
                             std::cos(kx * x.x()) * (factor * uy).real());
              factor *= rate;
            }
        }
      return result;
    }

    /// Closed form for the whole packet: its waves differ a little in their angle.
    Reflected expected() const
    {
      Reflected sum{0., 0.};
      double    all = 0.;
      for (std::size_t j = 0; j < ky.size(); ++j)
        {
          const double    part = std::pow(amplitude[j] * omega(ky[j]), 2);
          const Reflected r    = reflected_energy(wave, kx, omega(ky[j]));
          sum.pressure += part * r.pressure;
          sum.shear += part * r.shear;
          all += part;
        }
      return {sum.pressure / all, sum.shear / all};
    }

    Wave                wave;
    double              speed, kx, length; ///< length: standard deviation along y [m]
    std::vector<double> ky, amplitude;
  };


  double energy(const Continuum &continuum, ContinuumState &state, const double dt)
  {
    continuum.audit_energy(state, dt);
    return state.energy.kinetic + state.energy.strain;
  }


  /// Energy of the P waves: twice their strain energy, (lambda + 2 mu) (div u)^2 / 2 over the area.
  double pressure_energy(const Continuum &continuum, const ContinuumState &state)
  {
    const double mu = density * c_s * c_s, lambda = density * c_p * c_p - 2. * mu;
    const auto   picture = continuum.picture(state);
    double       sum     = 0.;
    for (std::size_t c = 0; c < picture.cells.size(); ++c)
      {
        const auto  &cell     = picture.cells[c];
        const Vec2   diagonal = picture.points[cell[2]] - picture.points[cell[0]];
        const double div = (picture.stress[c][0] + picture.stress[c][1]) / (2. * (lambda + mu));
        sum += (lambda + 2. * mu) * div * div * std::abs(diagonal.x() * diagonal.y());
      }
    return sum;
  }


  /// Cells of about the given size; lying: turned so that the base is on the left.
  scene::SectionMesh
  strip(const double width, const double height, const double cell, const bool lying)
  {
    const auto spacing = [&](const double l) {
      return test::equal_spacing(0., l, static_cast<int>(std::ceil(l / cell)));
    };
    if (!lying)
      return test::rectangle_mesh(spacing(width), spacing(height));
    auto       mesh      = test::rectangle_mesh(spacing(height), spacing(width));
    const auto lines     = mesh.lines;
    mesh.lines["base"]   = lines.at("left");
    mesh.lines["ground"] = lines.at("right");
    mesh.lines["left"]   = lines.at("base");
    mesh.lines["right"]  = lines.at("ground");
    return mesh;
  }


  Reflected measured(const Packet &packet)
  {
    const double cos_angle =
      std::cos(std::asin(packet.kx * packet.speed / (2. * test::pi * frequency)));
    const double away   = 4.5 * packet.length; // from the base, before and after
    const double height = 2. * away * (packet.wave == Wave::pressure ? 1. : c_p / c_s);
    const double width  = packet.kx > 0. ? test::pi / packet.kx : 0.5 * wavelength;
    const double cell   = wavelength / 5.;

    auto scene             = test::rock_scene();
    scene.continuum.sides  = scene::SideBoundary::roller;
    scene.continuum.degree = 2;
    scene.time.newmark     = Newmark::preset("trapezoidal");
    // An SV wave at 0 degrees moves along x only, which rollers forbid: its strip lies, base on the
    // left.
    const bool lying = packet.wave == Wave::shear && packet.kx == 0.;
    Continuum  continuum(strip(width, height, cell, lying), scene, {}, MPI_COMM_WORLD);
    auto       state  = continuum.initial_state();
    const auto points = continuum.picture(state).points;
    for (std::size_t n = 0; n < points.size(); ++n)
      {
        const Vec2 x      = lying ? Vec2(points[n].y(), points[n].x()) : points[n];
        const auto motion = packet.at(x, away);
        for (int d = 0; d < 2; ++d)
          {
            const int c                   = lying ? 1 - d : d;
            state.displacement[2 * n + c] = motion[0][d];
            state.velocity[2 * n + c]     = motion[1][d];
            state.acceleration[2 * n + c] = motion[2][d];
          }
      }
    const double dt       = 1. / (20. * frequency);
    const double incident = energy(continuum, state, dt);
    while (state.time < 2. * away / (packet.speed * cos_angle))
      continuum.step(state, dt);
    const double pressure = pressure_energy(continuum, state);
    return {pressure / incident, (energy(continuum, state, dt) - pressure) / incident};
  }


  /// Coefficient of reflected energy as an amplitude.
  double root(const double part)
  {
    return std::sqrt(std::max(part, 0.));
  }


  void expect_reflection(const Wave wave, const double degrees)
  {
    const Packet    packet(wave, degrees * test::pi / 180.);
    const Reflected found = measured(packet), whole = packet.expected(),
                    angle = reflected_energy(wave, packet.kx, 2. * test::pi * frequency);
    std::printf(
      "%-2s %2.0f deg: P %.4f (%.4f; packet %.4f), S %.4f (%.4f; %.4f), energy %.5f (%.5f; %.5f)\n",
      wave == Wave::pressure ? "P" : "SV",
      degrees,
      root(found.pressure),
      root(angle.pressure),
      root(whole.pressure),
      root(found.shear),
      root(angle.shear),
      root(whole.shear),
      found.pressure + found.shear,
      angle.pressure + angle.shear,
      whole.pressure + whole.shear);
    for (const Reflected &expected : {angle, whole})
      {
        EXPECT_NEAR(found.pressure + found.shear, expected.pressure + expected.shear, 0.02)
          << degrees;
        if (wave == Wave::shear && std::sin(degrees * test::pi / 180.) > c_s / c_p)
          continue; // beyond the critical angle only the energy counts
        EXPECT_NEAR(root(found.pressure), root(expected.pressure), 0.02) << degrees;
        EXPECT_NEAR(root(found.shear), root(expected.shear), 0.02) << degrees;
      }
  }
} // namespace


TEST(ObliqueWave, pressure_wave_is_reflected_as_by_dashpots)
{
  for (const double degrees : {0., 15., 30., 45., 60.})
    expect_reflection(Wave::pressure, degrees);
}


TEST(ObliqueWave, shear_wave_is_reflected_as_by_dashpots)
{
  for (const double degrees : {0., 15., 30., 45., 60.})
    expect_reflection(Wave::shear, degrees);
}
