// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/cell_grid.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    // A box over more cells than this is "large".
    constexpr std::int64_t many_cells = 64;

    bool box_contains(const Box &box, const Vec2 &point)
    {
      return box.lower.x() <= point.x() && point.x() <= box.upper.x() && //
             box.lower.y() <= point.y() && point.y() <= box.upper.y();
    }
  } // namespace


  std::int64_t CellGrid::cell_of(const double coordinate) const
  {
    // Clamped, so that a diverged coordinate (or NaN) is no undefined behaviour.
    constexpr double limit = 1e9;
    const double     cell  = std::floor(coordinate / size);
    return static_cast<std::int64_t>(cell > -limit ? std::min(cell, limit) : -limit);
  }



  std::size_t CellGrid::bucket_of(const std::int64_t ix, const std::int64_t iy) const
  {
    const std::uint64_t hash = static_cast<std::uint64_t>(ix) * 0x9E3779B97F4A7C15ull ^
                               static_cast<std::uint64_t>(iy) * 0xC2B2AE3D27D4EB4Full;
    return static_cast<std::size_t>((hash ^ (hash >> 29)) & (start.size() - 2));
  }



  template <class Action>
  void CellGrid::for_each_cell(Action action) const
  {
    for (int b = 0; b < static_cast<int>(stored.size()); ++b)
      {
        const std::int64_t x0 = cell_of(stored[b].lower.x()), x1 = cell_of(stored[b].upper.x());
        const std::int64_t y0 = cell_of(stored[b].lower.y()), y1 = cell_of(stored[b].upper.y());
        if ((x1 - x0 + 1) * (y1 - y0 + 1) > many_cells)
          continue;
        for (std::int64_t iy = y0; iy <= y1; ++iy)
          for (std::int64_t ix = x0; ix <= x1; ++ix)
            action(ix, iy, b);
      }
  }



  void CellGrid::build(const std::vector<Box> &boxes)
  {
    stored.assign(boxes.begin(), boxes.end());

    double mean = 0.;
    for (const Box &box : stored)
      {
        const double side = (box.upper - box.lower).maxCoeff();
        mean += std::isfinite(side) ? side : 0.;
      }
    size = stored.empty() || mean == 0. ? 1. : mean / stored.size();

    large.clear();
    for (int b = 0; b < static_cast<int>(stored.size()); ++b)
      {
        const std::int64_t nx = cell_of(stored[b].upper.x()) - cell_of(stored[b].lower.x()) + 1;
        const std::int64_t ny = cell_of(stored[b].upper.y()) - cell_of(stored[b].lower.y()) + 1;
        if (nx * ny > many_cells)
          large.push_back(b);
      }

    std::size_t n_entries = 0;
    for_each_cell([&](std::int64_t, std::int64_t, int) { ++n_entries; });
    std::size_t n_buckets = 1;
    while (n_buckets < n_entries)
      n_buckets *= 2;

    // counting sort of the entries by bucket; start.size() is needed by bucket_of()
    start.assign(n_buckets + 1, 0);
    for_each_cell([&](std::int64_t ix, std::int64_t iy, int) { ++start[bucket_of(ix, iy) + 1]; });
    for (std::size_t i = 0; i < n_buckets; ++i)
      start[i + 1] += start[i];
    cursor.assign(start.begin(), start.end());
    entries.resize(n_entries);
    for_each_cell([&](std::int64_t ix, std::int64_t iy, int b) {
      entries[cursor[bucket_of(ix, iy)]++] = {ix, iy, b};
    });
  }



  void CellGrid::find(const Vec2 &point, std::vector<int> &found) const
  {
    for (const int b : large)
      if (box_contains(stored[b], point))
        found.push_back(b);
    if (entries.empty())
      return;

    const std::int64_t ix = cell_of(point.x()), iy = cell_of(point.y());
    const std::size_t  bucket = bucket_of(ix, iy);
    for (int i = start[bucket]; i < start[bucket + 1]; ++i)
      if (entries[i].ix == ix && entries[i].iy == iy && box_contains(stored[entries[i].box], point))
        found.push_back(entries[i].box);
  }
} // namespace hybrid::dda
