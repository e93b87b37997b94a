// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /// Tractions of a joint's end; compression and the shear of JointLaw [Pa].
  struct JointTraction
  {
    double normal = 0., shear = 0.;
    bool   broken = false;
  };


  /// Give an end of a joint the elastic stretch of its traction, without slip.
  void stretch(const Model         &model,
               const Joint         &joint,
               const JointTraction &traction,
               SpringState         &point);
} // namespace hybrid::dda
