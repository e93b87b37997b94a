// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/condensed_foundation.h>

namespace hybrid::coupling
{
  const dda::FoundationResponse &CondensedFoundation::predict(const CoupledState &state,
                                                              const double        dt)
  {
    const continuum::SurfaceStiffness &s = continuum.surface_stiffness(dt);
    response.prescribed                  = false;
    response.stiffness =
      s.is_band ? dda::FoundationStiffness::band(s.entries) : dda::FoundationStiffness(&s.entries);
    response.load = continuum.predict(state.continuum, dt);
    continuum.extrapolate_surface(state.continuum, dt, response.displacement);
    if (water != nullptr)
      {
        water->begin(state.time, dt, state.blocks.foundation_displacement);
        response.load += water->force();
      }
    return response;
  }



  continuum::SlipStatus CondensedFoundation::solve_slip(const CoupledState    &state,
                                                        const double           dt,
                                                        const Eigen::VectorXd &displacement)
  {
    const auto status = continuum.solve_slip(state.continuum, dt, displacement);
    if (status == continuum::SlipStatus::changed)
      {
        response.load = continuum.surface_load();
        if (water != nullptr)
          response.load += water->force();
        response.displacement = displacement; // the first guess now
      }
    return status;
  }



  void CondensedFoundation::correct(CoupledState                  &state,
                                    const double                   dt,
                                    const Eigen::VectorXd         &displacement,
                                    const continuum::SurfaceForce &force)
  {
    if (water == nullptr)
      {
        continuum.correct(state.continuum, dt, displacement, force);
        return;
      }
    with_water = force;
    with_water.all += water->force();
    continuum.correct(state.continuum, dt, displacement, with_water);
    state.blocks.energy.water_work += water->work(displacement);
  }
} // namespace hybrid::coupling
