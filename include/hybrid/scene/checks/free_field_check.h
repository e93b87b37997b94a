// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Where the ground beside a free-field side is higher or lower than the column of that side, one
   * sentence each. The column is as high as the line left or right, and stands for level ground:
   * blocks on top of the bedrock at the side, or a slope that begins there, are not in it, and what
   * it sends in is another motion than the model has.
   *
   * At the side itself every difference counts (a thousandth of the column's height), within a
   * quarter of the column's height from it one of more than a twentieth.
   *
   * And where there are dashpots instead, though a motion comes in: what the ground beside the
   * model would bring in is missing, and they drain what is there. (Level ground 50 m high has 0.41
   * of the outcrop's motion between sides 120 m apart, 1.11 with 400 m, 1.00 with 1200 m.)
   *
   * And where sides are held along the motion that comes in; where planes that slip or give way
   * reach dashpots or a column that do neither: viscous sides, planes that meet each other at a
   * side (level ground that should slip by 65.6 mm slips by 12.6 in a box 20 m wide, 21.5 with
   * 100 m, 34.9 with 400 m); and where planes meet the column at an angle, whose joint there is
   * that of level ground.
   */
  std::vector<std::string> free_field_warnings(const SectionMesh     &mesh,
                                               const SceneParameters &scene);
} // namespace hybrid::scene
