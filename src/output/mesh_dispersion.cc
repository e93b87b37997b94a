// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_dispersion.h>

#include <cmath>

namespace hybrid::output
{
  std::complex<double> mesh_frequency_error(const int                  degree,
                                            const double               cell_time,
                                            const std::complex<double> s,
                                            const ElementMass          mass)
  {
    double ratio = 1.; // p! / (2 p)!
    for (int k = degree + 1; k <= 2 * degree; ++k)
      ratio /= k;
    const double cells = std::abs(s) * cell_time; // k h
    const double lead  = mass == ElementMass::consistent ? -1. : 1. / degree;
    return lead * s * (0.5 * ratio * ratio * std::pow(cells, 2 * degree) / (2 * degree + 1.));
  }
} // namespace hybrid::output
