// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_frequency.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    std::complex<double> of_corrected_inertia(const StepScheme          &scheme,
                                              const std::complex<double> s)
    {
      const std::complex<double> turn = s * scheme.dt, square = turn * turn;
      return -s * (square * square / 480. + square / 12. * scheme.uncorrected);
    }
  } // namespace



  std::complex<double> frequency_error(const StepScheme &scheme, const std::complex<double> s)
  {
    const Newmark &newmark = scheme.newmark;
    if (newmark.corrected_step > 0.)
      return of_corrected_inertia(scheme, s);
    const std::complex<double> x = std::tanh(0.5 * s * scheme.dt), e = std::exp(-s * scheme.dt);
    const std::complex<double> weight =
      newmark.gamma - 0.5 - newmark.filter * 0.5 * e / (1. - 0.5 * e);
    const std::complex<double> inertia = newmark.beta == 0.
                                           ? 2. / scheme.dt * std::sinh(0.5 * s * scheme.dt)
                                           : 2. * x / scheme.dt / std::sqrt(1. + 2. * x * weight);
    const std::complex<double> late    = (1. - e) / scheme.dt - s; // of the mean rate
    const std::complex<double> stiffer =
      scheme.late_damping * late / (1. + scheme.late_damping * s);
    return inertia * (1. - 0.5 * stiffer) - s;
  }
} // namespace hybrid::output
