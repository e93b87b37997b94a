// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/free_field_column.h>
#include <hybrid/coupling/rigid_foundation.h>
#include <hybrid/dda/block/boundary_edge.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <optional>
#include <vector>

namespace hybrid::coupling
{
  /**
   * What a bedrock of blocks stands on: a base that moves as prescribed (below
   * layers, and below triangles unless their base is compliant), and the rock
   * beyond the artificial boundaries, which sends in
   *   t_in + Z v_ff = 2 Z v_up                          at a compliant base,
   *                   0                                 at a viscous side,
   *                   stress + Z velocity of a column   at a free-field side
   * (see dda::ViscousBoundary). A column has the joint of a bedding plane where one meets the side.
   * The columns' motion is in CoupledState::columns.
   */
  class BlockFoundation final : public Foundation
  {
  public:
    /// @param nodes of the prescribed base [m]; may be empty.  @param motion may be empty.
    /// @param blocks whose artificial boundaries the forces act on, in their order.
    /// @throws InputError for free-field sides that are not vertical.
    BlockFoundation(std::vector<Vec2>             nodes,
                    const scene::GroundMotion    &motion,
                    const scene::SceneParameters &scene,
                    const dda::Model             &blocks);

    const std::vector<Vec2> &surface_nodes() const override
    {
      return below.surface_nodes();
    }

    PrescribedMotion prescribed_motion(const double time) const override
    {
      return below.prescribed_motion(time);
    }

    void start(CoupledState &state) const override;

    /// The columns' joints bear what the planes beside them bear.
    void take_rest(CoupledState &state) const override;

    const dda::FoundationResponse &predict(const CoupledState &state, double dt) override;

    continuum::SlipStatus
    solve_slip(const CoupledState &state, double dt, const Eigen::VectorXd &displacement) override;

    void correct(CoupledState                  &state,
                 double                         dt,
                 const Eigen::VectorXd         &displacement,
                 const continuum::SurfaceForce &force) override;

  private:
    /// A boundary edge beside a column: its element, and where the column's unknowns begin.
    struct BesideColumn
    {
      int edge, first;
    };

    /// The end of a joint of the blocks that a column's joint stands beside.
    struct JointEnd
    {
      int joint, point;
    };

    const std::vector<dda::BoundaryEdge>    boundary;
    RigidFoundation                         below;
    const scene::GroundMotion               motion; ///< empty if the base is fixed
    const bool                              compliant;
    const continuum::LagrangeLine           line;
    const double                            damping_time; ///< beta_K of the columns [s]
    const Newmark                           newmark;      ///< of the columns
    const MaxwellBody                       maxwell;      ///< of the columns
    std::vector<continuum::FreeFieldColumn> columns;
    std::vector<int>                        column_offset; ///< first unknown of each
    std::vector<BesideColumn>               sides;
    std::vector<JointEnd>                   ends; ///< of the columns' joints, one after the other
    bool                                    columns_settled = true; ///< in the step
    ColumnState                             at_end;                 ///< of the step
    dda::FoundationResponse                 response;

    void add_column(dda::BoundaryPart             side,
                    const scene::SceneParameters &scene,
                    const dda::Model             &blocks);

    /// What a column is but for its elements.
    continuum::FreeFieldColumn::Model column_model(const dda::BoundaryEdge      &lowest,
                                                   const scene::SceneParameters &scene) const;

    /// The joint of a plane that ends at a place of the side; none if no plane does or more do.
    std::optional<continuum::ColumnJoint> add_joint(const dda::Model &blocks, const Vec2 &place);

    bool slips() const;

    void step_columns(const CoupledState &state, double dt);

    /// Incoming forces at @p time.
    void set_forces(double time);

    void add_column_forces(const BesideColumn &side);

    /// Displacement that stresses a column, u with that of the Maxwell branches, of an unknown [m].
    double stressed(std::size_t unknown) const;
  };
} // namespace hybrid::coupling
