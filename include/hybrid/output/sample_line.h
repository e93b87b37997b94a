// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/probes.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// A line of Monitors/Lines as the points at which it is sampled.
  struct SampleLine
  {
    std::string       name;
    std::vector<Vec2> points;   ///< initial [m]; a line of the mesh runs to +x (vertical: up)
    std::vector<Vec2> tangents; ///< unit vectors: of the edge that follows, at the end of the last
    std::vector<double> distance; ///< along the line from its first point, over its gaps too [m]
    bool                is_of_mesh = false;
    bool                has_sides  = false; ///< a plane that its two sides may leave
  };

  /// The probes of one side of a line, in the order of its points.
  struct LineSide
  {
    std::string      name; ///< above, below; on: the line has one motion
    std::vector<int> probes;
  };

  /**
   * All lines of the scene. Two sides have the bedding planes of Bedding planes/Names and the
   * sliding surface (above: the mass). Above is to the left of the tangent, as for the slip of
   * bedding planes.
   * @throws InputError if the mesh has no such line.
   */
  std::vector<SampleLine> sample_lines(const scene::SceneParameters &scene,
                                       const scene::SectionMesh     &mesh);

  /// Make the probes of a line. Where a side has nothing (the tip of a plane, a sliding surface
  /// without blocks) it is the other's. @throws InputError for a point that lies in nothing.
  std::vector<LineSide> add_line_probes(const SampleLine &line, Probes &probes);
} // namespace hybrid::output
