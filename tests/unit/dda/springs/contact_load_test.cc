// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <hybrid/dda/springs/contact_length.h>
#include <hybrid/dda/springs/contact_load.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;

  /// A square whose lower left corner, vertex 0, is 0.1 m below two segments of a foundation.
  Geometry square_in_the_ground()
  {
    Geometry g;
    g.offset           = {0, 4};
    g.block_of         = {0, 0, 0, 0};
    g.vertices         = {{0.5, -0.1}, {1.5, -0.1}, {1.5, 0.9}, {0.5, 0.9}};
    g.foundation_nodes = {{0., 0.}, {1., 0.}, {2., 0.}};
    return g;
  }

  /// A corner stands for half of the square.
  double corner(const Contact &)
  {
    return 0.5;
  }
} // namespace



TEST(ContactLoad, what_is_new_where_nothing_pressed_begins_without_load)
{
  std::vector<Contact> before = {{0, 1, foundation_body, 1, 0.5}};
  std::vector<Contact> now    = {{0, 0, foundation_body, 0, 0.5}};
  before[0].stress_free_gap   = -0.1; // it only touched
  ContactLoads().carry(before, square_in_the_ground(), corner, now);
  EXPECT_NEAR(now[0].stress_free_gap, -0.1, 1e-15);
}



TEST(ContactLoad, what_is_new_in_front_of_an_edge_is_open)
{
  Geometry g               = square_in_the_ground();
  g.vertices[0].y()        = 0.1;
  std::vector<Contact> now = {{0, 0, foundation_body, 0, 0.5}};
  ContactLoads().carry({}, g, corner, now);
  EXPECT_EQ(now[0].stress_free_gap, 0.);
}



TEST(ContactLoad, two_blocks_press_on_as_they_pressed)
{
  Geometry g;
  g.offset                    = {0, 3, 6, 9};
  g.block_of                  = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  g.vertices                  = {{0., 0.},
                                 {1., 0.},
                                 {0., 1.},
                                 {0.2, -1.},
                                 {0.5, 0.1},
                                 {0.1, 0.2},
                                 {0.2, -1.},
                                 {0.6, 0.1},
                                 {0.1, 0.2}};
  std::vector<Contact> before = {{1, 4, 0, 0, 0.5}};
  before[0].stress_free_gap   = -0.07; // pressed by 0.03 m
  std::vector<Contact> now    = {{1, 5, 0, 0, 0.1}, {2, 7, 0, 0, 0.6}};
  ContactLoads().carry(before, g, corner, now);
  EXPECT_NEAR(now[0].stress_free_gap, -0.17, 1e-15) << "0.2 m deep";
  EXPECT_NEAR(now[1].stress_free_gap, -0.1, 1e-15) << "another block, 0.1 m deep";
}



TEST(ContactLoad, what_was_there_stays_as_it_is)
{
  std::vector<Contact> now = {{0, 0, foundation_body, 0, 0.5}};
  ContactLoads().carry(now, square_in_the_ground(), corner, now);
  EXPECT_EQ(now[0].stress_free_gap, 0.);
}



TEST(ContactLoad, what_goes_on_along_another_edge_keeps_its_load)
{
  std::vector<Contact> before = {{0, 0, foundation_body, 1, -0.5}};
  before[0].stress_free_gap   = -0.07; // pressed by 0.03 m
  std::vector<Contact> now    = {{0, 0, foundation_body, 0, 0.5}, {0, 1, foundation_body, 1, 0.5}};
  ContactLoads().carry(before, square_in_the_ground(), corner, now);
  EXPECT_NEAR(now[0].stress_free_gap, -0.07, 1e-15);
  EXPECT_NEAR(now[1].stress_free_gap, -0.07, 1e-15) << "a metre away: what pressed between the two";
}



TEST(ContactLoad, no_deeper_than_it_is)
{
  std::vector<Contact> before = {{0, 0, foundation_body, 1, -0.5}};
  Geometry             g      = square_in_the_ground();
  g.foundation_nodes[0].y()   = -0.05; // the new edge lies lower
  std::vector<Contact> now    = {{0, 0, foundation_body, 0, 0.5}};
  ContactLoads().carry(before, g, corner, now);
  EXPECT_EQ(now[0].stress_free_gap, 0.);
}



