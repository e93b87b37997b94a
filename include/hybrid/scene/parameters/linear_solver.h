// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// @throws InputError if Continuum/Linear solver asks for what the scene cannot have.
  void check_linear_solver(const SceneParameters &scene, const ParameterTable &table);

  /// The scene with Linear solver = automatic decided for so many processes, as far as the scene
  /// alone can tell: conjugate gradients where all of them together are faster than a factor on
  /// one.
  SceneParameters with_linear_solver(SceneParameters scene, int processes);
} // namespace hybrid::scene
