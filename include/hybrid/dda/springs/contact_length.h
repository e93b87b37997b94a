// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/dda/springs/bonded_area.h>

#include <vector>

namespace hybrid::dda
{
  /// Lengths of one contact [m].
  struct ContactLength
  {
    double overlap = 0.; ///< of edges that lie on each other
    double bonded  = 0.; ///< the part of it that a belt bonds still
    double spring  = 0.; ///< on it act the springs, whose stiffness is per area
    double face    = 0.; ///< that of the springs where edges lie on each other
    double corner  = 0.; ///< that of the springs where edges do not lie on each other
    double closeness =
      0.; ///< 1 for edges that lie along each other, 0 from 3 degrees between them on [-]

    /// That of the springs at any closeness [m]; of two blocks of the mass always the corner's.
    double at(const double close) const
    {
      return close * face + (1. - close) * corner;
    }
  };


  /**
   * Lengths for which a contact stands.
   *
   * A corner that touches an edge has no area. Edges that face each other within 3 degrees
   * lie on one another where they overlap (edge to edge; Shi 1988). The vertices of both bodies
   * cut the overlap into pieces, and each contact has half of the pieces beside it; where
   * vertices of both are at one place, each with a contact of its own, they share. So
   * the springs integrate the pressure k_n (-gap) over the overlap by the trapezoidal rule,
   * which is exact for a uniform pressure, whatever the ratio of sizes: the patch test. Places of
   * finite elements of higher degree bear what their shape functions say
   * (Geometry::foundation_shares). An edge goes on through corners that are none (straight or
   * reflex) and as long as it does not turn by more than those 3 degrees, so a place of a surface
   * without a contact of its own cuts nothing. A vertex both of whose edges lie on the other body
   * has both lengths.
   *
   * An overlap that is shorter than @p corner has springs for as much as that, and at most for the
   * block's face; the contacts at its two ends have what it lacks. k_n belongs to layers as thick
   * as a block, and what a block presses on a strip is not softer than what it presses with a
   * corner (a punch on a half plane resists by the logarithm of its width alone; Johnson 1985,
   * section 2.8). Its springs would get longer as it slides on, and give back more than they took.
   *
   * As the edges turn away from each other, up to 3 degrees, the springs of a contact with
   * a surface pass smoothly from their part of the overlap to @p corner (for a place
   * where the surface is straight: to nothing). Contacts of two blocks of the mass always have @p
   * corner.
   *
   * @param contacts all of them, in the order of ContactDetection
   * @param corner length that a corner alone stands for [m]
   * @param area what belts bond still, or nullptr. Where only the bonded part of a block's edge
   * ends no corner bears the other half: the contact bears all.
   */
  ContactLength contact_length(const Geometry             &geometry,
                               const std::vector<Contact> &contacts,
                               const Contact              &contact,
                               double                      corner,
                               const BondedArea           *area = nullptr);
} // namespace hybrid::dda