TEST(ContactLoad, place_that_enters_a_sole_takes_that_of_the_corner_which_passes_it)
{
  Geometry             g      = square_in_the_ground();
  std::vector<Contact> before = {{0, 0, foundation_body, 0, 0.5}, {0, 1, foundation_body, 1, 0.45}};
  before[1].stress_free_gap   = -0.07; // pressed by 0.03 m
  before[1].slip              = 0.5;
  before[1].plastic_slip      = 0.498; // stretched by 2 mm to the right
  g.foundation_nodes.insert(g.foundation_nodes.begin() + 2, Vec2(1.45, 0.));
  std::vector<Contact> now = {{foundation_body, 2, 0, 0, 0.95}, before[0], before[1]};
  ContactLoads().carry(before, g, corner, now);
  EXPECT_NEAR(now[0].stress_free_gap, -0.07, 1e-12);
  EXPECT_NEAR(now[0].slip - now[0].plastic_slip, -0.002, 1e-12) << "of the base, to the left";
}



// Its sole bore a tenth of the load there; on the other side of the bend it is a corner, and stands
// for half of the square.
TEST(ContactLoad, corner_that_passes_a_bend_presses_as_it_did)
{
  Geometry g         = square_in_the_ground();
  g.foundation_nodes = {{0., 0.05}, {0.5, 0.}, {0.7, 0.}, {2., 0.}}; // a bend of 5.7 degrees
  g.vertices[0].x() = g.vertices[3].x() = 0.4999;
  std::vector<Contact> before = {{foundation_body, 2, 0, 0, 0.2}, {0, 0, foundation_body, 1, 0.}};
  before[1].stress_free_gap   = -0.07; // pressed by 0.03 m over 0.1 m
  before[1].slip              = 0.002; // stretched by 2 mm
  std::vector<Contact> now    = {before[0], {0, 0, foundation_body, 0, 1.}};
  ContactLoads().carry(before, g, corner, now);
  EXPECT_NEAR(now[1].stress_free_gap + 0.1 * std::cos(std::atan(0.1)), 0.03 / 5., 2e-4);
  EXPECT_NEAR(now[1].slip - now[1].plastic_slip, 0.002 / 5., 2e-5);
}



TEST(ContactLoad, a_contact_keeps_its_energy_as_its_edges_turn)
{
  // the same square, turned about its lower left corner by 1, 2 and 1 degrees
  const auto turned = [](const double degrees) {
    Geometry        g = square_in_the_ground();
    const double    a = degrees * 3.14159265358979323846 / 180.;
    Eigen::Matrix2d rotation;
    rotation << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
    const Vec2 pivot = g.vertices[0];
    for (Vec2 &v : g.vertices)
      v = pivot + rotation * (v - pivot);
    return g;
  };
  const auto length = [](const Geometry &g, const std::vector<Contact> &contacts) {
    return contact_length(g, contacts, contacts[0], 2., nullptr).spring;
  };
  std::vector<Contact> contacts{{0, 0, foundation_body, 0, 0.5, 0.02, 0.015}};
  contacts[0].stress_free_gap             = -0.06; // presses by 0.04 m
  const ContactLoads::CornerLength corner = [](const Contact &) { return 2.; };
  ContactLoads::turn(turned(1.), corner, contacts);
  EXPECT_EQ(contacts[0].stress_free_gap, -0.06) << "the first time there is nothing to keep";

  const double  start = length(turned(1.), contacts);
  const Contact first = contacts[0];
  ContactLoads::turn(turned(2.), corner, contacts);
  const double end = length(turned(2.), contacts);
  EXPECT_GT(end, 1.5 * start) << "the corner's springs are longer";
  const double depth = contacts[0].stress_free_gap + 0.1, slip = 0.02 - contacts[0].plastic_slip;
  EXPECT_NEAR(end * depth * depth, start * 0.04 * 0.04, 1e-12);
  EXPECT_NEAR(end * slip * slip, start * 0.005 * 0.005, 1e-12);

  ContactLoads::turn(turned(1.), corner, contacts);
  EXPECT_NEAR(contacts[0].stress_free_gap, first.stress_free_gap, 1e-12) << "and back";
  EXPECT_NEAR(contacts[0].plastic_slip, first.plastic_slip, 1e-12);
}



TEST(ContactLoad, a_contact_whose_edges_turn_does_not_act_before_they_touch)
{
  std::vector<Contact> contacts{{0, 0, foundation_body, 0, 0.5}};
  contacts[0].closeness =
    0.; // a long corner, whose springs are short where edges lie on each other
  ContactLoads::turn(
    square_in_the_ground(), [](const Contact &) { return 100.; }, contacts);
  EXPECT_EQ(contacts[0].stress_free_gap, 0.);
  EXPECT_EQ(contacts[0].closeness, 1.);
}
