// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/water.h>

#include <optional>

namespace hybrid::dda
{
  /// A straight piece of the water's surface.
  struct WaterPiece
  {
    static constexpr int of_level = -1;

    double left, right; ///< where it begins and ends [m]
    Vec2   point;       ///< on its line [m]
    double slope;       ///< dh/dx [-]
    int    number;      ///< of the segment of the phreatic line, or of_level

    /// h [m]
    double height(const double x) const
    {
      return point.y() + slope * (x - point.x());
    }
  };


  /// Pieces of the water's surface, the higher one of level and phreatic line, from left to right.
  class WaterPieces
  {
  public:
    /// Those above x from @p first to @p last [m], at least one.
    WaterPieces(const Water &water, double first, double last);

    /// The next one, or none.
    std::optional<WaterPiece> next();

  private:
    const std::vector<Vec2>  *line; ///< nullptr: the level alone
    double                    level;
    double                    last;
    std::size_t               segment   = 0; ///< the next one ends at this point of the line
    bool                      is_at_end = false;
    std::optional<WaterPiece> waiting; ///< second part of a segment that crosses the level

    /// A segment of the line, or the first of its two parts.
    WaterPiece higher(const WaterPiece &segment_of_line);

    /// Ends the pieces if this one reaches the last place.
    WaterPiece hand_out(const WaterPiece &piece);
  };
} // namespace hybrid::dda
