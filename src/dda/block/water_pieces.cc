// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/water_pieces.h>

namespace hybrid::dda
{
  namespace
  {
    constexpr double far_away = 1e300;

    WaterPiece level_piece(const double left, const double right, const double level)
    {
      return {left, right, Vec2(0., level), 0., WaterPiece::of_level};
    }



    /// Segment of @p line that ends at its point @p k.
    WaterPiece line_piece(const std::vector<Vec2> &line, const std::size_t k)
    {
      const int number = static_cast<int>(k);
      if (k == 0)
        return {-far_away, line.front().x(), line.front(), 0., number};
      if (k == line.size())
        return {line.back().x(), far_away, line.back(), 0., number};
      const Vec2 along = line[k] - line[k - 1];
      return {line[k - 1].x(), line[k].x(), line[k - 1], along.y() / along.x(), number};
    }
  } // namespace



  WaterPieces::WaterPieces(const Water &water, const double first, const double last_place)
    : line(water.line == nullptr ? nullptr : &water.line->points)
    , level(water.level)
    , last(last_place)
  {
    while (line != nullptr && segment < line->size() && (*line)[segment].x() <= first)
      ++segment;
  }



  std::optional<WaterPiece> WaterPieces::next()
  {
    if (is_at_end)
      return {};
    if (line == nullptr)
      return hand_out(level_piece(-far_away, far_away, level));
    if (waiting)
      {
        const WaterPiece piece = *waiting;
        waiting.reset();
        return hand_out(piece);
      }
    const WaterPiece piece = line_piece(*line, segment);
    ++segment;
    return hand_out(higher(piece));
  }



  WaterPiece WaterPieces::higher(const WaterPiece &piece)
  {
    const double at_left  = piece.slope == 0. ? piece.point.y() : piece.height(piece.left);
    const double at_right = piece.slope == 0. ? piece.point.y() : piece.height(piece.right);
    if (at_left >= level && at_right >= level)
      return piece;
    if (at_left <= level && at_right <= level)
      return level_piece(piece.left, piece.right, level);
    const double crossing = piece.point.x() + (level - piece.point.y()) / piece.slope;
    WaterPiece   above = piece, below = level_piece(piece.left, piece.right, level);
    const bool   falls  = piece.slope < 0.;
    WaterPiece  &first  = falls ? above : below;
    WaterPiece  &second = falls ? below : above;
    first.right         = crossing;
    second.left         = crossing;
    waiting             = second;
    return first;
  }



  WaterPiece WaterPieces::hand_out(const WaterPiece &piece)
  {
    is_at_end = piece.right >= last;
    return piece;
  }
} // namespace hybrid::dda
