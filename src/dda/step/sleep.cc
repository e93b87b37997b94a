// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/sleep.h>
#include <hybrid/restart/archive.h>

#include <string_view>

namespace hybrid::dda
{
  namespace
  {
    /// What changes in time of the loads.
    Sleep::Loads loads_at(const Model &model, const double time)
    {
      return {model.edge_loads.edges.empty() ? 0. : model.edge_loads.factor(time),
              model.water.changes() ? model.water.at(time).level : 0.};
    }
  } // namespace



  bool Sleep::lasts(const Model              &model,
                    const DdaState           &state,
                    const FoundationResponse &foundation,
                    const double              dt) const
  {
    return is_asleep && dt == step && foundation.prescribed &&
           foundation.displacement == state.foundation_displacement &&
           loads_at(model, state.time) == loads && loads_at(model, state.time + dt) == loads;
  }



  void
  Sleep::rested(const Model &model, DdaState &state, const double dt, const StepResult &step_result)
  {
    const Loads now     = loads_at(model, state.time);
    const bool  is_same = keep(state);
    is_asleep = is_same && dt == step && now == loads && loads_at(model, state.time - dt) == loads;
    step      = dt;
    loads     = now;
    found     = step_result;
  }



  bool Sleep::keep(DdaState &state)
  {
    const double now         = state.time;
    state.time               = 0.;
    std::size_t      size    = 0;
    bool             is_same = true;
    restart::Archive archive = restart::Archive::writer([&](const std::string_view part) {
      is_same = is_same && left.compare(size, part.size(), part) == 0;
      left.replace(size, part.size(), part);
      size += part.size();
    });
    archive(state);
    archive.flush();
    state.time = now;
    is_same    = is_same && left.size() == size;
    left.resize(size);
    return is_same;
  }
} // namespace hybrid::dda
