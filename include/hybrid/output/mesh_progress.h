// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/heartbeat.h>
#include <hybrid/output/log.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <memory>

namespace hybrid::output
{
  /// scene::read_section_mesh(); before a mesh that takes more than a few seconds it is told how
  /// large it will be at most, and meanwhile for how long gmsh has been at it.
  scene::SectionMesh read_section_mesh(const scene::MeshParameters &parameters, Log &log);


  /// The same for what is made of a large mesh, as long as the returned object lives; none for a
  /// small mesh.
  std::unique_ptr<Heartbeat> tell_of_preparation(const scene::SectionMesh &mesh, Log &log);
} // namespace hybrid::output
