// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/elastic_settlement.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    /// From the least to the largest.
    struct Range
    {
      double least = std::numeric_limits<double>::infinity(), largest = -least;

      void add(const double x)
      {
        least   = std::min(least, x);
        largest = std::max(largest, x);
      }

      double length() const
      {
        return largest - least;
      }
    };
  } // namespace



  std::vector<double> elastic_settlement(const Model &model)
  {
    const int          n = model.n_mass();
    const Geometry    &g = model.initial;
    std::vector<Range> width(n);
    Range              all, height;
    for (int b = 0; b < n; ++b)
      for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
        {
          width[b].add(g.vertices[v].x());
          all.add(g.vertices[v].x());
          height.add(g.vertices[v].y());
        }
    double widths = 0.;
    for (const Range &of_block : width)
      widths += of_block.length();
    // Columns as wide as a block is on average.
    const int n_columns =
      widths > 0. ? static_cast<int>(std::clamp(all.length() * n / widths, 1., 10. * n)) : 1;
    std::vector<double> column(n_columns, 0.); // largest gamma / G [1/m]
    const auto          columns_of = [&](const int b) {
      const auto at = [&](const double x) {
        const double part = all.length() > 0. ? (x - all.least) / all.length() : 0.;
        return std::min(n_columns - 1, static_cast<int>(part * n_columns));
      };
      return std::make_pair(column.begin() + at(width[b].least),
                            column.begin() + at(width[b].largest) + 1);
    };
    for (int b = 0; b < n; ++b)
      {
        const BlockProperties &p    = model.blocks[b];
        const double           soft = p.weight * model.gravity / (p.area * p.elasticity(2, 2));
        const auto [first, last]    = columns_of(b);
        std::for_each(first, last, [soft](double &most) { most = std::max(most, soft); });
      }
    std::vector<double> settlement(n);
    for (int b = 0; b < n; ++b)
      {
        const auto [first, last] = columns_of(b);
        settlement[b] = *std::max_element(first, last) * height.length() * height.length();
      }
    return settlement;
  }
} // namespace hybrid::dda
