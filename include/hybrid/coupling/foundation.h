// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/step/foundation_response.h>
#include <hybrid/scene/types.h>

#include <vector>

namespace hybrid::coupling
{
  /// How a base moves that moves as prescribed.
  struct PrescribedMotion
  {
    Vec2 velocity     = Vec2::Zero(); ///< [m/s]
    Vec2 acceleration = Vec2::Zero(); ///< [m/s2]
  };


  /**
   * What the blocks stand on: the condensed continuum, or a rigid base.
   *
   * A step from state.time to state.time + dt is
   *   1. predict(): what the blocks see of the base in this step;
   *   2. the blocks and the surface are solved together;
   *      2a. solve_slip(): bedding planes answer; what they change is in the response, and 2 is
   *          repeated until they are settled;
   *   3. correct(): what is below follows the surface. Each changes its own part of the state only.
   * predict() changes no state, so a step that does not converge leaves no trace.
   *
   * To add a base: derive from this class in a file of its own and construct
   * it in SceneModel.
   */
  class Foundation
  {
  public:
    virtual ~Foundation() = default;

    /// Nodes of the contact surface [m], left to right.
    virtual const std::vector<Vec2> &surface_nodes() const = 0;

    /// Per two nodes: what the first bears of a uniform load between them [-]; empty: half.
    virtual std::vector<double> surface_shares() const
    {
      return {};
    }

    /// Put its own part of @p state at rest.
    virtual void start(CoupledState & /*state*/) const
    {}

    /// Take over what the static stage has left in the blocks.
    virtual void take_rest(CoupledState & /*state*/) const
    {}

    virtual const dda::FoundationResponse &predict(const CoupledState &state, double dt) = 0;

    /// Slip inside the base for this displacement of its surface [m]; a base without it is settled.
    virtual continuum::SlipStatus solve_slip(const CoupledState &, double, const Eigen::VectorXd &)
    {
      return continuum::SlipStatus::settled;
    }

    /// At @p time [s], besides the displacement that the state of the blocks has; a base that
    /// answers the blocks has none.
    virtual PrescribedMotion prescribed_motion(double) const
    {
      return {};
    }

    /// @param displacement of the surface nodes at the end of the step [m].
    /// @param force of the blocks on them at the end of the step.
    virtual void correct(CoupledState                  &state,
                         double                         dt,
                         const Eigen::VectorXd         &displacement,
                         const continuum::SurfaceForce &force) = 0;
  };
} // namespace hybrid::coupling
