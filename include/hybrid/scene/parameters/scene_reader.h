// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/scene_parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Read a scene.
   *
   * @param file parameter file in deal.II's syntax. Files that it names resolve against the
   *   file that names them, and must exist.
   * @param overrides "Section/Name=value" each; the later of two holds. File names in them resolve
   *   against the working directory.
   * @throws InputError with file and line for everything that is unknown, set twice, out of
   *   range, missing or contradictory.
   */
  SceneParameters read_scene(const std::string              &file,
                             const std::vector<std::string> &overrides = {});

  /**
   * Write a valid parameter file with every parameter; comments say default, unit, range and
   * help. Two example materials stand for the user's own.
   */
  void print_all_parameters(std::ostream &out);
} // namespace hybrid::scene
