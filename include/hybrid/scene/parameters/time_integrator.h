// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// What of a scene is more than waves alone in a bedrock of finite elements, in words; empty:
  /// nothing.
  std::string why_not_waves_alone(const SceneParameters &scene);

  /// What of a scene explicit integration of the bedrock cannot do, in words; empty: nothing.
  std::string why_not_explicit(const SceneParameters &scene);

  /// Take Continuum/Time integrator = explicit into the scene. @throws InputError if it cannot be.
  void resolve_time_integrator(SceneParameters &scene, const ParameterTable &table);

  /// Central differences from now on.
  void take_explicit(SceneParameters &scene);
} // namespace hybrid::scene
