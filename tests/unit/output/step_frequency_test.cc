// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_frequency.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    using Complex = std::complex<double>;


    /// Steps of u'' = -w^2 u - w^2 d (rate of the mean of the step) with a scheme: u, v, force per
    /// mass, its memory.
    Eigen::Matrix4d step_of(const Newmark &n, const double w, const double dt, const double damping)
    {
      // u1 = u + dt v + dt^2/2 a*,  a* = (1 - g) a + g a1 - f m,  a1 = -w^2 (u1 + d (u1 - u) / dt)
      const double       k = w * w, g = n.gamma, h = 0.5 * dt * dt, rate = damping / dt;
      const double       divisor = 1. + h * g * k * (1. + rate);
      Eigen::RowVector4d u1(1. + h * g * k * rate, dt, h * (1. - g), -h * n.filter);
      u1 /= divisor;
      const Eigen::RowVector4d u(1., 0., 0., 0.), v(0., 1., 0., 0.), a(0., 0., 1., 0.),
        m(0., 0., 0., 1.);
      const Eigen::RowVector4d a1 = -k * (u1 + rate * (u1 - u));
      Eigen::Matrix4d          result;
      result << u1, 2. / dt * (u1 - u) - v, a1, 0.5 * m + 0.5 * (a1 - a);
      return result;
    }


    /// i w' of the mode that comes nearest to i w.
    Complex frequency_of(const Eigen::Matrix4d &step, const double w, const double dt)
    {
      Complex best(-1e9, 0.);
      for (const Complex &root : Eigen::EigenSolver<Eigen::Matrix4d>(step).eigenvalues())
        if (std::abs(root) > 1e-12 &&
            std::abs(std::log(root) / dt - Complex(0., w)) < std::abs(best - Complex(0., w)))
          best = std::log(root) / dt;
      return best;
    }



    TEST(StepFrequency, OfCentralDifferences)
    {
      // cos(w' dt) = 1 - (w dt)^2 / 2
      Newmark newmark;
      newmark.beta  = 0.;
      newmark.gamma = 0.5;
      for (const double turn : {0.05, 0.3, 1.})
        {
          const double  w = 12., dt = turn / w, found = std::acos(1. - 0.5 * turn * turn) / dt;
          const Complex s(0., found);
          const Complex taken = s + frequency_error({newmark, dt, 0., 0.}, s);
          EXPECT_LT(std::abs(taken - Complex(0., w)), 1e-9 * w) << turn;
        }
    }



    TEST(StepFrequency, OfCentralDifferencesWithDampingHalfAStepLate)
    {
      // z^2 - (2 - q - q d) z + (1 - q d) = 0, z = exp(s dt), q = (w dt)^2, d = beta_K / dt
      Newmark newmark;
      newmark.beta    = 0.;
      newmark.gamma   = 0.5;
      const double  w = 12., dt = 0.02 / w, beta = 0.05 / w, q = 4e-4, d = beta / dt;
      const double  half  = 0.5 * (2. - q - q * d);
      const Complex z     = Complex(half, std::sqrt(1. - q * d - half * half));
      const Complex s     = std::log(z) / dt;
      const Complex taken = s + frequency_error({newmark, dt, beta, 0.}, s);
      // the mode of the model itself: s'^2 + w^2 (1 + beta s') = 0
      const Complex exact(-0.5 * w * w * beta, w * std::sqrt(1. - 0.25 * w * w * beta * beta));
      EXPECT_GT(std::abs(s - exact), 2e-4 * w);
      EXPECT_LT(std::abs(taken - exact), 0.05 * std::abs(s - exact));
    }



    TEST(StepFrequency, IsWhatTheSchemeTurnsAModeInto)
    {
      for (const char *name : {"filtered", "dissipative", "trapezoidal", "shi"})
        for (const double turn : {0.05, 0.3, 1.})
          {
            const double     w = 12., dt = turn / w;
            const StepScheme scheme{Newmark::preset(name), dt, 0., 0.};
            const Complex    found = frequency_of(step_of(scheme.newmark, w, dt, 0.), w, dt);
            const Complex    taken = found + frequency_error(scheme, found);
            EXPECT_LT(std::abs(taken - Complex(0., w)), 1e-9 * w) << name << " " << turn;
          }
    }


    TEST(StepFrequency, IsOfTheOrderOfTheScheme)
    {
      const Complex s(0., 10.);
      const auto    size = [&](const char *name, const double dt) {
        return std::abs(frequency_error({Newmark::preset(name), dt, 0., 0.}, s));
      };
      EXPECT_NEAR(size("filtered", 1e-3) / size("filtered", 5e-4), 4., 0.05);
      EXPECT_NEAR(size("dissipative", 1e-3) / size("dissipative", 5e-4), 2., 0.05);
      EXPECT_NEAR(size("filtered", 1e-3), 10. * (1. / 12. + 0.1) * 1e-4, 1e-2 * 2e-4);
    }


    TEST(StepFrequency, DampingAfterTheMeanRateIsHalfAStepLate)
    {
      // A damping so small that the frequency is not its own: what the delay makes of it counts.
      const double     w = 20., dt = 1e-3, damping = 2e-3;
      const StepScheme scheme{Newmark::preset("trapezoidal"), dt, damping, 0.};
      const Complex    found = frequency_of(step_of(scheme.newmark, w, dt, damping), w, dt);
      // exact: s^2 + w^2 (1 + damping s) = 0
      const double  half = 0.5 * w * w * damping;
      const Complex exact(-half, std::sqrt(w * w - half * half));
      const Complex taken = found + frequency_error(scheme, found);
      EXPECT_LT(std::abs(taken - exact), 0.05 * std::abs(found - exact));
      EXPECT_GT(found.imag(), exact.imag()); // it is stiffer for it
    }


    TEST(StepFrequency, TheFourthOrderLeavesWhatIsUncorrected)
    {
      Newmark newmark        = Newmark::preset("fourth order");
      newmark.corrected_step = 1e-3;
      const Complex s(0., 10.);
      EXPECT_LT(std::abs(frequency_error({newmark, 1e-3, 0., 0.}, s)), 1e-9);
      const double none = std::abs(frequency_error({newmark, 1e-3, 0., 1.}, s));
      EXPECT_NEAR(none, 10. * 1e-4 / 12., 1e-2 * 1e-4); // that of the trapezoidal rule
      EXPECT_NEAR(std::abs(frequency_error({newmark, 1e-3, 0., 0.25}, s)),
                  0.25 * none,
                  1e-3 * none);
    }
  } // namespace
} // namespace hybrid::output
