// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/boundary_springs.h>
#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/element_nodes.h>
#include <hybrid/continuum/free_field_column.h>
#include <hybrid/continuum/node_matrices.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::continuum
{
  /// What fixes an unknown.
  enum class Support : char
  {
    none,       ///< solved for
    zero,       ///< displacement zero
    base_motion ///< moves with the rigid base
  };


  /**
   * Base and sides of the model. The traction on a face with outward normal n is
   *   t = t_in + Z (v_ff - v) + k (u_ff - u),  Z = rho (a c_p n n^T + b c_s (1 - n n^T)),
   * a and b of scene::SideBoundary (1 on the base), with t_in = 2 Z v_up and v_ff = 0 on a
   * compliant base (Z of the half space below), t_in = 0 and v_ff = 0 on a viscous side, and stress
   * and velocity of the free-field column on a free-field side; k = 0 unless the scene asks for
   * springs (boundary_springs.h). Their free field is the column's on a free-field side, at rest on
   * a viscous one; on the base it is that of the columns' feet, linear between them, and without
   * columns the upgoing wave. Where a bedding plane meets a free-field side its column has the
   * plane's joint (ColumnJoints); two planes that meet there are welded in it. All integrals are
   * consistent with the element's edge basis, so a corner takes each dashpot once.
   */
  class BoundaryForces
  {
  public:
    BoundaryForces(const RockMesh               &rock,
                   const ElementNodes           &nodes,
                   const CellMaterials          &cell_material,
                   const scene::SectionMesh     &section,
                   const scene::SceneParameters &scene,
                   scene::GroundMotion           motion);

    /// Per unknown of the finite-element space.
    const std::vector<Support> &supports() const
    {
      return support;
    }

    /// Nodes of a base that moves as prescribed.
    const std::vector<int> &moving_nodes() const
    {
      return moving;
    }

    /// Nodes that carry forces; vectors "on the boundary" hold x and y of each in this order.
    const std::vector<int> &boundary_nodes() const
    {
      return nodes;
    }

    /// Add @p factor times the dashpots to 2 x 2 blocks on the pattern of @p matrices.
    void
    add_dashpots(const NodeMatrices &matrices, double factor, std::vector<double> &blocks) const;

    /// Of each boundary node, its dashpots as far as they resist its own velocity [N s/m per m]:
    /// all of them if the mass of the edges is by Lobatto's quadrature.
    std::vector<Eigen::Matrix2d> nodal_dashpots() const;

    /// Add the springs of visco-elastic boundaries to 2 x 2 blocks.
    void add_springs(const NodeMatrices &matrices, std::vector<double> &blocks) const
    {
      elastic.add_stiffness(matrices, nodes, blocks);
    }

    const BoundarySprings &springs() const
    {
      return elastic;
    }

    std::size_t n_column_unknowns() const;

    /// One step of the free-field columns; @p u, v, a: their unknowns at the start, the others
    /// receive the end. @param slip of each column's joints at the start, if planes may slip
    /// @return false if the slip of a column was not found.
    bool step_columns(const FreeFieldColumn::ConstMotion &old,
                      const FreeFieldColumn::Motion      &next,
                      double                              time,
                      double                              dt,
                      const std::vector<SlipState>       &slip = {});

    /// Slip of each column's joints; empty unless planes that may slip meet a free-field side.
    std::vector<SlipState> column_slip_at_rest() const;

    /// Write the slip of the last step_columns() into the state.
    void keep_column_slip(std::vector<SlipState> &slip) const;

    /// Tractions at rest on the points of BeddingPlanes [Pa], and which have failed: a column's
    /// joint begins with those of the point next to it.
    void set_column_rest(const std::vector<double> &traction, const std::vector<char> &failed);

    /// The motion of the columns as seen from the boundary, and the tractions they and the base
    /// send in.
    struct Incoming
    {
      std::vector<double> force;        ///< t_in integrated [N/m]
      std::vector<double> velocity;     ///< v_ff [m/s]; counts on free-field sides only
      std::vector<double> displacement; ///< u_ff [m]; on the base only with springs
    };

    /// @param u, v the columns' unknowns at @p time.
    /// @param stressed displacement that stresses them, as of MaxwellMemory; null: u
    void incoming(double        time,
                  const double *u,
                  const double *v,
                  Incoming     &in,
                  const double *stressed = nullptr) const;

    /// Forces [N/m] on the boundary at the velocity @p v (on the boundary).
    void forces(const Incoming &in, const std::vector<double> &v, std::vector<double> &f) const;

    /// What dashpots take up while the boundary moves by @p du at mean velocity @p v and the free
    /// field by @p du_ff at @p v_ff [J/m].
    double dashpot_loss(const std::vector<double> &du,
                        const std::vector<double> &v,
                        const std::vector<double> &du_ff,
                        const std::vector<double> &v_ff) const;

    /// Acceleration of a rigid base [m/s2].
    Vec2 base_acceleration(const double time) const
    {
      return motion.outcrop_acceleration(time);
    }

  private:
    /// A face with dashpots.
    struct Face
    {
      std::vector<int> nodes; ///< places in boundary_nodes()
      double           length;
      Vec2             normal; ///< outward
      Eigen::Matrix2d  impedance;
      bool             is_base;
      int              column = -1;   ///< free-field column, -1: none
      int    column_node      = 0;    ///< its node at the face's first node; nodes run upwards then
      double lambda = 0., shear = 0.; ///< of the rock beside or below [Pa]
    };

    /// Impedance over rho c_p and rho c_s [-].
    struct Dashpots
    {
      double normal, shear;
    };

    void set_base(const RockMesh &,
                  const ElementNodes &,
                  const CellMaterials &,
                  const std::vector<RockFace> &,
                  const scene::SceneParameters &);

    void set_side(const RockMesh &,
                  const ElementNodes &,
                  const CellMaterials &,
                  std::vector<RockFace>,
                  const scene::SceneParameters &);

    /// What columns of this scene have in common; below: the rock under the foot.
    FreeFieldColumn::Model column_model(const Material               &below,
                                        const scene::SceneParameters &scene) const;

    Face make_face(const RockMesh &,
                   const ElementNodes &,
                   const RockFace &,
                   const Material &,
                   const Dashpots &);

    void set_springs(const RockMesh &, const ElementNodes &, const scene::ContinuumParameters &);

    /// u_ff of the springs on the base.
    void incoming_base(double time, const double *u, Incoming &in) const;

    LagrangeLine         line;
    BoundarySprings      elastic;
    scene::GroundMotion  motion;
    bool                 compliant = false, moves = false;
    Material             half_space; ///< below the first base cell if none is named
    std::vector<Support> support;
    std::vector<int>     moving, nodes;
    std::vector<int>     place;  ///< node -> place in nodes; in the constructor only
    std::vector<double>  across; ///< with springs, per place: x from 0 at the left end to 1 [-]
    std::vector<Face>    faces;
    std::vector<FreeFieldColumn> columns;
    std::vector<int>             column_offset; ///< first unknown of each column
  };
} // namespace hybrid::continuum
