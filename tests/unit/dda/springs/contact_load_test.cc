// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

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
