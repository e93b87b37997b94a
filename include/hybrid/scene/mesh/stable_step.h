// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /// Explicit parts that take the processor time of an implicit step, per unknown, measured on
  /// 150,000 unknowns and more (doc/performance.md).
  constexpr int parts_of_an_implicit_step = 15;

  /// Longest step of explicit integration on @p mesh, estimated from the nearest nodes [s].
  double estimated_stable_step(const SectionMesh &mesh, const SceneParameters &scene);

  /// The scene with Time integrator = automatic decided: explicit if that is possible and takes
  /// less time, by the measured cost of both (doc/performance.md).
  SceneParameters with_time_integrator(SceneParameters scene, const SectionMesh &mesh);
} // namespace hybrid::scene
