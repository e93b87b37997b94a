// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/state.h>
#include <hybrid/restart/archive.h>

#include <gtest/gtest.h>

namespace hybrid::dda
{
  namespace
  {
    using restart::Archive;

    template <typename State>
    State copied(State &state)
    {
      Archive writer = Archive::writer();
      writer(state);
      Archive reader = Archive::reader(writer.content());
      State   copy;
      reader(copy);
      EXPECT_TRUE(reader.at_end());
      return copy;
    }



    TEST(State, BlockStateIsStoredWhole)
    {
      BlockState block;
      block.centroid             = {1., 2.};
      block.rotation             = 3.;
      block.velocity             = Vec6::LinSpaced(4., 9.);
      block.acceleration         = Vec6::LinSpaced(10., 15.);
      block.contact_acceleration = Vec6::LinSpaced(16., 21.);
      block.acceleration_change  = Vec6::LinSpaced(30., 35.);
      block.velocity_change      = Vec6::LinSpaced(40., 45.);
      block.stress               = {22., 23., 24.};
      block.viscous_stress       = {25., 26., 27.};
      block.plastic_strain       = 28.;
      block.rest_plastic_strain  = 29.;
      const BlockState copy      = copied(block);
      EXPECT_EQ(copy.centroid, block.centroid);
      EXPECT_EQ(copy.rotation, block.rotation);
      EXPECT_EQ(copy.velocity, block.velocity);
      EXPECT_EQ(copy.acceleration, block.acceleration);
      EXPECT_EQ(copy.contact_acceleration, block.contact_acceleration);
      EXPECT_EQ(copy.acceleration_change, block.acceleration_change);
      EXPECT_EQ(copy.velocity_change, block.velocity_change);
      EXPECT_EQ(copy.stress, block.stress);
      EXPECT_EQ(copy.viscous_stress, block.viscous_stress);
      EXPECT_EQ(copy.plastic_strain, block.plastic_strain);
      EXPECT_EQ(copy.rest_plastic_strain, block.rest_plastic_strain);
    }



    TEST(State, TheFastestCornerIsThatOfABlockThatSpins)
    {
      DdaState state;
      EXPECT_EQ(fastest_block(state), 0.);
      state.geometry.vertices = {{0., 0.}, {2., 0.}, {1., 3.}, {5., 0.}, {6., 0.}, {5., 3.}};
      state.geometry.offset   = {0, 3, 6};
      state.geometry.block_of = {0, 0, 0, 1, 1, 1};
      state.blocks.resize(2);
      state.blocks[0].centroid = {1., 1.};
      state.blocks[1].centroid = {16. / 3., 1.};
      for (BlockState &block : state.blocks)
        block.velocity.setZero();
      state.blocks[1].velocity[1] = -0.5;
      EXPECT_DOUBLE_EQ(fastest_block(state), 0.5);
      state.blocks[0].velocity[2] = 0.3; // its highest corner is 2 m from its middle
      EXPECT_DOUBLE_EQ(fastest_block(state), 0.6);
    }



    TEST(State, SpringStateIsStoredWhole)
    {
      SpringState spring;
      spring.history         = {1., 2., 3.};
      spring.jump            = {4., 5.};
      spring.gap             = 6.;
      spring.slip            = 7.;
      spring.normal          = 8.;
      spring.shear           = 9.;
      spring.elastic_normal  = 10.;
      spring.elastic_shear   = 11.;
      spring.state           = ContactState::sliding;
      const SpringState copy = copied(spring);
      EXPECT_EQ(copy.history.plastic_slip, 1.);
      EXPECT_EQ(copy.history.softening, 2.);
      EXPECT_EQ(copy.history.damage, 3.);
      EXPECT_EQ(copy.jump, spring.jump);
      EXPECT_EQ(copy.gap, 6.);
      EXPECT_EQ(copy.slip, 7.);
      EXPECT_EQ(copy.normal, 8.);
      EXPECT_EQ(copy.shear, 9.);
      EXPECT_EQ(copy.elastic_normal, 10.);
      EXPECT_EQ(copy.elastic_shear, 11.);
      EXPECT_EQ(copy.state, ContactState::sliding);
    }



    TEST(State, JointStateIsStoredWhole)
    {
      JointState joint;
      joint.points[0].gap   = 1.;
      joint.points[1].gap   = 2.;
      joint.failure         = FailureKind::shear;
      joint.failure_time    = 3.;
      joint.has_yielded     = true;
      joint.released        = true;
      joint.handed_over     = true;
      const JointState copy = copied(joint);
      EXPECT_EQ(copy.points[0].gap, 1.);
      EXPECT_EQ(copy.points[1].gap, 2.);
      EXPECT_EQ(copy.failure, FailureKind::shear);
      EXPECT_EQ(copy.failure_time, 3.);
      EXPECT_TRUE(copy.has_yielded);
      EXPECT_TRUE(copy.released);
      EXPECT_TRUE(copy.handed_over);
    }



