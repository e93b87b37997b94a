// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/surface_force.h>

namespace hybrid::dda
{
  SurfaceForce surface_force(const Model &model, const Springs &springs)
  {
    const auto is_mass  = [&](const int body) { return body >= 0 && body < model.n_mass(); };
    const auto downhill = [&](const int block) {
      return model.downhill.sign_of(block) < 0. ? -1. : 1.;
    };
    return shared_sum<SurfaceForce>(
      springs.springs.size(), [&](const std::size_t s, SurfaceForce &sum) {
        if (is_mass(springs.bodies[s].block) == is_mass(springs.bodies[s].other))
          return;
        const Springs::Spring &spring = springs.springs[s];
        if (spring.length <= 0.)
          return;
        const Springs::Response &response = springs.responses[s];
        const SpringState       &now      = response.now;
        // The force on Q; a mass that is Q does the opposite to P, towards which -n points.
        const double side  = is_mass(spring.block) ? 1. : -1.;
        const Vec2   into  = side * response.normal, along(-into.y(), into.x());
        const Vec2   shear = side * spring.length * now.shear * response.tangent;
        sum.force += shear + spring.length * now.normal * into;
        sum.shear +=
          downhill(is_mass(spring.block) ? spring.block : spring.other) * shear.dot(along);
        sum.normal += spring.length * now.normal;
        sum.strength += spring.length * response.shear_strength;
      });
  }
} // namespace hybrid::dda
