// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/coupling/rigid_foundation.h>
#include <hybrid/output/probes.h>
#include <hybrid/scene/input_error.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::output;

  /// One square block [0, 2] x [0, 2] and a base below it.
  struct OneBlock
  {
    OneBlock()
      : model(dda::build_model(test::square_blocks(1, 1, 2.),
                               test::block_parameters(30.),
                               test::straight_foundation(0., 1., 3.)))
    {
      state.blocks = dda::initial_state(model);
    }

    dda::Model             model;
    coupling::CoupledState state;
  };



  /// Move the block of the state by d, as an accepted step does.
  void move(coupling::CoupledState &state, const dda::Vec6 &d)
  {
    dda::BlockState       &block = state.blocks.blocks[0];
    const dda::BlockMotion motion(block.centroid, d);
    for (Vec2 &x : state.blocks.geometry.vertices)
      x += motion.displacement(x);
    block.centroid = motion.centroid;
    block.rotation += d[2];
  }
} // namespace



// A point of a block that turns by a quarter turn while it is stretched and moved.
TEST(Probes, point_of_a_rotating_block_is_its_affine_image)
{
  OneBlock  scene;
  Probes    probes(&scene.model, nullptr);
  const int corner = probes.add(Vec2(1.75, 0.5), "P"), centre = probes.add(Vec2(1., 1.), "C");
  probes.set_reference(scene.state);
  dda::Vec6 d;
  d << 10., -3., M_PI / 2., 0.1, 0., 0.;
  move(scene.state, d);
  // (0.75, -0.5) from the centroid, stretched to (0.825, -0.5), turned to (0.5, 0.825).
  const Vec2 expected = Vec2(10., -3.) + Vec2(0.5, 0.825) - Vec2(0.75, -0.5);
  EXPECT_LT((probes.sample(scene.state, corner).displacement - expected).norm(), 1e-13);
  EXPECT_LT((probes.sample(scene.state, centre).displacement - Vec2(10., -3.)).norm(), 1e-13);
}



TEST(Probes, velocity_of_a_rotating_block)
{
  OneBlock  scene;
  Probes    probes(&scene.model, nullptr);
  const int p = probes.add(Vec2(1.75, 0.5), "P");
  probes.set_reference(scene.state);
  dda::BlockState &block = scene.state.blocks.blocks[0];
  block.velocity << 1., 2., 3., 0., 0., 0.;
  block.acceleration << -1., 0., 0., 2., 0., 0.;
  const PointMotion motion = probes.sample(scene.state, p);
  // v + omega x r with r = (0.75, -0.5)
  EXPECT_LT((motion.velocity - Vec2(1. + 1.5, 2. + 2.25)).norm(), 1e-14);
  EXPECT_LT((motion.acceleration - Vec2(-1. + 1.5, 0.)).norm(), 1e-14);
}



TEST(Probes, displacement_counts_from_the_reference)
{
  OneBlock  scene;
  Probes    probes(&scene.model, nullptr);
  const int p = probes.add(Vec2(0.5, 0.5), "P");
  dda::Vec6 d = dda::Vec6::Zero();
  d[1]        = -0.01; // settlement
  move(scene.state, d);
  probes.set_reference(scene.state);
  EXPECT_EQ(probes.sample(scene.state, p).displacement.norm(), 0.);
  d[0] = 0.3;
  d[1] = 0.;
  move(scene.state, d);
  EXPECT_LT((probes.sample(scene.state, p).displacement - Vec2(0.3, 0.)).norm(), 1e-14);
}



TEST(Probes, points_outside_of_blocks_move_with_the_rigid_base)
{
  OneBlock  scene;
  Probes    probes(&scene.model, nullptr);
  const int p = probes.add(Vec2(0.5, -5.), "below");
  probes.set_reference(scene.state);
  for (int k = 0; k < scene.model.n_foundation_nodes(); ++k)
    scene.state.blocks.foundation_displacement.segment<2>(2 * k) = Vec2(0.2, 0.1);
  EXPECT_EQ(probes.sample(scene.state, p).displacement, Vec2(0.2, 0.1));
}



