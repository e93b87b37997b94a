// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * A bound on what each block of the mass settles elastically under weight [m].
   *
   * Blocks that joints or closed contacts of @p rest connect, in one chain or another, are one
   * body: what carries a block, or leans on it, is in its body, and no other block moves it. A
   * body of height H as drawn settles by at most w H^2, joints as soft as blocks, with w the
   * largest rho g / G of its blocks, G the shear stiffness [1/m].
   */
  std::vector<double> elastic_settlement(const Model &model, const DdaState &rest);


  /// A bound on the work that the weights of the mass do over it [J/m].
  double work_of_settlement(const Model &model, const DdaState &rest);
} // namespace hybrid::dda
