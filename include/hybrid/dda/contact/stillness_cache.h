// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact_candidates.h>
#include <hybrid/dda/contact/rest_state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Finds the vertices that need no contact search, as nothing near them moves.
   *
   * A block or a foundation node rests while none of its points is farther than a
   * tolerance from where it was when it last moved. A vertex whose block and
   * all bodies near it rest is settled once a search has changed none of its
   * contacts; it keeps them until one of these bodies moves.
   */
  class StillnessCache
  {
  public:
    /// Compare all places with @p rest, and note there those that have moved. @param tolerance [m]
    /// below which two places are the same to the search.
    void look(const Geometry &geometry, RestState &rest, double tolerance);

    /// True if the vertex body and the edge body, or the segment of the foundation, rest.
    bool rests(const ContactCandidate &pair) const;

    /// Mark of a vertex of a block or of the foundation.
    static char &settled(RestState &rest, const int body, const int vertex)
    {
      return (body == foundation_body ? rest.settled_nodes : rest.settled_vertices)[vertex];
    }

  private:
    std::vector<char> is_resting;      ///< per block
    std::vector<char> is_resting_node; ///< per foundation node
  };
} // namespace hybrid::dda