TEST(Probes, the_base_has_the_velocity_and_acceleration_of_the_motion)
{
  OneBlock                        scene;
  const coupling::RigidFoundation base(scene.model.initial.foundation_nodes,
                                       {scene::Motion(0.5, {2., 2., 2.}),
                                        scene::MotionParameters()});
  Probes                          probes(&scene.model, nullptr, &base);
  const int                       p = probes.add(Vec2(0.5, -5.), "below");
  probes.set_reference(scene.state);
  scene.state.set_time(0.75);
  const PointMotion motion = probes.sample(scene.state, p);
  EXPECT_LT((motion.velocity - Vec2(1.5, 0.)).norm(), 1e-14);
  EXPECT_LT((motion.acceleration - Vec2(2., 0.)).norm(), 1e-14);
}



// However near the block above it is.
TEST(Probes, what_lies_below_the_surface_belongs_to_the_base)
{
  OneBlock scene;
  Probes   probes(&scene.model, nullptr);
  for (const double depth : {0.01, 0.5, 0.9})
    {
      const int p = probes.add(Vec2(1., -depth), "P");
      probes.set_reference(scene.state);
      dda::Vec6 d = dda::Vec6::Zero();
      d[0]        = 1.;
      move(scene.state, d);
      EXPECT_EQ(probes.sample(scene.state, p).displacement, Vec2(0., 0.)) << depth;
    }
}



TEST(Probes, point_in_the_air_is_refused_with_the_distances)
{
  OneBlock scene;
  Probes   probes(&scene.model, nullptr);
  EXPECT_NO_THROW(probes.add(Vec2(1., 2. + 1e-3), "P")); // rounded
  try
    {
      probes.add(Vec2(1., 2.9), "P");
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what())
                  .find(
                    "the point 'P' at (1, 2.9) m lies in no part of the section: 0.9 m from the "
                    "nearest block, 2.9 m above the base, where "),
                std::string::npos)
        << error.what();
    }
}



TEST(Probes, point_on_the_outline_belongs_to_the_block)
{
  OneBlock  scene;
  Probes    probes(&scene.model, nullptr);
  const int p = probes.add(Vec2(1., 2. + 1e-9), "top");
  probes.set_reference(scene.state);
  dda::Vec6 d = dda::Vec6::Zero();
  d[0]        = 1.;
  move(scene.state, d);
  EXPECT_LT((probes.sample(scene.state, p).displacement - Vec2(1., 0.)).norm(), 1e-12);
}



TEST(Probes, point_in_nothing_is_refused_by_name)
{
  const dda::Model model =
    dda::build_model(test::square_blocks(1, 1, 2.), test::block_parameters(30.), {});
  Probes probes(&model, nullptr);
  try
    {
      probes.add(Vec2(50., 50.), "lost");
      FAIL() << "accepted";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("'lost' at (50, 50)"), std::string::npos)
        << error.what();
    }
}



// What is in no block moves with the base, but not in the air.
TEST(Probes, point_above_the_base_is_refused)
{
  OneBlock scene;
  Probes   probes(&scene.model, nullptr);
  EXPECT_NO_THROW(probes.add(Vec2(0.5, -1.), "in the base"));
  EXPECT_NO_THROW(probes.add(Vec2(2.5, 0.001), "on the base, rounded"));
  EXPECT_NO_THROW(probes.add(Vec2(500., -1.), "beside the base"));
  EXPECT_THROW(probes.add(Vec2(5e4, -1.), "far away"), InputError);
  for (const Vec2 &x : {Vec2(1., 400.), Vec2(500., 3.)})
    try
      {
        probes.add(x, "P");
        FAIL() << x.transpose();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("m above the base"), std::string::npos)
          << error.what();
      }
}
