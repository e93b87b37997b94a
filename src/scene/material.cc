// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/material.h>

#include <cmath>

namespace hybrid
{
  double Material::p_wave_speed() const
  {
    return std::sqrt((lame_lambda() + 2. * shear_modulus()) / density);
  }

  double Material::s_wave_speed() const
  {
    return std::sqrt(shear_modulus() / density);
  }
} // namespace hybrid
