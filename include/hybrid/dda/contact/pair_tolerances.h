// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_tolerances.h>
#include <hybrid/dda/geometry/geometry.h>

#include <algorithm>
#include <vector>

namespace hybrid::dda
{
  /**
   * Tolerances of each pair of bodies: those of the smaller one.
   *
   * A quarter of a body's size is the most that contacts with it reach or begin with, so that a
   * small block is not passed unseen, and has no say in how large ones meet elsewhere. Surfaces
   * have no size.
   */
  class PairTolerances
  {
  public:
    /// @param widest of any pair
    explicit PairTolerances(const ContactTolerances &widest)
      : of_surface(widest)
      , narrowest_of_all(widest)
    {}

    /// @param size per block [m]; infinite: as a surface
    void set_sizes(const std::vector<double> &size)
    {
      of_block.assign(size.size(), of_surface);
      for (std::size_t b = 0; b < size.size(); ++b)
        {
          ContactTolerances &mine = of_block[b];
          mine.reach              = std::min(mine.reach, 0.25 * size[b]);
          mine.max_depth          = std::min(mine.max_depth, 0.25 * size[b]);
          narrowest_of_all        = narrower(mine, narrowest_of_all);
        }
    }

    const ContactTolerances &of(const int body, const int other) const
    {
      return narrower(of(body), of(other));
    }

    /// Of any pair with this body: the widest.
    const ContactTolerances &of(const int body) const
    {
      return body == foundation_body || of_block.empty() ? of_surface : of_block[body];
    }

    const ContactTolerances &narrowest() const
    {
      return narrowest_of_all;
    }

    static const ContactTolerances &narrower(const ContactTolerances &a, const ContactTolerances &b)
    {
      return a.search_distance() <= b.search_distance() ? a : b;
    }

  private:
    ContactTolerances              of_surface;
    ContactTolerances              narrowest_of_all;
    std::vector<ContactTolerances> of_block; ///< empty: all as surfaces
  };
} // namespace hybrid::dda
