// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
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

    /// Of @p n things of so many bytes each process has its own_share(); afterwards all have all.
    virtual void gather_shares(void *things, std::size_t n, std::size_t bytes) const = 0;

    /// What process @p from has of @p n values, all have afterwards.
    virtual void spread(int from, double *values, std::size_t n) const = 0;

    /// The first of @p n things that process @p p has, where each has as many as the others.
    std::size_t share_begin(const std::size_t n, const int p) const
    {
      return n * p / count();
    }
  };


  /// The first of @p n things that this process has, and one after its last. All of them if it is
  /// alone, without a @p group.
  inline std::pair<std::size_t, std::size_t> own_share(const std::size_t   n,
                                                       const ProcessGroup *group)
  {
    if (group == nullptr)
      return {0, n};
    return {group->share_begin(n, group->rank()), group->share_begin(n, group->rank() + 1)};
  }
} // namespace hybrid::dda
