// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/strength_reduction.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Angle [deg] whose tangent is a part of that of another; negative: not given.
    void divide_tangent(double &angle, const double factor)
    {
      constexpr double degree = M_PI / 180.;
      if (angle > 0.)
        angle = std::atan(std::tan(angle * degree) / factor) / degree;
    }
  } // namespace



  void divide_strengths(SceneParameters &scene, const double factor)
  {
    if (factor == 1.)
      return;
    for (auto &[name, material] : scene.materials)
      {
        for (double *angle : {&material.friction_angle,
                              &material.given_friction_angle,
                              &material.residual_friction_angle})
          divide_tangent(*angle, factor);
        material.dilation_angle = std::min(material.dilation_angle, material.friction_angle);
        material.cohesion /= factor;
        material.tensile_strength /= factor;
        if (material.residual_cohesion > 0.)
          material.residual_cohesion /= factor;
      }
    divide_tangent(scene.bedding.friction_angle, factor);
    scene.bedding.cohesion /= factor;
    scene.bedding.tensile_strength /= factor;
  }
} // namespace hybrid::scene
