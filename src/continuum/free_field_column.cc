// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/free_field_column.h>
#include <hybrid/continuum/inertia_correction.h>

#include <algorithm>

namespace hybrid::continuum
{
  FreeFieldColumn::FreeFieldColumn(const LagrangeLine &line, Model m)
    : model(std::move(m))
    , n(static_cast<int>(model.elements.size()) * line.degree() + 1)
    , width(line.degree())
    , mass(n, width)
    , stiffness{BandedCholesky(n, width), BandedCholesky(n, width)}
    , inertia_correction{BandedCholesky(n, width), BandedCholesky(n, width)}
    , predicted(n)
    , rate(n)
    , rhs(n)
    , product(n)
  {
    for (std::size_t e = 0; e < model.elements.size(); ++e)
      {
        const Element &element = model.elements[e];
        const int      first   = static_cast<int>(e) * width;
        const double   h       = element.top - element.bottom;
        for (int i = 0; i <= width; ++i)
          for (int j = 0; j <= i; ++j)
            {
              mass(first + i, first + j) += element.density * h * line.mass()(i, j);
              const double k = line.stiffness()(i, j) / h;
              stiffness[0](first + i, first + j) += element.shear * k;
              stiffness[1](first + i, first + j) += (element.lambda + 2. * element.shear) * k;
            }
        if (model.newmark.corrected_step != 0.)
          for (const int c : {0, 1})
            {
              const double modulus = c == 0 ? element.shear : element.lambda + 2. * element.shear;
              const Eigen::MatrixXd added =
                continuum::inertia_correction(element.density * h * line.mass(),
                                              modulus / h * line.stiffness(),
                                              model.newmark.corrected_step);
              for (int i = 0; i <= width; ++i)
                for (int j = 0; j <= i; ++j)
                  inertia_correction[c](first + i, first + j) += added(i, j);
            }
      }
  }


  double
  FreeFieldColumn::dynamic(const int component, const int i, const int j, const double dt) const
  {
    const double rate_factor = model.newmark.gamma / (model.newmark.beta * dt);
    const double to_inertia  = 1. / (model.newmark.beta * dt * dt);
    return (1. + rate_factor * model.rayleigh_stiffness) * stiffness[component](i, j) +
           (to_inertia + rate_factor * model.rayleigh_mass) * mass(i, j) +
           to_inertia * inertia_correction[component](i, j);
  }


  const FreeFieldColumn::Factor &FreeFieldColumn::factor_for(const double dt)
  {
    for (auto &factor : factors)
      if (factor.dt == dt)
        return factor;
    if (factors.size() >= 3)
      factors.erase(factors.begin());

    Factor factor;
    factor.dt = dt;
    for (int c = 0; c < 2; ++c)
      {
        BandedCholesky a(n, width);
        for (int i = 0; i < n; ++i)
          for (int j = std::max(0, i - width); j <= i; ++j)
            a(i, j) = dynamic(c, i, j, dt);
        if (model.foot == Foot::impedance)
          a(0, 0) += model.newmark.gamma / (model.newmark.beta * dt) * model.foot_impedance[c];
        else
          for (int i = 1; i <= width; ++i)
            a(i, 0) = 0.;
        a.factor();
        factor.matrix[c] = std::move(a);
      }
    factors.push_back(std::move(factor));
    return factors.back();
  }


  void FreeFieldColumn::multiply(const BandedCholesky      &a,
                                 const std::vector<double> &x,
                                 std::vector<double>       &y) const
  {
    std::fill(y.begin(), y.end(), 0.);
    for (int i = 0; i < n; ++i)
      {
        for (int j = std::max(0, i - width); j < i; ++j)
          {
            y[i] += a(i, j) * x[j];
            y[j] += a(i, j) * x[i];
          }
        y[i] += a(i, i) * x[i];
      }
  }


  void FreeFieldColumn::step(const ConstMotion &old,
                             const Motion      &next,
                             const double       dt,
                             const Input       &in)
  {
    const double  beta = model.newmark.beta, gamma = model.newmark.gamma;
    const double  to_rate = gamma / (beta * dt), to_acceleration = 1. / (beta * dt * dt);
    const Factor &factor = factor_for(dt);
    for (int c = 0; c < 2; ++c)
      {
        for (int i = 0; i < n; ++i)
          {
            const int k  = 2 * i + c;
            predicted[i] = old.u[k] + dt * old.v[k] + dt * dt * (0.5 - beta) * old.a[k];
            rate[i]      = to_rate * predicted[i] - old.v[k] - (1. - gamma) * dt * old.a[k];
            rhs[i]       = to_acceleration * predicted[i] + model.rayleigh_mass * rate[i];
          }
        multiply(mass, rhs, product);
        std::swap(rhs, product);
        if (model.newmark.corrected_step != 0.)
          {
            multiply(inertia_correction[c], predicted, product);
            for (int i = 0; i < n; ++i)
              rhs[i] += to_acceleration * product[i];
          }
        if (model.rayleigh_stiffness != 0.)
          {
            multiply(stiffness[c], rate, product);
            for (int i = 0; i < n; ++i)
              rhs[i] += model.rayleigh_stiffness * product[i];
          }
        const double foot = predicted[0] + beta * dt * dt * in.acceleration[c];
        if (model.foot == Foot::impedance)
          rhs[0] += model.foot_impedance[c] * (rate[0] + 2. * in.wave_velocity[c]);
        else
          {
            for (int i = 1; i <= width; ++i)
              rhs[i] -= dynamic(c, i, 0, dt) * foot;
            rhs[0] = 0.;
          }
        factor.matrix[c].solve(rhs);
        if (model.foot == Foot::prescribed)
          rhs[0] = foot;
        for (int i = 0; i < n; ++i)
          {
            const int k = 2 * i + c;
            next.u[k]   = rhs[i];
            next.a[k]   = to_acceleration * (rhs[i] - predicted[i]);
            next.v[k]   = old.v[k] + dt * ((1. - gamma) * old.a[k] + gamma * next.a[k]);
          }
      }
  }
} // namespace hybrid::continuum
