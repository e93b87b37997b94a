// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid::scene
{
  /**
   * Curves of gmsh's current model, whose curves are meshed, that would make it crash or give up
   * when it meshes the surfaces: of each surface, curves of its boundary and curves within it
   * that cross each other, and curves within it that end on another without a point of that one.
   *
   * @param file of the model, for the message.
   * @throws InputError with the names of the two curves and the place.
   */
  void check_curves(const std::string &file);


  /// The curves that lie within surfaces, in words: "bedding_1 (curve 5) within surface 1"; empty
  /// if there are none. gmsh keeps none of them when it recombines a surface.
  std::string curves_within_surfaces();
} // namespace hybrid::scene
