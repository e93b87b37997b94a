// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>

namespace hybrid::scene
{
  /// What of a scene steps without a matrix cannot do, in words; empty: nothing.
  std::string why_not_iterated(const SceneParameters &scene);

  /// @throws InputError if Continuum/Linear solver asks for what the scene cannot have.
  void check_linear_solver(const SceneParameters &scene, const ParameterTable &table);

  /// The scene with Linear solver = automatic decided for so many processes, as far as the scene
  /// alone can tell: conjugate gradients where all of them together are faster than a factor on
  /// one. Below blocks they are taken by name, or where the factor does not fit the memory.
  SceneParameters with_linear_solver(SceneParameters scene, int processes);
} // namespace hybrid::scene
