// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/contact/contact_candidates.h>
#include <hybrid/dda/contact/pair_tolerances.h>
#include <hybrid/dda/geometry/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /// Where a solved step takes all bodies, from the places at its start.
  struct StepMotion
  {
    const std::vector<BlockMotion> &blocks;
    const std::vector<Vec2>        &vertices; ///< their displacements [m]
    const std::vector<Vec2>        &nodes;    ///< displacements of foundation nodes [m]
  };


  /**
   * Whether a step takes a vertex into a body, or through it, with which it had no contact.
   *
   * A contact begins where a vertex is at most the reach in front of an edge when a step begins. A
   * step that moves two bodies towards each other by more may take a vertex from beyond the reach
   * to so deep behind the edge that the next search takes it for lost. So such a step has to be
   * cut: with a relative motion of at most the reach no vertex can be missed.
   *
   * The way of the vertex is straight, seen from the body. It counts if its end is deeper inside
   * than a depth, or the middle of a part of it inside a block: sliding over a row takes a pressed
   * vertex through the sides of its blocks, but no deeper than it is pressed. Vertices that are no
   * convex corners cannot touch. Reach and depth are those of the pair.
   */
  class ContactPassage
  {
  public:
    /// All must outlive this.
    ContactPassage(const Geometry &geometry, const StepMotion &motion, const PairTolerances &pairs);

    /// @param pair without a contact when the step began
    bool takes(const ContactCandidate &pair) const;

  private:
    const Geometry       &geometry;
    const StepMotion     &motion;
    const PairTolerances &pairs;

    /// Of a surface, or convex.
    bool is_corner(const ContactCandidate &pair) const;

    /// Displacement of a vertex, less that of a segment of the foundation, or of a block at its
    /// place [m].
    Vec2 relative_displacement(const ContactCandidate &pair) const;

    bool goes_behind_edge(const ContactCandidate &pair, const Vec2 &from, const Vec2 &to) const;

    bool goes_into_block(const ContactCandidate &pair, const Vec2 &from, const Vec2 &to) const;
  };
} // namespace hybrid::dda
