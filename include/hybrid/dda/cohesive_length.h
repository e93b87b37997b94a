// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/bonded_area.h>
#include <hybrid/dda/contact.h>
#include <hybrid/dda/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Length on which the residual cohesion of a contact acts [m].
   *
   * A corner that touches an edge has no area. Edges that face each other within 3 degrees
   * lie on one another where they overlap (edge to edge; Shi 1988): each of the two
   * corners at the ends of the overlap stands for half of it, and where corners
   * of both bodies are at one end, with contacts of their own, for a quarter. An edge goes on
   * through corners that are none (straight or reflex) and as long as it does not turn by more
   * than those 3 degrees: a block over many segments of a straight base overlaps with all of them.
   * A corner whose two edges both lie on the other body (a gentle ridge) has both lengths.
   *
   * @param contacts all of them, in the order of ContactDetection
   * @param area where cohesion is left, or nullptr: everywhere. An overlap ends where it ends, and
   * no corner is there to bear the other half: that of the contact bears all.
   */
  double cohesive_length(const Geometry             &geometry,
                         const std::vector<Contact> &contacts,
                         const Contact              &contact,
                         const BondedArea           *area = nullptr);
} // namespace hybrid::dda
