// SPDX-License-Identifier: GPL-3.0-or-later
// Observed order of convergence in space (degree 1 to 4: p + 1 in displacement) and in time (each
// preset) on a smooth, truly two-dimensional problem: a standing Rayleigh wave between rollers,
//   u_x = sin kx (-e^(q k y) + 2 q s/(1 + s^2) e^(s k y)) cos wt,
//   u_y = cos kx (q e^(q k y) - 2 q/(1 + s^2) e^(s k y)) cos wt,   y <= 0,
// q^2 = 1 - c^2/c_p^2, s^2 = 1 - c^2/c_s^2, w = k c, (1 + s^2)^2 = 4 q s (Rayleigh 1885). It meets
// rollers at x = 0 and pi/k and the free top exactly; at the fixed base it has faded to 1e-9.
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/boundary/roller_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double width = 100.; ///< half a wavelength [m]
  constexpr double depth = 16. * width;
  constexpr double k     = test::pi / width;

  class RayleighWave
  {
  public:
    explicit RayleighWave(const Material &rock)
    {
      const double c_s = rock.s_wave_speed(), c_p = rock.p_wave_speed();
      const auto   set = [&](const double c) {
        q     = std::sqrt(1. - c * c / (c_p * c_p));
        s     = std::sqrt(1. - c * c / (c_s * c_s));
        omega = k * c;
        return (1. + s * s) * (1. + s * s) - 4. * q * s;
      };
      double low = 0.5 * c_s, high = 0.9999 * c_s; // the function changes its sign from - to +
      for (int i = 0; i < 200; ++i)
        (set(0.5 * (low + high)) < 0. ? low : high) = 0.5 * (low + high);
      set(low);
    }

    Vec2 shape(const Vec2 &x) const
    {
      const double p = std::exp(q * k * x.y()), v = std::exp(s * k * x.y());
      return {std::sin(k * x.x()) * (-p + 2. * q * s / (1. + s * s) * v),
              std::cos(k * x.x()) * (q * p - 2. * q / (1. + s * s) * v)};
    }

    double omega; ///< [rad/s]

  private:
    double q, s;
  };


  /// Base at y = -depth, top at y = 0; rows grow downwards, inner nodes are moved off their grid.
  scene::SectionMesh graded_mesh(const int columns)
  {
    std::vector<double> y{0.};
    for (double h = 0.5 * width; y.back() > -depth; h *= 1.15)
      for (int i = 0; i < columns / 2; ++i)
        y.push_back(y.back() - 2. * h / columns);
    std::reverse(y.begin(), y.end());
    auto mesh = test::rectangle_mesh(test::equal_spacing(0., width, columns), y);
    for (Vec2 &x : mesh.nodes)
      x.x() += 0.05 * width * std::sin(2. * k * x.x()) * std::sin(2. * k * x.y());
    return mesh;
  }


  /// Points off every mesh line (Halton's sequence in the upper three widths).
  std::vector<Vec2> sampling_points()
  {
    const auto halton = [](int i, const int base) {
      double f = 1., r = 0.;
      for (; i > 0; i /= base)
        r += (f /= base) * (i % base);
      return r;
    };
    std::vector<Vec2> points;
    for (int i = 1; i <= 300; ++i)
      points.emplace_back(width * halton(i, 2), -3. * width * halton(i, 3));
    return points;
  }


  /// What the motion at time t is compared with: the factor of the shape.
  using History = double (*)(double omega, double t, double dt);

  double exact(const double omega, const double t, double)
  {
    return std::cos(omega * t);
  }

  /// The trapezoidal rule turns a mode of frequency w with (2/dt) atan(w dt/2), and damps nothing.
  double trapezoidal(const double omega, const double t, const double dt)
  {
    return std::cos(2. / dt * std::atan(0.5 * omega * dt) * t);
  }


  /// Root mean square of the displacement's error over that of the shape after @p steps of T / @p
  /// per_period.
  double error(const int          columns,
               const int          degree,
               const std::string &scheme,
               const int          per_period,
               const int          steps,
               const History      history)
  {
    auto scene             = test::rock_scene();
    scene.continuum.degree = degree;
    scene.continuum.base   = scene::fixed_base();
    scene.continuum.sides  = scene::roller_side();
    scene.time.newmark     = Newmark::preset(scheme);
    const RayleighWave wave(test::rock_material());
    const double       dt = 2. * test::pi / (wave.omega * per_period);
    if (scheme == "fourth order")
      scene.time.newmark.corrected_step = dt;
    Continuum continuum(graded_mesh(columns), scene, {}, MPI_COMM_WORLD);

    auto       state  = continuum.initial_state();
    const auto points = continuum.picture(state).points;
    for (std::size_t n = 0; n < points.size(); ++n)
      for (int c = 0; c < 2; ++c)
        {
          state.displacement[2 * n + c] = wave.shape(points[n])[c];
          state.acceleration[2 * n + c] = -wave.omega * wave.omega * wave.shape(points[n])[c];
        }
    const auto                    at = sampling_points();
    std::vector<Continuum::Point> probes;
    for (const Vec2 &x : at)
      probes.push_back(continuum.point(x));
    for (int i = 0; i < steps; ++i)
      continuum.step(state, dt);

    double       wrong = 0., all = 0.;
    const double factor = history(wave.omega, steps * dt, dt);
    for (std::size_t i = 0; i < at.size(); ++i)
      {
        const Vec2 shape = wave.shape(at[i]);
        wrong += (continuum.sample(state, probes[i]).displacement - factor * shape).squaredNorm();
        all += shape.squaredNorm();
      }
    return std::sqrt(wrong / all);
  }


  double order(const double coarse, const double fine)
  {
    return std::log2(coarse / fine);
  }
} // namespace


TEST(Convergence, in_space)
{
  const int first[] = {8, 4, 2, 2}; // columns of the coarsest of three meshes, per degree
  for (int degree = 1; degree <= 4; ++degree)
    {
      double errors[3];
      for (int level = 0; level < 3; ++level)
        errors[level] =
          error(first[degree - 1] << level, degree, "trapezoidal", 16, 6, trapezoidal);
      std::printf("degree %d: errors %.3e %.3e %.3e, orders %.2f %.2f\n",
                  degree,
                  errors[0],
                  errors[1],
                  errors[2],
                  order(errors[0], errors[1]),
                  order(errors[1], errors[2]));
      EXPECT_NEAR(order(errors[1], errors[2]), degree + 1, 0.3) << "degree " << degree;
    }
}


TEST(Convergence, in_time)
{
  struct Preset
  {
    const char *scheme;
    int         expected, per_period;
  };
  for (const auto &[scheme, expected, per_period] : {Preset{"trapezoidal", 2, 80},
                                                     {"fourth order", 4, 40},
                                                     {"filtered", 2, 80},
                                                     {"dissipative", 1, 80},
                                                     {"shi", 1, 80}})
    {
      double errors[3];
      for (int level = 0; level < 3; ++level)
        errors[level] =
          error(4, 4, scheme, per_period << level, 9 * per_period / 8 << level, exact);
      std::printf("%s: errors %.3e %.3e %.3e, orders %.2f %.2f\n",
                  scheme,
                  errors[0],
                  errors[1],
                  errors[2],
                  order(errors[0], errors[1]),
                  order(errors[1], errors[2]));
      EXPECT_NEAR(order(errors[1], errors[2]), expected, 0.1) << scheme;
    }
}
