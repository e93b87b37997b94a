// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  constexpr double gap = -1e-7; ///< with which the contact presses [m]

  /// A vertex above the middle of a slanting edge, all of it far from the origin.
  struct Scene
  {
    ContactPlaces start;
    Contact       contact{1, 4, 0, 0};
    explicit Scene(const double from_origin)
    {
      const Vec2 first(from_origin, 0.7 * from_origin), edge(2., 0.3);
      const Vec2 along      = edge.normalized();
      start.first           = first;
      start.second          = first + edge;
      start.vertex          = first + 0.4 * edge + gap * Vec2(along.y(), -along.x());
      contact.edge_position = 0.4;
      contact.slip          = 1e-5;
      contact.pressed_gap   = gap;
    }

    ContactFrame after(const ContactPlaces &moved) const
    {
      return ContactFrame(contact, start, ContactFrame(contact, start).along, moved);
    }
  };



  ContactPlaces nowhere()
  {
    return {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  }
} // namespace



TEST(ContactFrame, nothing_changes_where_nothing_moves)
{
  for (const double pressed : {gap, 0.})
    for (const double from_origin : {0., 1e2, 1e6})
      {
        Scene scene(from_origin);
        scene.contact.pressed_gap = pressed;
        const ContactFrame start(scene.contact, scene.start), end = scene.after(nowhere());
        EXPECT_EQ(end.gap, start.gap);
        EXPECT_EQ(end.slip, scene.contact.slip);
        EXPECT_EQ(end.edge_position, scene.contact.edge_position);
        EXPECT_EQ(end.along, start.along);
      }
}



TEST(ContactFrame, gap_that_presses_is_what_was_summed_and_others_are_those_of_the_places)
{
  Scene scene(1e6); // places are rounded by 1e-10 m
  EXPECT_EQ(ContactFrame(scene.contact, scene.start).gap, gap);
  scene.contact.pressed_gap = 0.;
  EXPECT_NE(ContactFrame(scene.contact, scene.start).gap, gap);
  EXPECT_NEAR(ContactFrame(scene.contact, scene.start).gap, gap, 1e-9);
}



TEST(ContactFrame, adds_what_the_displacements_make_of_it)
{
  // The vertex goes 3 mm along the edge and 1 um away from it.
  Scene              scene(1e6);
  const ContactFrame start(scene.contact, scene.start);
  ContactPlaces      moved = nowhere();
  moved.vertex             = 3e-3 * start.along + 1e-6 * start.outward;
  const ContactFrame end   = scene.after(moved);
  EXPECT_NEAR(end.gap, gap + 1e-6, 1e-17);
  EXPECT_NEAR(end.slip, scene.contact.slip + 3e-3, 1e-15);
}



TEST(ContactFrame, is_that_of_the_places_for_any_motion)
{
  // Beside the origin places are exact enough to compare with.
  Scene scene(0.);
  for (int k = 0; k < 20; ++k)
    {
      const double  a           = 0.02 * k;
      ContactPlaces moved       = nowhere();
      moved.vertex              = Vec2(2e-3 * std::sin(k), 1e-3 * std::cos(2. * k));
      moved.first               = Vec2(-1e-3 * k, 3e-4 * k);
      moved.second              = moved.first + Vec2(-0.3 * a, 2. * a); // turns and stretches
      const ContactFrame  frame = scene.after(moved);
      const ContactPlaces end{scene.start.vertex + moved.vertex,
                              scene.start.first + moved.first,
                              scene.start.second + moved.second};
      Contact             by_places = scene.contact;
      by_places.pressed_gap         = 0.;
      const Vec2 edge = end.second - end.first, from_q = end.from_q(scene.contact);
      EXPECT_NEAR(frame.gap, ContactFrame(by_places, end).gap, 1e-15);
      EXPECT_NEAR(frame.slip, scene.contact.slip + from_q.dot(edge.normalized()), 1e-15);
      EXPECT_NEAR(frame.edge_position,
                  (end.vertex - end.first).dot(edge) / edge.squaredNorm(),
                  1e-14);
    }
}



// A contact that presses for 100,000 steps on an edge that turns: the sum stays with the places.
TEST(ContactFrame, sum_does_not_drift)
{
  Scene  scene(100.);
  double largest = 0.;
  for (int k = 0; k < 100000; ++k)
    {
      const double  turn          = 1e-5 * std::cos(1e-3 * k);
      const Vec2    edge          = scene.start.second - scene.start.first;
      ContactPlaces moved         = nowhere();
      moved.first                 = Vec2(1e-4, 2e-5 * std::sin(1e-2 * k));
      moved.second                = moved.first + turn * Vec2(-edge.y(), edge.x());
      const Vec2 at               = scene.contact.edge_position * (moved.second - moved.first);
      moved.vertex                = moved.first + at + 1e-6 * std::cos(0.1 * k) * edge.normalized();
      const ContactFrame frame    = scene.after(moved);
      scene.contact.pressed_gap   = frame.gap;
      scene.contact.slip          = frame.slip;
      scene.contact.edge_position = frame.edge_position;
      scene.start.vertex += moved.vertex;
      scene.start.first += moved.first;
      scene.start.second += moved.second;
      Contact by_places     = scene.contact;
      by_places.pressed_gap = 0.;
      largest = std::max(largest, std::abs(frame.gap - ContactFrame(by_places, scene.start).gap));
    }
  EXPECT_LT(largest, 1e-10); // places are rounded by 7e-15 m in each of them
}
