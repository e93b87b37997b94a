// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact.h>
#include <hybrid/dda/geometry.h>

#include <functional>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /**
   * Loads of contacts between blocks and a surface that take the place of others.
   *
   * A contact that is there now but was not before, and begins in overlap, is a piece of an overlap
   * that was there (contact_length.h) if a contact pressed beside it: it begins with the overlap
   * and the elastic slip of the nearest one, part of whose length is its own from now on, so that
   * no energy enters or leaves when a sole passes a place of the surface. One that is longer (a
   * corner that passes a bend stands for half of its block, where its sole shared the load with all
   * places below) begins with so much less that it presses as the other did: with all of it, it
   * would press and store more in the ratio of the lengths. Other new contacts are left as they
   * lie: one that would carry nothing until it is deeper could be replaced again, and again, and
   * sink.
   */
  class ContactLoads
  {
  public:
    /// Length of a contact that is a corner [m].
    using CornerLength = std::function<double(const Contact &)>;

    /// Give the new contacts their loads. Both lists are those of the same geometry, sorted by
    /// vertex_body, vertex, edge_body, edge. Costs a sort where there are such contacts, and then
    /// of each the contacts of its block.
    void carry(const std::vector<Contact> &before,
               const Geometry             &geometry,
               const CornerLength         &corner,
               std::vector<Contact>       &now);

  private:
    /// The lists of a search.
    struct Lists
    {
      const std::vector<Contact> &before, &now;
      const Geometry             &geometry;
      const CornerLength         &corner;

      double length(const std::vector<Contact> &all, const Contact &contact) const;
    };

    /// Contacts before with a surface: block of the mass, number.
    std::vector<std::pair<int, int>> by_block;

    void sort_by_block(const std::vector<Contact> &before, const Geometry &geometry);

    /// Begin with the load of the nearest contact before; without one on these edges the contact is
    /// left as it lies.
    void begin_as_piece(const Lists &lists, Contact &contact) const;
  };
} // namespace hybrid::dda
