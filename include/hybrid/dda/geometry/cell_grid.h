// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hybrid::dda
{
  /// Axis-parallel box.
  struct Box
  {
    Vec2 lower; ///< [m]
    Vec2 upper; ///< [m]
  };


  /**
   * Which boxes may contain a point: a uniform grid of square cells.
   *
   * Cells are as large as the mean box and live in a hash table, so that one
   * block that has flown far away costs nothing. A box that would cover very
   * many cells (a rock mass among gravel) is kept in a short list which every
   * query sees. Building is O(boxes), a query is O(boxes near the point).
   * The order of the answers depends on the boxes only. Building again with
   * no more boxes than before allocates nothing.
   */
  class CellGrid
  {
  public:
    void build(const std::vector<Box> &boxes);

    /// Append to @p found the numbers of all boxes that contain @p point, each once.
    void find(const Vec2 &point, std::vector<int> &found) const;

    /// Side of a cell [m].
    double cell_size() const
    {
      return size;
    }

  private:
    struct Entry
    {
      std::int64_t ix, iy; ///< cell
      int          box;
    };

    std::int64_t cell_of(double coordinate) const;

    std::size_t bucket_of(std::int64_t ix, std::int64_t iy) const;

    /// Call @p action(ix, iy, box) for every cell of every box that is not large.
    template <class Action>
    void for_each_cell(Action action) const;

    double             size = 1.;
    std::vector<Box>   stored;
    std::vector<int>   large;   ///< boxes that cover too many cells
    std::vector<int>   start;   ///< first entry of each bucket; size a power of two, plus one
    std::vector<int>   cursor;  ///< work space of build()
    std::vector<Entry> entries; ///< sorted by bucket, then box
  };
} // namespace hybrid::dda
