// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/maxwell_memory.h>
#include <hybrid/continuum/slip_state.h>
#include <hybrid/scene/types.h>

#include <vector>

namespace hybrid::continuum
{
  /// Energy of the continuum [J/m]; work and losses since the start. Each term is computed on its
  /// own, but for damping_loss of rock that damps in explicit steps (rock_work).
  struct ContinuumEnergy
  {
    double kinetic          = 0.; ///< 1/2 v M v, now
    double strain           = 0.; ///< 1/2 u K u, bedding planes and Maxwell branches included, now
    double boundary_springs = 0.; ///< in the springs of visco-elastic boundaries, now
    double input_work       = 0.; ///< done by the incident wave's tractions or the prescribed base
    double surface_work     = 0.; ///< done by the interface forces
    double boundary_loss =
      0.; ///< taken up by dashpots (relative to the free field where there is one)
    double damping_loss          = 0.; ///< Rayleigh and Maxwell damping
    double bedding_loss          = 0.; ///< slip and breaking of bedding planes
    double bedding_static_stress = 0.; ///< static stress that their slip released (negative), now
    double integration_loss      = 0.; ///< Newmark's own dissipation
    double rock_work = 0.; ///< on rock that damps, of explicit steps: strain and damping_loss share
                           ///< it in an audit
  };

  /// All mutable state of the continuum: copied for roll-back, written for restart.
  struct ContinuumState
  {
    double time      = 0.;            ///< [s]
    double last_step = 0.;            ///< of acceleration_change, or of the parts of explicit
                                      ///< steps [s]; 0: none
    std::vector<double> displacement; ///< u [m], all unknowns, or where ranks share them those of
                                      ///< HeldNodes, free-field columns last; increment since the
                                      ///< static state
    std::vector<double> velocity;     ///< v [m/s]
    std::vector<double> acceleration; ///< a [m/s2]
    std::vector<double> contact_acceleration; ///< part of a that ends with the step, see
                                              ///< SurfaceForce, of the rock's nodes [m/s2]; empty:
                                              ///< none
    std::vector<double> acceleration_change;  ///< remembered by a Newmark::filter, of a without
                                              ///< contacts [m/s2]; empty without one
    Vec2 base_force_change = Vec2::Zero();    ///< the same of the force that moves a base [N/m]
    std::vector<double> surface_force;        ///< lambda of the last step [N/m]; empty: zero
    std::vector<double> surface_contact; ///< its part that ended with the step [N/m]; empty: zero
    SlipState           slip;            ///< of bedding planes
    std::vector<SlipState> column_slip;  ///< of the planes' joints in each free-field column; empty
                                         ///< where none slips
    MaxwellState    maxwell;             ///< of Maxwell damping
    ContinuumEnergy energy;
  };

  // All members, for the checkpoint (restart/archive.h).
  void serialize(restart::Archive &archive, ContinuumEnergy &energy);
  void serialize(restart::Archive &archive, ContinuumState &state);
} // namespace hybrid::continuum
