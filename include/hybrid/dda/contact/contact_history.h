// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/bonded_outline.h>
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
             const BondedOutline &outline,
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
     * Number of the old contact whose edge goes on along an edge of @p edge_body, whose line is at
     * @p gap from the vertex, or -1. Both lines must pass the vertex at the same place: a step of a
     * row is an obstacle, not a seam, unless it is that of a bond.
     */
    int find_continued(int edge_body, int edge, double gap) const;

    /**
     * True if the vertex was on an edge of another body whose line runs over this corner of
     * @p body: both edges of the corner fall away from it. Such a tip stops nothing that slides on
     * that line: of a row of triangles every other one has but a tip there.
     * @param way from the vertex to the corner [m]
     */
    bool runs_over_tip(int body, int corner, const Vec2 &way) const;

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
    const Geometry       *geometry = nullptr;
    const OutlineFrames  *frames   = nullptr;
    const BondedOutline  *outline  = nullptr;
    std::vector<Entry>    entries;
  };
} // namespace hybrid::dda
