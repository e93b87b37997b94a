// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/cell_grid.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Ways along a line of straight pieces that does not move.
   *
   * An open line goes on straight beyond both of its ends. Pieces lie in a tree of boxes, so that
   * the nearest one is found without a look at all of them.
   */
  class SurfaceLine
  {
  public:
    /// @param points at least two different ones; one may follow itself  @param closed the last is
    /// followed by the first
    SurfaceLine(const std::vector<Vec2> &points, bool closed);

    /// Way along the line from its first point to the point of it that is nearest to @p place [m];
    /// negative before an open line begins.
    double way_to(const Vec2 &place) const;

    /// The point of the line so far along it [m].
    Vec2 point_at(double way) const;

    /// From one way to another [m], negative against the line; round a closed line the shorter of
    /// both.
    double between(double from, double to) const;

  private:
    struct Nearest
    {
      double squared; ///< distance [m2]
      double way;     ///< [m]
    };

    std::vector<Vec2>
      points; ///< none follows itself; of a closed line the first is at the end, too
    std::vector<double> ways;  ///< to each point [m]
    std::vector<Box>    boxes; ///< of piece 0, and so on: a binary tree, the root is the first
    bool                closed;

    int n_pieces() const
    {
      return static_cast<int>(points.size()) - 1;
    }

    Box build(std::size_t node, int begin, int end);

    void try_piece(int piece, const Vec2 &place, Nearest &nearest) const;

    void search(std::size_t node, int begin, int end, const Vec2 &place, Nearest &nearest) const;
  };
} // namespace hybrid::dda
