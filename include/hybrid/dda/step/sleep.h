// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/step/foundation_response.h>
#include <hybrid/dda/step/step_result.h>

#include <string>
#include <utility>

namespace hybrid::dda
{
  /**
   * Steps of a mass at rest that need not be computed.
   *
   * A step is a map: it makes a state of a state, of its own size, of where the base goes and of
   * what loads the edges and where the water stands. A step at rest
   * (OpenCloseIteration::is_at_rest()) changes nothing else that the solver keeps. So if two such
   * steps, one after the other, leave the same state to the last bit, but for the time, then every
   * further one with the same size, base and loads leaves it again. The mass sleeps until one of
   * these changes; only the time goes on.
   *
   * Nothing of it is in the state or in a checkpoint: a run that is resumed computes two steps,
   * with the same bits, and sleeps again.
   */
  class Sleep
  {
  public:
    /// Loads that change in time: factor on the edge loads [-], level of the water [m].
    using Loads = std::pair<double, double>;

    /// True if the step from @p state would only find @p state again. @pre since the step before,
    /// nothing but the time was changed in @p state.
    bool lasts(const Model              &model,
               const DdaState           &state,
               const FoundationResponse &foundation,
               double                    dt) const;

    /// What the steps asleep come to.
    const StepResult &result() const
    {
      return found;
    }

    /// A step at rest that came to @p step_result was accepted and left @p state.
    void rested(const Model &model, DdaState &state, double dt, const StepResult &step_result);

    /// A step was computed that is not at rest, or failed.
    void wake()
    {
      is_asleep = false;
      left.clear();
      left.shrink_to_fit();
    }

  private:
    /// Keep the bytes of @p state, but for the time. @return whether they are those kept before
    bool keep(DdaState &state);

    bool        is_asleep = false;
    double      step      = 0.; ///< size of those steps [s]
    Loads       loads     = {}; ///< at their end
    std::string left;           ///< bytes of the state after the last step at rest; empty: none
    StepResult  found;
  };
} // namespace hybrid::dda
