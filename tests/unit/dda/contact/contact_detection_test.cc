// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scenes.h"

#include <numeric>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::dda::contact_scenes;

  /// 60 steps of a drifting cloud; history is written as an accepting solver would.
  Contacts drift(Geometry g, const double margin, long &builds)
  {
    ContactDetection detection({parameters.reach, margin, parameters.smooth_angle});
    Contacts         contacts;
    for (int step = 0; step < 60; ++step)
      {
        detection.update(g, contacts);
        for (Contact &c : contacts)
          {
            c.slip += 1e-3 * c.edge_position;
            c.plastic_slip = 0.5 * c.slip;
            c.state        = ContactState::sliding;
          }
        for (int b = 0; b < g.n_blocks(); ++b)
          move_block(g, b, 0.004 * Vec2(std::sin(3. * b), std::cos(5. * b + 0.1 * step)));
      }
    builds = detection.report().builds;
    return contacts;
  }

  TEST(ContactDetection, ResultDoesNotDependOnWhenTheListWasBuilt)
  {
    const Geometry g = cloud(300, 5);
    long           every_step, seldom, never;
    const Contacts a = drift(g, 0., every_step), b = drift(g, 0.08, seldom),
                   c = drift(g, 10., never);
    EXPECT_EQ(every_step, 60);
    EXPECT_GT(seldom, 1);
    EXPECT_LT(seldom, 20);
    EXPECT_EQ(never, 1);
    EXPECT_GT(a.size(), 200u);
    expect_equal(a, b);
    expect_equal(a, c);
  }

  /// Two clouds that an earthquake carries along while one falls on the other: the search sleeps
  /// until they come near, and what it finds is what a search finds that looks at every pair anew.
  TEST(ContactDetection, SleepingSearchEqualsAnAwakeOneToTheBit)
  {
    constexpr double reach = 0.02, margin = 0.5, fall = 0.005;
    Geometry         g = blocks({square(0., 0.), square(1.5, 0.), square(3., 0.)});
    const int        n = g.n_blocks();
    for (const double x : {0.3, 1.7, 2.9})
      add_block(g, square(x, 1.2));
    ContactDetection detection({reach, margin, parameters.smooth_angle});
    Contacts         contacts, contacts_awake;
    int              slept = 0, touched = 0;
    for (int step = 0; step < 60; ++step)
      {
        ContactDetection awake({reach, 0., parameters.smooth_angle});
        const long       searches = detection.report().searches;
        detection.update(g, contacts);
        awake.update(g, contacts_awake);
        expect_equal(contacts, contacts_awake);
        EXPECT_EQ(detection.report().lost, awake.report().lost);
        const bool sleeps = detection.report().searches == searches;
        EXPECT_TRUE(!sleeps || contacts.empty());
        slept += sleeps ? 1 : 0;
        touched += contacts.empty() ? 0 : 1;
        for (Contacts *list : {&contacts, &contacts_awake})
          for (Contact &c : *list)
            c.slip += 1e-3 * c.edge_position;
        for (int b = 0; b < g.n_blocks(); ++b)
          move_block(g, b, Vec2(0.3 * std::sin(0.4 * step), b < n ? 0. : -fall));
      }
    EXPECT_EQ(detection.report().builds, 1) << "carried along together: no new list";
    EXPECT_GE(slept, 30);
    EXPECT_GE(touched, 5);
  }

  TEST(ContactDetection, PermutedBlocksGiveTheSameContacts)
  {
    const Geometry   g = cloud(200, 9);
    std::vector<int> order(g.n_blocks());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    Geometry p;
    p.foundation_nodes = g.foundation_nodes;
    for (const int b : order)
      add_block(p, Outline(g.vertices.begin() + g.offset[b], g.vertices.begin() + g.offset[b + 1]));

    ContactDetection dg(parameters), dp(parameters);
    Contacts         cg, cp;
    dg.update(g, cg);
    dp.update(p, cp);
    const auto vertex = [&](const int body, const int v) {
      return body == foundation_body ? v : 3 * order[v / 3] + v % 3;
    };
    for (Contact &c : cp)
      {
        c.vertex = vertex(c.vertex_body, c.vertex);
        c.edge   = vertex(c.edge_body, c.edge);
        for (int *body : {&c.vertex_body, &c.edge_body})
          *body = *body == foundation_body ? foundation_body : order[*body];
      }
    std::sort(cp.begin(), cp.end(), [](const Contact &a, const Contact &b) {
      return key(a) < key(b);
    });
    expect_equal(cg, cp);
    EXPECT_EQ(dg.report().lost, dp.report().lost);
  }

  // ------------------------------------------------------------- what is skipped

  TEST(ContactDetection, BondedPairsAndSleepingNeighboursAreSkipped)
  {
    Geometry g         = blocks({square(0., 0.), square(1., 0.), square(2., 0.)});
    g.foundation_nodes = {{-1., 0.}, {1.5, 0.}, {4., 0.}};
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 1, 3, 4}, {1, 0, 2, 1});
    SkippedPairs skipped{{{0, 1}, {1, 2}},
                         {{0, foundation_body, 0},
                          {1, foundation_body, 0},
                          {1, foundation_body, 1},
                          {2, foundation_body, 1}},
                         {ContactScope::no, ContactScope::no, ContactScope::no},
                         {1, 1, 1}};
    detection.set_skipped_pairs(skipped);
    Contacts contacts;
    detection.update(g, contacts);
    EXPECT_TRUE(contacts.empty()) << "an intact mass has no contacts";

    skipped.bonded  = {{0, 1}}; // joint between 1 and 2 released
    skipped.surface = {{0, foundation_body, 0}, {1, foundation_body, 0}, {1, foundation_body, 1}};
    skipped.scope   = {ContactScope::no, ContactScope::to_all, ContactScope::to_all};
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      {
        EXPECT_NE(c.vertex_body, 0);
        EXPECT_NE(c.edge_body, 0);
      }
    EXPECT_NE(find(contacts, 8, foundation_body, 1), nullptr);
    EXPECT_EQ(find(contacts, 4, foundation_body, 0), nullptr) << "block 1 is still bonded there";
    EXPECT_EQ(contacts.size(), 6u) << "four between blocks 1 and 2, two below block 2";

    const long builds = detection.report().builds;
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    EXPECT_EQ(detection.report().builds, builds) << "nothing changed, nothing built";
  }

  TEST(ContactDetection, BlocksWithAJointTouchBesideIt)
  {
    // A square on the ledge of an L, at its wall. The joint lies along edges 2 and 6.
    Geometry g = blocks({{{0., 0.}, {4., 0.}, {4., 1.}, {1., 1.}, {1., 3.}, {0., 3.}}});
    add_block(g, square(0.999, 0.999));
    ContactDetection detection(parameters);
    Contacts         contacts;
    SkippedPairs     skipped{{{0, 1}}, {}, {ContactScope::to_all, ContactScope::to_all}};
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    EXPECT_TRUE(contacts.empty()) << "bonded";

    skipped.bonded.clear();
    skipped.joint_edges = {{0, 1, 6}, {1, 0, 2}};
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    EXPECT_NE(find(contacts, 6, 0, 3), nullptr) << "the wall";
    for (const Contact &c : contacts)
      EXPECT_TRUE(c.edge != 2 && c.edge != 6) << "the joint acts there";
  }

  TEST(ContactDetection, NeighboursThatOverlapAtTheirFirstLookStartWithoutForce)
  {
    constexpr double overlap = 0.004, slack = 0.001 * parameters.reach;
    const Geometry   g = blocks({square(0., 0.), square(0.1, 1. - overlap)});
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 1, 2}, {1, 0});
    Contacts contacts;
    detection.set_skipped_pairs({{}, {}, {ContactScope::no, ContactScope::no}});
    detection.set_was_awake({ContactScope::no, ContactScope::no});
    detection.update(g, contacts);
    EXPECT_TRUE(contacts.empty()) << "neighbours that sleep";

    detection.set_skipped_pairs({{}, {}, {ContactScope::no, ContactScope::to_blocks}});
    detection.update(g, contacts);
    ASSERT_FALSE(contacts.empty());
    for (const Contact &c : contacts)
      EXPECT_NEAR(c.stress_free_gap, -overlap - slack, 1e-12);

    detection.set_was_awake({ContactScope::no, ContactScope::to_blocks});
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      EXPECT_NEAR(c.stress_free_gap, -overlap - slack, 1e-12) << "a contact keeps it";

    contacts.clear();
    detection.update(g, contacts);
    ASSERT_FALSE(contacts.empty());
    for (const Contact &c : contacts)
      EXPECT_EQ(c.stress_free_gap, 0.) << "an overlap that comes about later is pushed out";
  }

  TEST(ContactDetection, BlockWhoseJointHasGivenWayStillDoesNotLookAtTheBase)
  {
    Geometry g         = blocks({square(0., -0.004), square(1.02, -0.004)});
    g.foundation_nodes = {{-1., 0.}, {1., 0.}, {4., 0.}};
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 1, 2}, {1, 0});
    Contacts     contacts;
    SkippedPairs skipped{{},
                         {{0, foundation_body, 0}, {1, foundation_body, 1}},
                         {ContactScope::to_blocks, ContactScope::no},
                         {1, 1}};
    detection.set_skipped_pairs(skipped);
    detection.set_was_awake({ContactScope::to_blocks, ContactScope::no});
    detection.update(g, contacts);
    for (const Contact &c : contacts)
      EXPECT_TRUE(c.vertex_body != foundation_body && c.edge_body != foundation_body);

    skipped.scope = {ContactScope::to_blocks, ContactScope::to_all};
    detection.set_skipped_pairs(skipped);
    detection.update(g, contacts);
    const Contact *corner = find(contacts, 4, foundation_body, 0);
    EXPECT_EQ(corner, nullptr) << "the second block begins beyond the first segment";
    EXPECT_EQ(find(contacts, 5, foundation_body, 1), nullptr) << "still bonded to its own segment";
  }

  TEST(ContactDetection, FirstLookAtTheBaseStartsWithoutForceToo)
  {
    Geometry g         = blocks({square(0.9, -0.004)});
    g.foundation_nodes = {{-1., 0.}, {1., 0.}, {4., 0.}};
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 0}, {});
    Contacts contacts;
    detection.set_skipped_pairs({{}, {{0, foundation_body, 1}}, {ContactScope::to_all}, {1}});
    detection.set_was_awake({ContactScope::to_blocks});
    detection.update(g, contacts);
    const Contact *corner = find(contacts, 0, foundation_body, 0);
    ASSERT_NE(corner, nullptr) << "over the segment to which it was never bonded";
    EXPECT_NEAR(corner->stress_free_gap, -0.004 - 0.001 * parameters.reach, 1e-12);
  }

  TEST(ContactDetection, BondedBlockThatIsNotHeldOffLooksAtTheBase)
  {
    Geometry g         = blocks({square(0., -0.001)});
    g.foundation_nodes = {{-1., 0.}, {4., 0.}};
    ContactDetection detection(parameters);
    detection.set_neighbours({0, 0}, {});
    Contacts contacts;
    detection.set_skipped_pairs({{}, {}, {ContactScope::no}, {0}});
    detection.set_was_awake({ContactScope::no});
    detection.update(g, contacts);
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact &c : contacts)
      EXPECT_EQ(c.stress_free_gap, 0.) << "it has always looked";
    detection.set_skipped_pairs({{}, {}, {ContactScope::no}, {1}});
    detection.update(g, contacts);
    EXPECT_TRUE(contacts.empty());
  }

  TEST(ContactDetection, AContactThatPressesIsNotLostForASmallBlockElsewhere)
  {
    // A square of 4 m presses a surface and a square below it; new contacts are 1 mm deep at most,
    // as where there is a pebble of 4 mm.
    for (const auto &[on_surface, skin] :
         {std::pair(true, 1.), std::pair(true, 1e-3), std::pair(false, 1.), std::pair(false, 1e-3)})
      {
        Geometry g = blocks({square(0., 0., 4.)});
        if (on_surface)
          g.foundation_nodes = {{-5., 0.}, {9., 0.}};
        else
          add_block(g, square(-1., -6., 6.));
        ContactDetection detection({1e-3, skin, ContactTolerances::smooth_angle, 1e-3, 1.});
        Contacts         contacts;
        detection.update(g, contacts);
        ASSERT_EQ(contacts.size(), 2u);
        const Contacts found = contacts;
        for (int k = 0; k < 60; ++k) // 0.9 m at last
          {
            move_block(g, 0, {0., -0.015});
            detection.update(g, contacts);
            expect_equal(contacts, found);
          }
        move_block(g, 0, {0., 0.9 + 2e-3}); // it has lifted off
        detection.update(g, contacts);
        EXPECT_TRUE(contacts.empty());
      }
  }

  // ------------------------------------------------------------- rest

  TEST(ContactDetection, WhatLiesStillIsNotSearchedAgain)
  {
    Geometry g         = blocks({square(0., 0.), square(0., 1.), square(3., 0.), square(3., 1.)});
    g.foundation_nodes = {{-1., 0.}, {2., 0.}, {5., 0.}};
    ContactDetection detection(parameters);
    RestState        rest;
    Contacts         contacts;
    for (int step = 0; step < 3; ++step)
      detection.update(g, contacts, rest);
    const Contacts found    = contacts;
    const long     searches = detection.report().searches;
    ASSERT_EQ(found.size(), 12u) << "six for each stack";

    detection.update(g, contacts, rest);
    EXPECT_EQ(detection.report().searches, searches) << "all rests";
    expect_equal(contacts, found);

    move_block(g, 3, {0., 1e-3});
    detection.update(g, contacts, rest);
    EXPECT_EQ(detection.report().searches, searches + 1);
    Contacts all;
    ContactDetection(parameters).update(g, all);
    EXPECT_LT(detection.report().edge_tests, 30) << "only what is near block 3";
    ASSERT_EQ(contacts.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(key(contacts[i]), key(all[i]));
  }

  TEST(ContactDetection, SlowCreepIsNoRest)
  {
    Geometry         g = blocks({square(0., 0.), square(0.2, 1.)});
    ContactDetection detection(parameters);
    RestState        rest;
    Contacts         contacts;
    for (int step = 0; step < 3000; ++step)
      {
        move_block(g, 1, {-1e-4 * step / 1500., 0.});
        detection.update(g, contacts, rest);
      }
    Contacts all;
    ContactDetection(parameters).update(g, all);
    ASSERT_EQ(contacts.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(key(contacts[i]), key(all[i]))
        << "the upper block has crept beyond the lower one's end";
  }

  // ------------------------------------------------------------- cost

  TEST(ContactDetection, CostIsLinearInTheNumberOfBlocks)
  {
    const auto tests_per_block = [](const int n) {
      Geometry         g = cloud(n, 2);
      ContactDetection detection(parameters);
      Contacts         contacts;
      detection.update(g, contacts);
      return std::make_pair(double(detection.report().edge_tests) / n,
                            double(detection.n_build_tests()) / n);
    };
    const auto small = tests_per_block(1000), large = tests_per_block(10000);
    EXPECT_LT(large.first, 1.2 * small.first);
    EXPECT_LT(large.second, 1.2 * small.second);
    EXPECT_LT(large.first, 60.);
  }

  TEST(ContactDetection, SteadyStateAllocatesNothing)
  {
    Geometry         g = cloud(300, 4);
    ContactDetection detection(parameters);
    Contacts         contacts;
    detection.update(g, contacts);
    detection.update(g, contacts);
    const Contact    *data     = contacts.data();
    const std::size_t capacity = contacts.capacity();
    for (int i = 0; i < 5; ++i)
      detection.update(g, contacts);
    EXPECT_EQ(contacts.data(), data);
    EXPECT_EQ(contacts.capacity(), capacity);
  }
} // namespace
