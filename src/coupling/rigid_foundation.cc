// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/rigid_foundation.h>

namespace hybrid::coupling
{
  RigidFoundation::RigidFoundation(std::vector<Vec2>          surface,
                                   const scene::GroundMotion &base_motion)
    : nodes(std::move(surface))
    , motion(base_motion)
  {
    response.prescribed   = true;
    response.displacement = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(nodes.size()));
  }



  const dda::FoundationResponse &RigidFoundation::predict(const CoupledState &state,
                                                          const double        dt)
  {
    if (!motion.empty())
      {
        const Vec2 u = motion.outcrop_displacement(state.time + dt);
        for (std::size_t k = 0; k < nodes.size(); ++k)
          response.displacement.segment<2>(2 * static_cast<Eigen::Index>(k)) = u;
      }
    return response;
  }



  PrescribedMotion RigidFoundation::prescribed_motion(const double time) const
  {
    return {motion.outcrop_velocity(time), motion.outcrop_acceleration(time)};
  }

} // namespace hybrid::coupling
