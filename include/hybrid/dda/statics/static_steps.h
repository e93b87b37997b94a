// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/dda/step/part_times.h>

#include <functional>

namespace hybrid::dda
{
  /// What became of a static problem.
  struct StaticResult
  {
    bool   equilibrium          = false; ///< relative residual below the target
    bool   stopped              = false; ///< by whoever watches: the state is of no use
    int    steps                = 0;
    int    iterations           = 0; ///< open-close iterations
    int    cuts                 = 0;
    double residual             = 0.; ///< relative to the sum of absolute forces [-]
    double largest_displacement = 0.; ///< of a centroid [m]
    int    moving_block = -1; ///< that moved most in the last step, if there is no equilibrium

    int    fallen_block = -1; ///< came to rest farther than elasticity explains, most of all; or -1
    double fallen_by    = 0.; ///< its displacement [m]
    double turned_by    = 0.; ///< its rotation [rad]

    int slid_block =
      -1; ///< loose, came to rest farther than elasticity explains, most of all; or -1
    double slid_by            = 0.; ///< its displacement [m]
    double elastic_settlement = 0.; ///< a bound on what of it is elastic, see elastic_settlement()

    PartTimes times; ///< of the steps
  };


  /// How far static steps are.
  struct StaticProgress
  {
    int    steps      = 0;  ///< done
    int    iterations = 0;  ///< open-close iterations done
    double residual   = 1.; ///< after the last step [-]
    double target     = 0.; ///< the steps end at this residual [-]
  };

  /// Told before every open-close iteration; the steps end where it returns false.
  using StaticWatch = std::function<bool(const StaticProgress &)>;


  /// How the pseudo time step of static steps grows, and when they are given up.
  struct StaticPace
  {
    double growth        = 2.; ///< of the step after one that converged [-]
    int    maximum_steps = 400;
  };


  /// The same problem without damping and edge loads, solved more exactly than a dynamic step,
  /// with contacts and all other forces balanced at the end of the step.
  Model static_problem(const Model &model);

  /// The same problem with contacts that never slide.
  Model with_unlimited_friction(Model model);

  /// The same problem with bonds and blocks of the mass that never give way. Planes in the bedrock
  /// keep their strengths.
  Model with_unlimited_bonds(Model model);

  /// Neither friction nor bonds of the mass give way.
  Model with_unlimited_strengths(const Model &model);

  /// The same model whose bedding planes bear anything, if it has a bedrock of blocks.
  Model with_unlimited_planes(Model model);


  /**
   * Bring the blocks to rest on the foundation where it is.
   *
   * Implicit steps from rest with a pseudo time step that grows until inertia is
   * negligible: Newton's method for the static problem with mass as regularisation, so that a mass
   * that cannot stand is seen to move instead of giving a singular matrix. Ends at rest with a
   * relative residual of 1e-9, or gives up. Joints that fail get a negative failure time;
   * DdaState::time is of no use then.
   *
   * @param problem of static_problem()
   * @param watch may be empty.
   */
  StaticResult take_static_steps(const Model       &problem,
                                 DdaState          &state,
                                 const StaticPace  &pace  = {},
                                 const StaticWatch &watch = {});
} // namespace hybrid::dda
