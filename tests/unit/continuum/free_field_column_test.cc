// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/free_field_column.h>
#include <hybrid/continuum/lagrange_line.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double height = 100., density = 2000., shear = 2e8; // c_s = 316 m/s
  constexpr double step = 0.005;                                // 1/250 of the period

  /// How late the first shear mode of a column on a fixed foot is after two periods [-]. The mode
  /// is sin(pi y / 2 H).
  double lateness(const Newmark &newmark)
  {
    FreeFieldColumn::Model model;
    for (int e = 0; e < 5; ++e)
      model.elements.push_back({height * e / 5., height * (e + 1) / 5., density, shear, shear});
    model.foot    = Foot::prescribed;
    model.newmark = newmark;
    const LagrangeLine line(4);
    FreeFieldColumn    column(line, model);

    const double        omega = 0.5 * M_PI * std::sqrt(shear / density) / height;
    const int           n     = column.n_nodes();
    std::vector<double> u(2 * n, 0.), v(2 * n, 0.), a(2 * n, 0.), u1(u), v1(v), a1(a);
    for (int i = 0; i < n; ++i)
      {
        const double y = height / 5. * (i / 4 + line.nodes()[i % 4]);
        u[2 * i]       = std::sin(0.5 * M_PI * y / height);
        a[2 * i]       = -omega * omega * u[2 * i];
      }
    // After two periods and a quarter the top passes through zero: u = -sin(w (t - t_0)).
    const int steps = static_cast<int>(std::round(4.5 * M_PI / (omega * step)));
    for (int k = 0; k < steps; ++k)
      {
        column.step({u.data(), v.data(), a.data()}, {u1.data(), v1.data(), a1.data()}, step, {});
        u.swap(u1);
        v.swap(v1);
        a.swap(a1);
      }
    const double exact = omega * steps * step - 4.5 * M_PI;
    return (std::asin(u[2 * (n - 1)]) + exact) / (4.5 * M_PI);
  }
} // namespace


TEST(FreeFieldColumn, keeps_time_like_the_model_beside_it)
{
  const double omega     = 0.5 * M_PI * std::sqrt(shear / density) / height;
  Newmark      newmark   = Newmark::preset("trapezoidal");
  const double late      = lateness(newmark);
  newmark.corrected_step = step;
  EXPECT_NEAR(late, omega * omega * step * step / 12., 0.02 * late);
  EXPECT_LT(std::abs(lateness(newmark)), 0.02 * late);
}
