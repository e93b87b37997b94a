// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * The edges on which a belt's residual cohesion acts, once blocks slide on it as contacts: those
   * of the ground that a belt bonded at the start, and those of blocks that it bonded and that have
   * slid on it ever since. Elsewhere, and where it has opened, there is friction only.
   */
  struct BondedArea
  {
    /// Ends of an edge that adhere; an edge adheres with either.
    static constexpr char first = 1, second = 2, both = 3;

    std::vector<char> edges;    ///< per vertex: of the edge that begins there
    std::vector<char> segments; ///< of the foundation

    /// Allocates nothing after the first time.
    void update(const Model &model, const DdaState &state);

    /// What is bonded of an edge: first, second, both or 0.
    char of(const int body, const int edge) const
    {
      return body == foundation_body ? segments[edge] : edges[edge];
    }
  };
} // namespace hybrid::dda
