// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// Points of a scene without monitors that are watched for the error of its step and mesh alone.
  struct WatchedPoints
  {
    static constexpr int most_of_mass = 8, most_of_bedrock = 4, most_of_bedrock_alone = 8;
    static constexpr int most = most_of_mass + most_of_bedrock + 1;

    /// Of the largest motion: nobody asks for the error of what hardly moves [-].
    static constexpr double least_motion = 0.1;

    std::vector<scene::Monitor>
        points;         ///< named by where they are, "x_12.5_y_-3", as monitors may be
    int base       = 0; ///< of them, the last: "base"; 0: there is none
    int of_mass    = 0; ///< the first ones
    int of_bedrock = 0; ///< those that follow

    /// What is watched: "8 blocks and 4 points of the bedrock".
    std::string text() const;
  };


  /**
   * The centroids of up to 8 blocks of the mass and of up to 4 cells of the bedrock at the ground
   * or the sliding surface (8 without a mass), and what displacements are relative to: the middle
   * of the base line, or a point of the rigid base.
   *
   * Each is the farthest from those before it, the first the one nearest to the middle of all: so
   * the ends of the mass are watched, and as much of what lies between as there are points.
   *
   * @param blocks nullptr: there are none. @param bedrock_moves the cells of @p mesh are bedrock
   * that moves in itself, on finite elements or as blocks
   */
  WatchedPoints
  watched_points(const scene::SectionMesh &mesh, const dda::Model *blocks, bool bedrock_moves);
} // namespace hybrid::output
