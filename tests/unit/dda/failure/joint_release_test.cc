// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/failure/joint_release.h>
#include <hybrid/dda/joint/rock_bond.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace hybrid;
using namespace hybrid::dda;

namespace
{
  constexpr double overlap   = 1e-3; ///< of the blocks of the joint, and of its springs [m]
  constexpr double stiffness = 1e9;  ///< of the joint and of contacts [Pa/m]

  /// Two unit squares, one on the other, that overlap; their joint has been released under
  /// pressure.
  struct Pair
  {
    Model    model;
    DdaState state;

    Pair()
    {
      const JointStrength strength = bond_strength(Material(), 0., 0.1);
      model.joints.push_back({1, 4, 0, 1., {}, JointLaw(strength, stiffness, stiffness)});
      state.geometry.vertices = {{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}};
      state.geometry.offset   = {0, 4, 8};
      state.geometry.block_of = {0, 0, 0, 0, 1, 1, 1, 1};
      for (int v = 0; v < 4; ++v)
        state.geometry.vertices.push_back(state.geometry.vertices[v] + Vec2(0.1, 1. - overlap));
      JointState now;
      now.failure       = FailureKind::shear;
      now.released      = true;
      now.points[0].gap = -overlap;
      now.points[1].gap = -0.5 * overlap;
      state.joints.push_back(now);
      model.blocks.resize(2);
      model.contacts.edge.assign(8, 0);
      model.contacts.of = {
        std::vector<ContactLaw>(2, {JointLaw(strength, stiffness, stiffness), 0.5})};
      press();
    }

    /// The joint's springs have the forces of their overlaps.
    void press()
    {
      for (SpringState &point : state.joints[0].points)
        point.normal = std::max(0., -stiffness * point.gap);
    }

    /// stress_free_gap of a contact of the upper block's first vertex on the lower block's top that
    /// had @p stress_free_gap, after the release.
    double after(const double stress_free_gap)
    {
      Contact contact{1, 4, 0, 2};
      contact.edge_position   = 0.9;
      contact.stress_free_gap = stress_free_gap;
      state.contacts          = {contact};
      hand_over_released_joints(model, state);
      return state.contacts[0].stress_free_gap;
    }
  };
} // namespace


TEST(JointRelease, contacts_press_from_the_overlap_of_the_joint)
{
  EXPECT_NEAR(Pair().after(-2. * overlap), 0., 1e-15);
}


TEST(JointRelease, contacts_bear_no_more_than_the_joint_did)
{
  Pair sheared; // its blocks overlap more than its springs
  for (SpringState &point : sheared.state.joints[0].points)
    point.gap = -0.2 * overlap;
  sheared.press();
  EXPECT_NEAR(sheared.after(-2. * overlap), -0.8 * overlap, 1e-15);

  Pair torn;
  for (SpringState &point : torn.state.joints[0].points)
    point.gap = 3. * overlap;
  torn.press();
  EXPECT_NEAR(torn.after(-2. * overlap), -overlap, 1e-15);

  // A short edge of large blocks is soft: it has overlapped by as much, and bears little.
  Pair narrow;
  narrow.model.joints[0].length = 0.02;
  EXPECT_NEAR(narrow.after(-2. * overlap), -overlap + 0.02 * overlap, 1e-15);
  Pair soft;
  for (SpringState &point : soft.state.joints[0].points)
    point.normal *= 1e-2;
  EXPECT_NEAR(soft.after(-2. * overlap), -overlap + 0.01 * overlap, 1e-15);
}


TEST(JointRelease, what_presses_already_stays_as_it_is)
{
  Pair pair;
  for (SpringState &point : pair.state.joints[0].points)
    point.gap = -0.2 * overlap;
  EXPECT_EQ(pair.after(-0.1 * overlap), -0.1 * overlap);
}


TEST(JointRelease, happens_once_and_to_the_bodies_of_the_joint)
{
  Pair pair;
  pair.after(-2. * overlap);
  EXPECT_TRUE(pair.state.joints[0].handed_over);
  EXPECT_EQ(pair.after(-2. * overlap), -2. * overlap);

  Pair holding;
  holding.state.joints[0].released = false;
  EXPECT_EQ(holding.after(-2. * overlap), -2. * overlap);
  EXPECT_FALSE(holding.state.joints[0].handed_over);

  Pair other;
  other.model.joints[0].other = foundation_body;
  EXPECT_EQ(other.after(-2. * overlap), -2. * overlap);
}
