// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Divide cohesion, tensile strength and the tangent of the friction angle of all materials and of
   * the bedding planes, peak and residual, by @p factor (strength reduction: Zienkiewicz, Humpheson
   * and Lewis 1975; Griffiths and Lane 1999). Stiffness, density and fracture energy stay,
   * and dilation as far as it is below friction.
   */
  void divide_strengths(SceneParameters &scene, double factor);
} // namespace hybrid::scene
