// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * Refuse a geometry whose mesh would take gmsh, and then the solver, hours: more than two
   * million cells. To be called in a session of gmsh whose curves are meshed and whose surfaces are
   * not.
   *
   * A surface of area A with N edges of mean length h on its boundary is expected to get 2 A/h^2
   * triangles; a mesh that is coarser inside than on the boundary gets fewer.
   *
   * @return that number. @throws InputError about @p file.
   */
  double check_mesh_size(const std::string &file);
} // namespace hybrid::scene
