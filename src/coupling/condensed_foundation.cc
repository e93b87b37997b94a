// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/condensed_foundation.h>

namespace hybrid::coupling
{
  const dda::FoundationResponse &CondensedFoundation::predict(const CoupledState &state,
                                                              const double        dt)
  {
    response.prescribed = false;
    response.stiffness  = &continuum.surface_stiffness(dt);
    response.load       = continuum.predict(state.continuum, dt);
    continuum.extrapolate_surface(state.continuum, dt, response.displacement);
    return response;
  }



  continuum::SlipStatus CondensedFoundation::solve_slip(const CoupledState    &state,
                                                        const double           dt,
                                                        const Eigen::VectorXd &displacement)
  {
    const auto status = continuum.solve_slip(state.continuum, dt, displacement);
    if (status == continuum::SlipStatus::changed)
      {
        response.load         = continuum.surface_load();
        response.displacement = displacement; // the first guess now
      }
    return status;
  }
} // namespace hybrid::coupling
