// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>

namespace hybrid::output
{
  /// What the scene makes of every named line of its mesh, one row for lines of the same kind, with
  /// their length: a plane that no parameter names is welded, a sliding surface without a belt
  /// material is an unbonded contact, beyond a belt the friction may be another one. Empty for a
  /// mesh without lines.
  std::string describe_lines(const scene::SectionMesh &mesh, const scene::SceneParameters &scene);
} // namespace hybrid::output
