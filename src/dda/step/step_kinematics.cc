// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/step/step_kinematics.h>

namespace hybrid::dda
{
  void StepKinematics::choose_filters(const Model &model, const Springs &springs)
  {
    filter.assign(model.n_blocks(), 0.);
    if (model.newmark.velocity_filter == 0.)
      return;
    const std::size_t first = springs.has_torn_joints() ? 0 : springs.first_contact();
    for (std::size_t s = first; s < springs.springs.size(); ++s)
      if (springs.springs[s].contact_fraction > 0.)
        for (const int body : {springs.bodies[s].block, springs.bodies[s].other})
          if (body != foundation_body && !model.is_bedrock(body))
            filter[body] = model.newmark.velocity_filter;
  }



  void StepKinematics::begin(const Model    &model,
                             const DdaState &state,
                             const Springs  &springs,
                             const double    step_size)
  {
    const int n = model.n_blocks();
    dt          = step_size;
    beta        = model.newmark.beta;
    prediction.resize(n);
    rate.resize(n);
    change.resize(n);
    choose_filters(model, springs);
    const double k01      = model.velocity_kept_in(dt);
    const double kept     = Newmark::remembered_in(dt, state.last_step);
    const double filtered = 0.5 * dt * dt * model.newmark.filter_in(dt, state.last_step);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        const BlockState &block = state.blocks[b];
        const Vec6        a     = block.acceleration - block.contact_acceleration;
        const double      whole = 1. + filter[b];
        rate[b]                 = k01 * block.velocity;
        change[b]               = kept * block.velocity_change;
        prediction[b]           = dt * rate[b] + whole * dt * dt * (0.5 - beta) * a;
        if (filtered > 0.)
          prediction[b] -= whole * filtered * block.acceleration_change;
        if (filter[b] > 0.)
          prediction[b] -= 0.5 * filter[b] * dt * change[b];
      }
  }



  Vec6 StepKinematics::remembered(const int block, const Vec6 &end) const
  {
    if (filter[block] == 0.)
      return Vec6::Zero();
    return (1. - Newmark::memory) * change[block] + Newmark::memory * (end - rate[block]);
  }



  double StepKinematics::filter_loss(const int block, const BlockMass &mass, const Vec6 &end) const
  {
    if (filter[block] == 0.)
      return 0.;
    const Vec6 now = end - rate[block];
    return 0.5 * filter[block] * (now - change[block]).dot(mass * now);
  }
} // namespace hybrid::dda
