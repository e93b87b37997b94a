// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace hybrid::output
{
  /// Of finite elements on Gauss-Lobatto nodes.
  enum class ElementMass
  {
    consistent,
    diagonal ///< by quadrature on the nodes: spectral elements
  };


  /**
   * The frequency that a mesh of finite elements takes a wave of s = i w for, less s [1/s]: the
   * wave of that frequency has the same length in the rock.
   *
   * Elements of degree p with their consistent mass lengthen a wave of the wave number k by
   *   1/2 [p! / (2 p)!]^2 (k h)^(2 p) / (2 p + 1)
   * of itself, so it leads: 1/24 (k h)^2, 1/1440 (k h)^4. With the
   * diagonal mass it is - 1 / p of that (Ainsworth & Wajid 2009).
   *
   * @param cell_time a wave's way through a cell, h / c [s].
   */
  std::complex<double> mesh_frequency_error(int                  degree,
                                            double               cell_time,
                                            std::complex<double> s,
                                            ElementMass          mass = ElementMass::consistent);
} // namespace hybrid::output
