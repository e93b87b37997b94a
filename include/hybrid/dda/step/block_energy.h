// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>
#include <hybrid/dda/step/block_stresses.h>
#include <hybrid/dda/step/step_kinematics.h>

namespace hybrid::dda
{
  /**
   * The energy audit of one accepted step, each term computed on its own.
   *
   * With F = M a at both ends of a step, and the contacts' force C = M c at
   * its end, the step obeys exactly
   *   D[1/2 v M v] = d . ((1 - gamma) F_0 + gamma F_1 + C)
   * (Krenk 2006 without C, with 2 beta = gamma), so the work of every force is its product with the
   * increment at the weights (1 - gamma, gamma), of contacts (0, 1). A contact
   * spring then only dissipates: C . d = -D(1/2 k g^2) - 1/2 k Dg^2.
   */
  struct StepAudit
  {
    const Model                  &model;
    const DdaState               &before; ///< state when the step began
    const Trial                  &trial;
    const Springs                &springs;
    const BlockStresses          &stresses;
    const std::vector<BlockMass> &mass;
    const std::vector<double>    &damping_time; ///< beta_K of each block [s]
    const StepKinematics         &kinematics;
    const Eigen::VectorXd        &incoming; ///< at artificial boundaries, end of the step [N/m]
    bool at_rest = false; ///< the blocks stop: what they had is lost to the integration
  };

  /// Energy after the step.
  BlockEnergy audit_step(const StepAudit &step);

  /// Energy held by a state, from scratch, with all losses and works zero [J/m].
  BlockEnergy stored_energy(const Model &model, const DdaState &state);
} // namespace hybrid::dda
