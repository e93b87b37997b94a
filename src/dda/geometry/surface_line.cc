// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/surface_line.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    double squared_distance(const Box &box, const Vec2 &place)
    {
      return (place - place.cwiseMax(box.lower).cwiseMin(box.upper)).squaredNorm();
    }



    std::vector<Vec2> without_repeated(std::vector<Vec2> points)
    {
      points.erase(std::unique(points.begin(), points.end()), points.end());
      return points;
    }
  } // namespace



  SurfaceLine::SurfaceLine(const std::vector<Vec2> &given, const bool is_closed)
    : points(without_repeated(given))
    , closed(is_closed)
  {
    if (closed)
      points.push_back(Vec2(points.front()));
    ways.push_back(0.);
    for (int k = 0; k < n_pieces(); ++k)
      ways.push_back(ways.back() + (points[k + 1] - points[k]).norm());
    std::size_t size = 1;
    while (size < 2 * points.size())
      size *= 2;
    boxes.resize(2 * size);
    build(0, 0, n_pieces());
  }



  Box SurfaceLine::build(const std::size_t node, const int begin, const int end)
  {
    const int middle = (begin + end) / 2;
    if (end - begin == 1)
      boxes[node] = {points[begin].cwiseMin(points[end]), points[begin].cwiseMax(points[end])};
    else
      {
        const Box a = build(2 * node + 1, begin, middle), b = build(2 * node + 2, middle, end);
        boxes[node] = {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
      }
    return boxes[node];
  }



  void SurfaceLine::try_piece(const int piece, const Vec2 &place, Nearest &nearest) const
  {
    const Vec2   along = points[piece + 1] - points[piece];
    const double width = ways[piece + 1] - ways[piece];
    const bool   first = !closed && piece == 0, last = !closed && piece + 1 == n_pieces();
    const double way     = std::clamp((place - points[piece]).dot(along) / width,
                                  first ? -std::numeric_limits<double>::infinity() : 0.,
                                  last ? std::numeric_limits<double>::infinity() : width);
    const double squared = (place - points[piece] - way / width * along).squaredNorm();
    if (squared < nearest.squared)
      nearest = {squared, ways[piece] + way};
  }



  void SurfaceLine::search(const std::size_t node,
                           const int         begin,
                           const int         end,
                           const Vec2       &place,
                           Nearest          &nearest) const
  {
    if (squared_distance(boxes[node], place) >= nearest.squared)
      return;
    if (end - begin == 1)
      return try_piece(begin, place, nearest);
    const int         middle = (begin + end) / 2;
    const std::size_t left = 2 * node + 1, right = left + 1;
    const bool        left_first =
      squared_distance(boxes[left], place) <= squared_distance(boxes[right], place);
    if (left_first)
      search(left, begin, middle, place, nearest);
    search(right, middle, end, place, nearest);
    if (!left_first)
      search(left, begin, middle, place, nearest);
  }



  double SurfaceLine::way_to(const Vec2 &place) const
  {
    Nearest nearest{std::numeric_limits<double>::infinity(), 0.};
    try_piece(0, place, nearest); // boxes end where the line does
    try_piece(n_pieces() - 1, place, nearest);
    search(0, 0, n_pieces(), place, nearest);
    return nearest.way;
  }



  Vec2 SurfaceLine::point_at(const double way) const
  {
    const auto   end   = std::upper_bound(ways.begin(), ways.end(), way) - ways.begin();
    const int    piece = std::clamp(static_cast<int>(end) - 1, 0, n_pieces() - 1);
    const double width = ways[piece + 1] - ways[piece];
    return points[piece] + (way - ways[piece]) / width * (points[piece + 1] - points[piece]);
  }



  double SurfaceLine::between(const double from, const double to) const
  {
    const double way = to - from, round = ways.back();
    return closed && std::abs(way) > 0.5 * round ? way - std::copysign(round, way) : way;
  }
} // namespace hybrid::dda
