// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact.h>
#include <hybrid/dda/geometry.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Contacts that are new take over the load of those that they replace, and no more.
   *
   * A contact @p now that was not there @p before and would begin in overlap is given a rest_gap
   * with which it presses as the nearest contact between the same two bodies that has ended, each
   * of them once, or not at all where none has: a spring that is loaded when it is made is
   * energy from nowhere. Between a block and a surface it is a piece of their overlap
   * (contact_length.h) if there was a contact beside it: then it begins with the overlap and the
   * elastic slip of the nearest one, part of whose length is its own from now on. Both lists are
   * those of the same geometry, sorted by vertex_body, vertex, edge_body, edge.
   */
  void carry_loads(const std::vector<Contact> &before,
                   const Geometry             &geometry,
                   std::vector<Contact>       &now);
} // namespace hybrid::dda
