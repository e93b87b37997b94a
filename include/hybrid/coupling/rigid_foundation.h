// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/foundation.h>
#include <hybrid/scene/motion/ground_motion.h>

namespace hybrid::coupling
{
  /// A rigid base that moves as an outcrop: pure DDA.
  class RigidFoundation final : public Foundation
  {
  public:
    /// @param nodes of the surface [m]; may be empty.
    /// @param motion may be empty (fixed base).
    RigidFoundation(std::vector<Vec2> nodes, const scene::GroundMotion &motion);

    const std::vector<Vec2> &surface_nodes() const override
    {
      return nodes;
    }

    const dda::FoundationResponse &predict(const CoupledState &state, double dt) override;

    PrescribedMotion prescribed_motion(double time) const override;

    /// Nothing follows: it moves as prescribed.
    void correct(CoupledState &,
                 double,
                 const Eigen::VectorXd &,
                 const continuum::SurfaceForce &) override
    {}

  private:
    const std::vector<Vec2>   nodes;
    const scene::GroundMotion motion;
    dda::FoundationResponse   response;
  };
} // namespace hybrid::coupling
