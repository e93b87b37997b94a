// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * Before gmsh opens @p file. gmsh leaves out the last line of a geometry, without a word, where
   * no line break ends it.
   * @throws InputError if there is no such file, if its name ends neither in .geo nor in .msh, or
   * if a geometry does not end with a line break.
   */
  void check_mesh_file(const std::string &file);
} // namespace hybrid::scene