    TEST(State, ContactIsStoredWhole)
    {
      Contact       contact{1, 2, 3, 4, 5., 6., 7., ContactState::locked, -8., -9., 0.9};
      const Contact copy = copied(contact);
      EXPECT_EQ(copy.vertex_body, 1);
      EXPECT_EQ(copy.vertex, 2);
      EXPECT_EQ(copy.edge_body, 3);
      EXPECT_EQ(copy.edge, 4);
      EXPECT_EQ(copy.edge_position, 5.);
      EXPECT_EQ(copy.slip, 6.);
      EXPECT_EQ(copy.plastic_slip, 7.);
      EXPECT_EQ(copy.state, ContactState::locked);
      EXPECT_EQ(copy.stress_free_gap, -8.);
      EXPECT_EQ(copy.pressed_gap, -9.);
      EXPECT_EQ(copy.closeness, 0.9);
    }



    TEST(State, BlockEnergyIsStoredWhole)
    {
      BlockEnergy           energy;
      constexpr std::size_t n      = sizeof(BlockEnergy) / sizeof(double);
      double *const         values = &energy.kinetic;
      for (std::size_t k = 0; k < n; ++k)
        values[k] = 1. + k;
      const BlockEnergy   copy = copied(energy);
      const double *const read = &copy.kinetic;
      for (std::size_t k = 0; k < n; ++k)
        EXPECT_EQ(read[k], 1. + k);
    }



    TEST(State, DdaStateIsStoredWhole)
    {
      DdaState state;
      state.time                      = 1.;
      state.last_step                 = 1.5;
      state.geometry.offset           = {0, 3};
      state.geometry.block_of         = {0, 0, 0};
      state.geometry.vertices         = {{0., 0.}, {1., 0.}, {0., 1.}};
      state.geometry.foundation_nodes = {{5., 6.}};
      state.blocks.resize(1);
      state.blocks[0].rotation = 2.;
      state.joints.resize(2);
      state.joints[1].released       = true;
      state.contacts                 = {{1, 2, 3, 4, 5., 6., 7., ContactState::locked}};
      state.contact_scope            = {ContactScope::no, ContactScope::to_blocks};
      state.rest                     = {{{1., 2.}}, {{3., 4.}}, {1}, {0}};
      state.foundation_displacement  = Eigen::VectorXd::Constant(2, 3.);
      state.foundation_force         = Eigen::VectorXd::Constant(2, 4.);
      state.foundation_contact_force = Eigen::VectorXd::Constant(2, 5.);
      state.static_force             = Eigen::VectorXd::Constant(2, 6.);
      state.static_contact_force     = Eigen::VectorXd::Constant(2, 6.5);
      state.bedrock_static_force     = Eigen::VectorXd::Constant(6, 7.);
      state.boundary_force           = Eigen::VectorXd::Constant(4, 8.);
      state.surface_force            = {{1., 2.}, 3., 4., 5.};
      state.energy.gravity           = 9.;
      const DdaState copy            = copied(state);
      EXPECT_EQ(copy.time, 1.);
      EXPECT_EQ(copy.last_step, 1.5);
      EXPECT_EQ(copy.geometry.offset, state.geometry.offset);
      EXPECT_EQ(copy.geometry.block_of, state.geometry.block_of);
      EXPECT_EQ(copy.geometry.vertices, state.geometry.vertices);
      EXPECT_EQ(copy.geometry.foundation_nodes, state.geometry.foundation_nodes);
      EXPECT_EQ(copy.blocks.at(0).rotation, 2.);
      EXPECT_TRUE(copy.joints.at(1).released);
      EXPECT_EQ(copy.contacts.at(0).plastic_slip, 7.);
      EXPECT_EQ(copy.contact_scope, state.contact_scope);
      EXPECT_EQ(copy.rest.vertices, state.rest.vertices);
      EXPECT_EQ(copy.rest.foundation_nodes, state.rest.foundation_nodes);
      EXPECT_EQ(copy.rest.settled_vertices, state.rest.settled_vertices);
      EXPECT_EQ(copy.rest.settled_nodes, state.rest.settled_nodes);
      EXPECT_EQ(copy.foundation_displacement, state.foundation_displacement);
      EXPECT_EQ(copy.foundation_force, state.foundation_force);
      EXPECT_EQ(copy.foundation_contact_force, state.foundation_contact_force);
      EXPECT_EQ(copy.static_force, state.static_force);
      EXPECT_EQ(copy.static_contact_force, state.static_contact_force);
      EXPECT_EQ(copy.bedrock_static_force, state.bedrock_static_force);
      EXPECT_EQ(copy.boundary_force, state.boundary_force);
      EXPECT_EQ(copy.surface_force.force, state.surface_force.force);
      EXPECT_EQ(copy.surface_force.shear, 3.);
      EXPECT_EQ(copy.surface_force.normal, 4.);
      EXPECT_EQ(copy.surface_force.strength, 5.);
      EXPECT_EQ(copy.energy.gravity, 9.);
    }
  } // namespace
} // namespace hybrid::dda
