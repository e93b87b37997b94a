// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/contact/pair_tolerances.h>
#include <hybrid/dda/geometry/outline_frames.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * The contacts that one vertex had in the last step, seen from where it is now.
   *
   * Answers whether a new edge continues an old one, and hands the slip over.
   */
  class ContactHistory
  {
  public:
    /// @param pairs must outlive this
    explicit ContactHistory(const PairTolerances &pairs);

    /// @param contacts of the vertex at @p point, @p n of them; they must outlive the use.
    void set(const Geometry      &geometry,
             const OutlineFrames &frames,
             const Vec2          &point,
             const Contact       *contacts,
             int                  n);

    const Contact &contact(const int number) const
    {
      return *entries[number].contact;
    }

    /// Number of the old contact with this edge, or -1.
    int find(int edge_body, int edge) const;

    /**
     * Number of the old contact whose edge goes on along an edge with outward
     * @p normal on @p edge_body, whose line is at @p gap from the vertex, or -1. Both lines must
     * pass the vertex at the same place: a step of a row is an obstacle, not a seam.
     */
    int find_continued(int edge_body, const Vec2 &normal, double gap) const;

    /// Mark an old contact as used; false if it was already.
    bool take(int number);

    /// Give slip, plastic slip and state of an old contact to @p contact, which is on another edge.
    void hand_over(int number, Contact &contact) const;

  private:
    struct Entry
    {
      const Contact *contact;
      double         gap;      ///< from its edge, now [m]
      double         position; ///< on its edge, now [-]
      double         overhang; ///< [m]
      bool           taken;
    };

    const PairTolerances &pairs;
    const OutlineFrames  *frames = nullptr;
    std::vector<Entry>    entries;
  };
} // namespace hybrid::dda
