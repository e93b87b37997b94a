// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/dda/joint/contact_state.h>

namespace hybrid::dda
{
  /**
   * A vertex of one body in front of an edge of another.
   *
   * The gap is the distance of the vertex from the edge's line along the
   * edge's outward normal (positive when open). Slip is the displacement of
   * the vertex along the edge's direction (from first to second end), summed
   * over the steps, also across collinear edges; with each it begins anew
   * where friction holds the contact.
   */
  struct Contact
  {
    int vertex_body; ///< block of the vertex, or foundation_body
    int vertex;      ///< index in Geometry::vertices, or foundation node
    int edge_body;   ///< block of the edge, or foundation_body
    int edge; ///< index of the edge's first end in Geometry::vertices, or first foundation node of
              ///< the segment

    double edge_position = 0.; ///< projection of the vertex on the edge when last accepted, 0..1
                               ///< from first to second end [-]
    double slip = 0.; ///< at edge_position, from where friction held it when last accepted [m]
    double plastic_slip =
      0.; ///< part of the slip that friction has taken; shear force = -k_s (slip - plastic_slip)
    ContactState state = ContactState::open; ///< when last accepted
    double       stress_free_gap =
      0.; ///< gap above which it carries nothing [m]: the overlap that neighbours of the mesh
          ///< had when they were first active, and a little more, or that with which it
          ///< was found (contact_load.h), less that of a released joint; > 0 only where that had an
          ///< initial stress; 0 once they part
    double pressed_gap = 0.; ///< gap when last accepted, if it pressed then, < 0 [m]: summed over
                             ///< the steps, see ContactFrame; 0: the gap is that of the places
    double closeness = -1.;  ///< with which its load was last set (ContactLength) [-]; < 0: not yet
  };
} // namespace hybrid::dda
