// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// What of a scene explicit integration of the bedrock cannot do, in words; empty: nothing.
  std::string why_not_explicit(const SceneParameters &scene);

  /// Take Continuum/Time integrator = explicit into the scene. @throws InputError if it cannot be.
  void resolve_time_integrator(SceneParameters &scene, const ParameterTable &table);

  /// Longest step of explicit integration on @p mesh, estimated from the nearest nodes [s].
  double estimated_stable_step(const SectionMesh &mesh, const SceneParameters &scene);

  /// The scene with Time integrator = automatic decided: explicit if that is possible and takes
  /// less time, by the measured cost of both (doc/performance.md).
  SceneParameters with_time_integrator(SceneParameters scene, const SectionMesh &mesh);
} // namespace hybrid::scene
