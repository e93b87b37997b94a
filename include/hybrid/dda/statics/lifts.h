// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /// What became of a mass that was placed in lifts.
  struct LiftResult
  {
    int    lifts                = 0;  ///< that brought blocks
    double largest_displacement = 0.; ///< of a centroid since its lift was placed [m]
    Vec2   place{0., 0.};             ///< where that block was drawn [m]
  };


  /**
   * The stress that blocks and joints have when the mass is placed in horizontal lifts from below
   * (Gravity/Initial stress = staged; Goodman & Brown 1963, Clough & Woodward 1967).
   *
   * Each lift is placed without stress where it was drawn, on what is there already, and then gets
   * its weight and the water's load. With the stiffness K_m of blocks and joints placed so far and
   * the loads f_m of those that lift m brings,
   *   K_m u_m = f_m,    stress = sum_m D e(u_m),    traction of a joint = sum_m k jump(u_m),
   * over the lifts since a block or both sides of a joint were placed. It is linear elasticity of
   * the section as drawn: bonds hold whatever they bear, contacts are not closed, the bedrock does
   * not move. Strengths, finite displacements and the horizontal coefficient are the static
   * stage's, which follows.
   *
   * Lifts are equally high, between the lowest and the highest vertex of the mass; a block belongs
   * to that of its centroid, but waits for the first one in which joints hold it, by way of others,
   * to the ground. A lift that brings no block is none.
   *
   * @param lifts >= 1; with one, gravity is switched on
   * @pre check_lifts()
   */
  LiftResult place_in_lifts(const Model &model, int lifts, DdaState &state);

  /// @throws InputError if joints do not hold every block of the mass to the ground
  void check_lifts(const Model &model);
} // namespace hybrid::dda
