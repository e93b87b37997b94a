// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/contact_couple.h>

namespace hybrid::dda
{
  namespace
  {
    /// Of a place that moves with a block, by the block's rigid motion.
    Vec2 velocity_at(const Trial             &trial,
                     const std::vector<Vec6> &velocity,
                     const int                block,
                     const Vec2              &place)
    {
      const Vec2  r = place - trial.motion[block].centroid;
      const Vec6 &v = velocity[block];
      return {v[0] - v[2] * r.y(), v[1] + v[2] * r.x()};
    }



    /// Of the place of a spring, as seen from one of its blocks.
    Vec2 velocity_of_place(const Springs           &springs,
                           const Trial             &trial,
                           const std::vector<Vec6> &velocity,
                           const std::size_t        s,
                           const int                block)
    {
      const Springs::Spring &spring = springs.springs[s];
      const auto             of     = [&](const int b) {
        return velocity_at(trial, velocity, b, springs.responses[s].place);
      };
      if (spring.other == foundation_body)
        return of(block);
      if (spring.joint < 0)
        return of(spring.block);
      return 0.5 * (of(spring.block) + of(spring.other));
    }
  } // namespace



  double contact_couple(const Springs           &springs,
                        const Trial             &trial,
                        const std::vector<Vec6> &velocity,
                        const int                block)
  {
    double sum = 0.;
    for (const int entry : springs.of_block(block))
      {
        const std::size_t        s        = entry / 2;
        const Springs::Spring   &spring   = springs.springs[s];
        const Springs::Response &response = springs.responses[s];
        if (spring.contact_fraction == 0.)
          continue;
        const Springs::Traction traction = spring.contact_traction(response.now);
        const double            sign     = entry % 2 == 0 ? -1. : 1.; // on the block of P, or of Q
        const Vec2              force    = sign * spring.length *
                           (traction.normal * response.normal + traction.shear * response.tangent);
        const Vec2 place = velocity_of_place(springs, trial, velocity, s, block);
        sum -= cross(place - velocity[block].head<2>(), force);
      }
    return 0.5 * trial.dt * trial.dt * sum;
  }
} // namespace hybrid::dda
