// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene
{
  /**
   * Refuse a section that is surely not drawn in metres: larger than 30 km (millimetres), or, where
   * waves run or the ground shakes, smaller than 0.5 m (kilometres). A real slope is between 5 m
   * and 5 km, so a factor of 1000 takes it out of these limits or to what unit_warnings() doubts.
   *
   * @throws InputError with the corners of the section, its size and the size in the likely unit.
   */
  void check_unit(const SectionMesh &mesh, const SceneParameters &scene);

  /// The first part of check_unit(), for a section whose corners are @p low and @p high [m].
  void check_extent(const Vec2 &low, const Vec2 &high);

  /**
   * What makes the unit of the coordinates doubtful, one sentence each: a section larger than 5 km,
   * or smaller than 5 m where there is a bedrock and 0.5 m elsewhere; a block of the mass larger
   * than 100 m. And of the strengths: 50 to 999 Pa with blocks of a metre and more.
   */
  std::vector<std::string> unit_warnings(const SectionMesh &mesh, const SceneParameters &scene);
} // namespace hybrid::scene
