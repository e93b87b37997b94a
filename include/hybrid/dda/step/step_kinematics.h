// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/springs/springs.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * How the increments d of blocks in a step and their accelerations belong together: Newmark's
   * pair with its filters (Newmark, doc/theory.md). With a the acceleration by all but contacts and
   * c that by contacts, both at the end of the step,
   *
   *     a + c / (2 beta) = inertia (d - predicted).
   *
   * Values of one step; not part of the state.
   */
  class StepKinematics
  {
  public:
    /// Weight of contact forces beside M (d - d*) / (beta dt^2), for their dt^2/2 in d.
    static double contact_weight(const Newmark &newmark)
    {
      return 0.5 / newmark.beta;
    }

    /// Begin a step of @p step_size [s]; @p springs are those of the step.
    void begin(const Model &model, const DdaState &state, const Springs &springs, double step_size);

    /// Velocity of each block that the step begins with.
    const std::vector<Vec6> &start_rates() const
    {
      return rate;
    }

    /// Whether a velocity filter keeps the block from rattling.
    bool is_filtered(const int block) const
    {
      return filter[block] > 0.;
    }

    /// Increment of a block without accelerations at the end of the step.
    const Vec6 &predicted(const int block) const
    {
      return prediction[block];
    }

    /// Acceleration per increment beyond the predicted one [1/s2].
    double inertia(const int block) const
    {
      return 1. / ((1. + filter[block]) * beta * dt * dt);
    }

    /// Velocity of a block at the end of the step: with 2 beta = gamma the mean of both ends is
    /// the increment over dt, whatever the forces, but for what the velocity filter takes.
    Vec6 end_rate(const int block, const Vec6 &increment) const
    {
      const double part = filter[block];
      return (2. / dt * increment - (1. - part) * rate[block] + part * change[block]) / (1. + part);
    }

    /// What the block remembers of changes of its velocity after the step, not yet turned.
    Vec6 remembered(const int block, const Vec6 &end) const;

    /// What the velocity filter takes of the block's energy [J/m].
    double filter_loss(const int block, const BlockMass &mass, const Vec6 &end) const;

  private:
    /// Blocks that touch others, or may in this step, have a velocity filter; torn ends of joints
    /// are contacts, too.
    void choose_filters(const Model &model, const Springs &springs);

    double              dt   = 0.; ///< [s]
    double              beta = 0.; ///< Newmark's [-]
    std::vector<Vec6>   prediction;
    std::vector<Vec6>   rate;   ///< see start_rates(), k01 v
    std::vector<double> filter; ///< Newmark::velocity_filter; 0 where nothing touches the block
    std::vector<Vec6>   change; ///< remembered of that of the velocity before the step
  };
} // namespace hybrid::dda
