// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/base.h>
#include <hybrid/scene/motion.h>

namespace hybrid::coupling
{
  /// A rigid base that follows the outcrop motion: pure DDA.
  class RigidBase final : public Base
  {
  public:
    /// @param nodes of the surface [m]; may be empty.
    /// @param motion prescribed; may be empty (fixed base).
    /// @param direction unit vector of shaking.  @param start_time of the motion [s].
    RigidBase(std::vector<Vec2>    nodes,
              const scene::Motion &motion,
              const Vec2          &direction,
              double               start_time);

    const std::vector<Vec2> &surface_nodes() const override
    {
      return nodes;
    }

    const dda::BaseResponse &predict(const continuum::ContinuumState &state, double dt) override;

    void correct(continuum::ContinuumState     &state,
                 double                         dt,
                 const Eigen::VectorXd         &displacement,
                 const continuum::SurfaceForce &force) override;

  private:
    const std::vector<Vec2> nodes;
    const scene::Motion     motion;
    const Vec2              direction;
    const double            start_time;
    dda::BaseResponse       response;
  };
} // namespace hybrid::coupling
