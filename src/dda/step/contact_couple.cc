// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/contact_couple.h>

namespace hybrid::dda
{
  double contact_couple(const Springs                &springs,
                        const Trial                  &trial,
                        const std::vector<Vec6>      &velocity,
                        const std::vector<BlockMass> &mass,
                        const int                     block)
  {
    const auto inertia = [&](const int b) { return (mass[b] * Vec6::Unit(2))[2]; };
    double     sum     = 0.;
    for (const int entry : springs.of_block(block))
      {
        const std::size_t        s        = entry / 2;
        const Springs::Spring   &spring   = springs.springs[s];
        const Springs::Response &response = springs.responses[s];
        if (spring.contact_fraction == 0. || spring.other == foundation_body)
          continue;
        const Springs::Traction traction = spring.contact_traction(response.now);
        const Vec2              on_other =
          spring.length * (traction.normal * response.normal + traction.shear * response.tangent);
        const Vec2 relative = (velocity[spring.other] - velocity[spring.block]).head<2>();
        sum += cross(relative, on_other) / (inertia(spring.block) + inertia(spring.other));
      }
    return 0.5 * trial.dt * trial.dt * inertia(block) * sum;
  }
} // namespace hybrid::dda
