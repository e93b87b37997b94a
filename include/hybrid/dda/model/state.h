// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block.h>
#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/contact_scope.h>
#include <hybrid/dda/contact/rest_state.h>
#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/dda/joint/joint_law.h>
#include <hybrid/restart/archive_forward.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /// How a joint failed.
  enum class FailureKind
  {
    none,
    tensile,
    shear
  };


  /// What a spring (joint point or contact) carried when the step was accepted.
  struct SpringState
  {
    JointHistory history;
    Vec2   jump   = Vec2::Zero(); ///< place of the other side's point relative to this side's [m]
    double gap    = 0.;           ///< [m]
    double slip   = 0.;           ///< [m]
    double normal = 0.; ///< total normal traction, damping included [Pa], compression positive
    double shear  = 0.; ///< total shear traction, damping included [Pa]
    double elastic_normal = 0.; ///< without damping [Pa]
    double elastic_shear  = 0.; ///< without damping [Pa]
    ContactState state    = ContactState::locked;
  };


  /// State of one joint.
  struct JointState
  {
    SpringState points[2];
    FailureKind failure      = FailureKind::none;
    double      failure_time = 0.; ///< [s]; negative: in the static stage
    bool has_yielded = false;      ///< its blocks look at all their neighbours, see joint_failure.h
    bool released    = false;      ///< slid or opened so far that vertex contacts took over
    bool handed_over = false;      ///< released, and its contacts have its load: joint_release.h
    bool parted[2]   = {false, false}; ///< ends of a released belt that have lost their
                                       ///< cohesion for good: belt_parting.h
    double rest_slip[2] = {0., 0.};    ///< slip of the ends at rest, from which slip counts [m]
    double drawn_gap[2] = {0., 0.};    ///< of the ends where blocks lie as drawn, not 0 with an
                                       ///< initial stress [m]
    Vec2 force_change = Vec2::Zero();  ///< on its block, remembered: bond_memory.h [N/m]
  };


  /// Energy of the blocks [J/m]; losses and work are sums since the dynamic stage began.
  struct BlockEnergy
  {
    double kinetic          = 0.; ///< 1/2 v M v, now
    double strain           = 0.; ///< of the blocks, now
    double gravity          = 0.; ///< potential of weight and water relative to the start, now
    double springs          = 0.; ///< stored in joints and contacts, now
    double friction_loss    = 0.; ///< plastic slip
    double yield_loss       = 0.; ///< plastic strain of blocks
    double bedding_loss     = 0.; ///< slip and breaking of bedding planes
    double fracture_loss    = 0.; ///< tensile cracking
    double damping_loss     = 0.; ///< damping of blocks and joints, and dynamic coefficient
    double integration_loss = 0.; ///< Newmark's own dissipation, springs included
    double spring_replacement_loss = 0.; ///< stored energy that vanished when springs were replaced
    double foundation_work         = 0.; ///< done by the foundation on the blocks
    double boundary_loss           = 0.; ///< dashpots on edges of the bedrock's blocks
    double input_work              = 0.; ///< done by what comes in through them
    double static_work             = 0.; ///< against the static forces that the bedrock bears
    double edge_load_work          = 0.; ///< done by tractions on the blocks' edges
    double water_work              = 0.; ///< done by water whose level changes

    BlockEnergy &operator+=(const BlockEnergy &other)
    {
      kinetic += other.kinetic;
      strain += other.strain;
      gravity += other.gravity;
      springs += other.springs;
      friction_loss += other.friction_loss;
      yield_loss += other.yield_loss;
      bedding_loss += other.bedding_loss;
      fracture_loss += other.fracture_loss;
      damping_loss += other.damping_loss;
      integration_loss += other.integration_loss;
      spring_replacement_loss += other.spring_replacement_loss;
      foundation_work += other.foundation_work;
      boundary_loss += other.boundary_loss;
      input_work += other.input_work;
      static_work += other.static_work;
      edge_load_work += other.edge_load_work;
      water_work += other.water_work;
      return *this;
    }

    /// Energy now held plus energy lost, less the work received: constant if nothing is created
    /// [J/m].
    double balance() const
    {
      return kinetic + strain + gravity + springs + friction_loss + yield_loss + bedding_loss +
             fracture_loss + damping_loss + integration_loss + spring_replacement_loss -
             foundation_work + boundary_loss - input_work + static_work - edge_load_work -
             water_work;
    }
  };


  /// Of the sliding mass on all that it stands on [N/m]; see surface_force().
  struct SurfaceForce
  {
    Vec2   force    = Vec2::Zero(); ///< resultant, also of what acts across the surface
    double shear    = 0.;           ///< sum of shear, downhill positive (+x where level)
    double normal   = 0.;           ///< sum of normal forces, compression positive
    double strength = 0.;           ///< that the shear may reach, of all that presses or is bonded

    SurfaceForce &operator+=(const SurfaceForce &other)
    {
      force += other.force;
      shear += other.shear;
      normal += other.normal;
      strength += other.strength;
      return *this;
    }
  };


  /// All mutable state of the blocks: copied for roll-back, written for restart.
  struct DdaState
  {
    double                  time      = 0.; ///< [s]
    double                  last_step = 0.; ///< of BlockState::acceleration_change [s]; 0: none
    Geometry                geometry;
    std::vector<BlockState> blocks;
    std::vector<Eigen::Vector3d>
      branch_stress; ///< t_l of MaxwellStresses, MaxwellBlocks::n_branches()
                     ///< for each block (xx, yy, xy) [Pa]; empty: none
    std::vector<JointState>   joints;
    std::vector<Contact>      contacts;
    std::vector<ContactScope> contact_scope;  ///< per block, at the last search
    RestState                 rest;           ///< what lies still
    Eigen::VectorXd foundation_displacement;  ///< (x0, y0, x1, ...) [m], since the static state
    Eigen::VectorXd foundation_force;         ///< on the foundation nodes [N/m], now
    Eigen::VectorXd foundation_contact_force; ///< contacts' part of it [N/m], see Springs
    Eigen::VectorXd static_force; ///< on the foundation nodes at the end of the static stage [N/m]
    Eigen::VectorXd static_contact_force; ///< contacts' part of it [N/m]
    Eigen::VectorXd bedrock_static_force; ///< on the bedrock's blocks then, six each; empty: none
    Eigen::VectorXd boundary_force;       ///< incoming, see ViscousBoundary [N/m], now
    SurfaceForce    surface_force;        ///< of the mass on what it stands on, now
    BlockEnergy     energy;
  };


  /// Largest speed of a block's corner, as a rigid body [m/s]; 0 without blocks.
  double fastest_block(const DdaState &state);


  // All members, for the checkpoint (restart/archive.h).
  void serialize(restart::Archive &archive, SpringState &spring);
  void serialize(restart::Archive &archive, JointState &joint);
  void serialize(restart::Archive &archive, Contact &contact);
  void serialize(restart::Archive &archive, BlockState &block);
  void serialize(restart::Archive &archive, BlockEnergy &energy);
  void serialize(restart::Archive &archive, Geometry &geometry);
  void serialize(restart::Archive &archive, RestState &rest);
  void serialize(restart::Archive &archive, SurfaceForce &surface);
  void serialize(restart::Archive &archive, DdaState &state);
} // namespace hybrid::dda
