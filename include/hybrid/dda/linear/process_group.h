// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hybrid::dda
{
  /**
   * Processes that compute the blocks of a scene together. Each knows the whole problem and its
   * whole state, takes the same decisions, and does a part of the work; what the others have done
   * it gets by these calls, which all make in the same order. MPI is behind it (Partners); this
   * module does not know it.
   */
  class ProcessGroup
  {
  public:
    virtual ~ProcessGroup() = default;

    /// How many there are.
    virtual int count() const = 0;

    /// The number of this one, from 0.
    virtual int rank() const = 0;

    /// Whether it is true on all of them.
    virtual bool all(bool mine) const = 0;

    /// Part p of @p values, from begin[p] to begin[p + 1], is what process p has; afterwards all
    /// have all parts.
    virtual void gather(std::vector<double>            &values,
                        const std::vector<std::size_t> &begin) const = 0;

    /// What process @p from has of @p n values, all have afterwards.
    virtual void spread(int from, double *values, std::size_t n) const = 0;
  };
} // namespace hybrid::dda
