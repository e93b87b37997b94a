// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/sleep.h>
#include <hybrid/restart/archive.h>

namespace hybrid::dda
{
  namespace
  {
    /// All of the state but the time, as bytes.
    std::string bytes(DdaState &state, const std::size_t expected)
    {
      const double now         = state.time;
      state.time               = 0.;
      restart::Archive archive = restart::Archive::writer(expected);
      archive(state);
      state.time = now;
      return archive.take_content();
    }



    double load_factor(const Model &model, const double time)
    {
      return model.edge_loads.edges.empty() ? 0. : model.edge_loads.factor(time);
    }
  } // namespace



  bool Sleep::lasts(const Model              &model,
                    const DdaState           &state,
                    const FoundationResponse &foundation,
                    const double              dt) const
  {
    return is_asleep && dt == step && foundation.prescribed &&
           foundation.displacement == state.foundation_displacement &&
           load_factor(model, state.time) == load && load_factor(model, state.time + dt) == load;
  }



  void
  Sleep::rested(const Model &model, DdaState &state, const double dt, const StepResult &step_result)
  {
    const double now   = load_factor(model, state.time);
    std::string  after = bytes(state, left.size());
    is_asleep =
      dt == step && now == load && load_factor(model, state.time - dt) == load && after == left;
    step  = dt;
    load  = now;
    found = step_result;
    left  = std::move(after);
  }
} // namespace hybrid::dda
