// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/contact.h>
#include <hybrid/dda/geometry/geometry.h>

#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /**
   * Loads with which contacts begin that are in overlap when they are found.
   *
   * No energy enters or leaves when one contact takes the place of another, where a contact's
   * edges turn, or where a corner has come in beside all edges and is seen one step later:
   *
   * - A new contact with a surface is a piece of an overlap that was there (contact_length.h) if a
   *   contact pressed beside it. It begins with the overlap and the elastic slip of the nearest
   *   one, part of whose length is its own from now on. One that is longer (a corner that passes a
   *   bend stands for half of its block, where its sole shared the load with all places below)
   *   begins with so much less that it presses as the other did: with all of it, it would press
   *   and store more in the ratio of the lengths.
   * - Any other begins with the largest overlap that pressed between the two bodies, and without
   *   one if nothing did: what two corners have gone into each other within one step stores
   *   nothing. It is not less than what pressed: a contact that begins with nothing can be replaced
   *   again, and again, and sink.
   */
  class ContactLoads
  {
  public:
    /// Length of a contact that is a corner [m].
    using CornerLength = std::function<double(const Contact &)>;

    /// Give the new contacts their loads. Both lists are those of the same geometry, sorted by
    /// vertex_body, vertex, edge_body, edge. Costs a sort where there are such contacts, and then
    /// of each the contacts between its two bodies.
    void carry(const std::vector<Contact> &before,
               const Geometry             &geometry,
               const CornerLength         &corner,
               std::vector<Contact>       &now);

    /// As edges turn against each other their springs get longer or shorter (contact_length.h).
    /// A spring that presses keeps its energy: overlap and elastic slip go with the inverse root
    /// of the length that turning alone has changed. Where that would make a contact act before
    /// bodies touch, the energy of the rest is lost.
    static void
    turn(const Geometry &geometry, const CornerLength &corner, std::vector<Contact> &contacts);

  private:
    /// The lists of a search.
    struct Lists
    {
      const std::vector<Contact> &before, &now;
      const Geometry             &geometry;
      const CornerLength         &corner;

      double length(const std::vector<Contact> &all, const Contact &contact) const;
    };

    using Bodies = std::pair<int, int>; ///< the lower first; all surfaces are foundation_body

    /// A contact that pressed.
    struct Pressing
    {
      Bodies bodies;
      int    number; ///< among the contacts before
      double depth;  ///< by which it pressed [m]

      bool operator<(const Pressing &other) const
      {
        return std::tie(bodies, number) < std::tie(other.bodies, other.number);
      }
    };

    using Range =
      std::pair<std::vector<Pressing>::const_iterator, std::vector<Pressing>::const_iterator>;

    std::vector<Pressing> pressing; ///< sorted

    static Bodies bodies_of(const Contact &contact, const Geometry &geometry);

    void find_pressing(const std::vector<Contact> &before, const Geometry &geometry);

    Range pressing_between(const Bodies &bodies) const;

    /// Begin with the load of the nearest contact that pressed. False if there is none on these
    /// edges.
    static bool begin_as_piece(const Lists &lists, const Range &between, Contact &contact);
  };
} // namespace hybrid::dda
