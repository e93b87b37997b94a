// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact.h>
#include <hybrid/dda/geometry.h>

#include <functional>
#include <vector>

namespace hybrid::dda
{
  /**
   * A contact between a block and a surface that is @p now but was not there @p before, and begins
   * in overlap, is a piece of an overlap that was there (contact_length.h) if a contact pressed
   * beside it: it begins with the overlap and the elastic slip of the nearest one, part of whose
   * length is its own from now on, so that no energy enters or leaves when a sole passes a place of
   * the surface. One that is longer (a corner that passes a bend stands for half of its block,
   * where its sole shared the load with all places below) begins with so much less that it presses
   * as the other did: with all of it, it would press and store more in the ratio of the lengths.
   * Other new contacts are left as they lie: one that would carry nothing until it is deeper could
   * be replaced again, and again, and sink. Both lists are those of the same geometry, sorted by
   * vertex_body, vertex, edge_body, edge.
   *
   * @param corner length of a contact that is a corner [m]
   */
  void carry_loads(const std::vector<Contact>                   &before,
                   const Geometry                               &geometry,
                   const std::function<double(const Contact &)> &corner,
                   std::vector<Contact>                         &now);
} // namespace hybrid::dda
