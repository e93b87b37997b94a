// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/continuum_state.h>
#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/point_loads.h>
#include <hybrid/continuum/rock_damping.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * What acts on the rock of ExplicitWaves besides itself: base and sides with their free-field
   * columns, bedding planes that stay elastic, point loads. Nodes that one of these acts on have a
   * "place", and move here: of n unknowns in the order of sqrt(n), so each rank does it for all.
   *
   * Edges and joints are integrated by Gauss-Lobatto quadrature, as the rock's mass.
   */
  class WaveEdges
  {
  public:
    /// @param loads on the rock's nodes @param boundary on an edge basis by Lobatto's quadrature
    WaveEdges(const RockMesh       &rock,
              const ElementNodes   &nodes,
              const JointStiffness &joint_stiffness,
              const PointLoads     &loads,
              BoundaryForces       &boundary,
              const RockDamping    &damping);

    /// Of the rock, in the order of places; vectors of places hold x and y of each.
    const std::vector<int> &nodes() const
    {
      return list;
    }

    /// Mass of the places [kg/m].
    void set_mass(std::vector<double> of_places);

    const std::vector<double> &mass() const
    {
      return m;
    }

    struct Motion
    {
      std::vector<double> displacement, velocity, acceleration;
    };

    /// Motion of the places.
    const Motion &motion() const
    {
      return now;
    }

    /// Where a state has what moves here.
    struct InState
    {
      std::size_t             columns; ///< first unknown of the free-field columns
      const std::vector<int> &slots;   ///< of the nodes with a place (HeldNodes)
    };

    /// From a state whose places and columns are those of its time, after a step in parts of
    /// ContinuumState::last_step.
    void take(const ContinuumState &state, const InState &where);

    void put(ContinuumState &state, const InState &where) const;

    /// First half of a part of a step: velocity at its middle, displacement at its end.
    void move(double dt);

    bool has_joints() const
    {
      return !joints.empty();
    }

    /// Add what joints push with at the displacement @p u of the places [N/m].
    void add_joint_forces(const std::vector<double> &u, std::vector<double> &force) const;

    /// Add what the boundary's springs push with at the displacement @p u of the places, the free
    /// field at rest [N/m].
    void add_spring_forces(const std::vector<double> &u, std::vector<double> &force) const;

    /// Second half: acceleration and velocity at the end, @p time. @param rock_force of rock and
    /// joints on the places there [N/m]
    void accelerate(double time, double dt, const std::vector<double> &rock_force);

    /// Acceleration of a state that is given, at @p time.
    void find_acceleration(double time, const std::vector<double> &rock_force);

    /// Works and losses over the part of a step that has ended. @param rock_force0, rock_force1 at
    /// its ends [N/m]; looked at only if the base moves
    void add_energy(const std::vector<double> &rock_force0,
                    const std::vector<double> &rock_force1,
                    ContinuumEnergy           &energy);

    /// The base is rigid and moves as prescribed.
    bool has_moving_base() const
    {
      return !boundary.moving_nodes().empty();
    }

  private:
    /// Two places on the two sides of an elastic bedding plane.
    struct Joint
    {
      int             left, right;
      Eigen::Matrix2d stiffness; ///< [N/m per m]
    };

    int  place_of(int node);
    void add_joints(const RockMesh &, const ElementNodes &, const JointStiffness &);
    void step_columns(double time, double dt);

    /// What the columns send in at @p time. @param later their velocity is of this after that which
    /// strains them [s]
    void find_incoming(double time, double later);

    /// Of boundary and loads on the places at velocity @p v [N/m].
    void outer_forces(double                          time,
                      const BoundaryForces::Incoming &incoming,
                      const std::vector<double>      &v,
                      std::vector<double>            &force) const;

    Vec2 acceleration_of(int place, double time, double half_step, const Vec2 &force) const;

    void add_spring_energy(ContinuumEnergy &energy);

    BoundaryForces              &boundary;
    const RockDamping            damping;
    std::vector<int>             list;
    std::vector<int>             place; ///< per node, -1: none; in the constructor only
    std::vector<Joint>           joints;
    PointLoads                   point_loads; ///< on places
    std::vector<Eigen::Matrix2d> dashpots;    ///< per place
    std::vector<Support>         support;     ///< per unknown of the places
    std::vector<double>          m;           ///< mass

    Motion                   now, before, columns, next_columns;
    std::vector<double>      column_branch, next_column_branch; ///< as in MaxwellState
    std::vector<double>      column_strained;
    BoundaryForces::Incoming incoming0, incoming1;
    std::vector<double>      force0, force1, change, change_free, mean, mean_free;
  };
} // namespace hybrid::continuum
