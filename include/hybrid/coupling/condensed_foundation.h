// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/foundation.h>
#include <hybrid/coupling/water_on_bedrock.h>

#include <memory>
#include <utility>

namespace hybrid::coupling
{
  /**
   * The bedrock as one more block: its surface unknowns with the condensed
   * dynamic stiffness S (continuum/continuum.h). Solving blocks and surface
   * together is then the monolithic implicit solution, stable for any
   * stiffness ratio.
   */
  class CondensedFoundation final : public Foundation
  {
  public:
    /// The continuum must outlive the base.
    explicit CondensedFoundation(continuum::Continuum &bedrock)
      : continuum(bedrock)
    {}

    const std::vector<Vec2> &surface_nodes() const override
    {
      return continuum.surface_nodes();
    }

    std::vector<double> surface_shares() const override
    {
      return continuum.surface_shares();
    }

    void start(CoupledState &state) const override
    {
      state.continuum = continuum.initial_state();
    }

    /// The water's load on the surface from now on; nullptr: it stays.
    void set_water(std::unique_ptr<WaterOnBedrock> load)
    {
      water = std::move(load);
    }

    const dda::FoundationResponse &predict(const CoupledState &state, double dt) override;

    continuum::SlipStatus
    solve_slip(const CoupledState &state, double dt, const Eigen::VectorXd &displacement) override;

    void correct(CoupledState                  &state,
                 double                         dt,
                 const Eigen::VectorXd         &displacement,
                 const continuum::SurfaceForce &force) override;

  private:
    continuum::Continuum           &continuum;
    dda::FoundationResponse         response;
    std::unique_ptr<WaterOnBedrock> water;
    continuum::SurfaceForce         with_water; ///< of the last step, kept for its memory alone
  };
} // namespace hybrid::coupling
