// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <limits>
#include <vector>

namespace hybrid::dda
{
  /// The body number of the bedrock (or rigid foundation) in contacts and joints.
  constexpr int foundation_body = -1;


  /**
   * How the outlines of bedrock that is made of blocks join to its surface.
   *
   * Edges that two blocks of the bedrock share are inside: nothing touches them.
   * The others follow each other from block to block, so that the surface of
   * this bedrock is one outline with corners only where the rock has them. A
   * place of the surface is named by the first vertex of the edge that begins
   * there.
   */
  struct BedrockSurface
  {
    static constexpr int none   = -1; ///< the surface ends: at a prescribed foundation
    static constexpr int inside = -2; ///< not an edge of the surface

    int first_block =
      std::numeric_limits<int>::max(); ///< this block and those after it are bedrock
    std::vector<int> next;     ///< per vertex: the edge after the edge that begins there; empty
                               ///< without such bedrock, and blocks of the mass have their own
    std::vector<int> previous; ///< per vertex: the edge before it
  };


  /**
   * Where all bodies are: the polygons of the blocks in one flat array and the
   * polyline of the foundation. Outlines run counter-clockwise; the foundation lies to the
   * right of its polyline, walked from node 0 upwards (rock below, left end first
   * means the rock is on the right-hand side when x grows).
   */
  struct Geometry
  {
    std::vector<int>  offset;           ///< first vertex of block b is offset[b]; size blocks + 1
    std::vector<int>  block_of;         ///< block of each vertex
    std::vector<Vec2> vertices;         ///< [m]
    std::vector<Vec2> foundation_nodes; ///< [m]; empty without a foundation
    BedrockSurface    bedrock;
    /// Per foundation segment: what its first node bears of a uniform load on it [-]; empty: half.
    std::vector<double> foundation_shares;
    int                 foundation_degree = 1; ///< segments per face of the elements below, 1..8

    int n_blocks() const
    {
      return static_cast<int>(offset.size()) - 1;
    }

    /// The vertex after @p vertex on its block's outline.
    int next(const int vertex) const
    {
      const int b = block_of[vertex];
      return vertex + 1 == offset[b + 1] ? offset[b] : vertex + 1;
    }

    /// The vertex before @p vertex on its block's outline.
    int previous(const int vertex) const
    {
      const int b = block_of[vertex];
      return vertex == offset[b] ? offset[b + 1] - 1 : vertex - 1;
    }
  };
} // namespace hybrid::dda
