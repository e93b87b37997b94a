// SPDX-License-Identifier: GPL-3.0-or-later
#include "bedrock_section.h"

#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/statics/initial_bedding_tractions.h>
#include <hybrid/dda/statics/initial_block_stress.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/dda/step/rest_forces.h>
#include <hybrid/scene/boundary/fixed_base.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double ratio = 0.7, gravity = 10.;

  /// Unit triangles of level ground, nine rows deep, and an upright plane from the ground down to
  /// the middle.
  struct Ground
  {
    static constexpr int   columns = 6, rows = 9;
    scene::SectionMesh     mesh  = layered_section(columns, {rows});
    scene::SceneParameters scene = bedrock_parameters("triangles");
    Model                  model;
    DdaState               state;

    Ground()
    {
      for (int j = 4; j < rows; ++j)
        mesh.lines["bedding_1"].push_back({j * (columns + 1) + 3, (j + 1) * (columns + 1) + 3});
      scene.continuum.base                  = scene::fixed_base();
      scene.environment.gravity             = gravity;
      scene.environment.initial_stress      = "given";
      scene.materials["rock"].initial_ratio = ratio;
      scene.bedding.slips                   = true;
      scene.bedding.friction_angle          = 30.;
      scene.bedding.initial_normal_stress   = 1e3;
      std::vector<Vec2> nodes;
      for (const int node : cut_bedrock(mesh, scene).foundation)
        nodes.push_back(mesh.nodes[node]);
      model = build_model(mesh, scene, nodes);
      state = initial_state(model);
    }
  };
} // namespace



TEST(InitialBlockStress, of_level_ground_leaves_no_force_on_any_unknown)
{
  Ground       ground;
  const double part   = 1e-6; // the stretch of joints is finite: forces are exact to first order
  const double weight = part * ground.scene.materials.at("rock").density * gravity;
  prescribe_block_stress(
    scene::InitialStress(ground.mesh, ground.scene), 0, ground.model, ground.state, {true, part});
  const RestForces springs(ground.model, ground.state);
  int              inside = 0;
  for (int b = 0; b < ground.model.n_blocks(); ++b)
    {
      const BlockState      &block = ground.state.blocks[b];
      const BlockProperties &p     = ground.model.blocks[b];
      EXPECT_NEAR(block.stress[1], -weight * (Ground::rows - block.centroid.y()), 1e-9 * weight);
      EXPECT_NEAR(block.stress[0], ratio * block.stress[1], 1e-9 * weight);
      if (block.centroid.x() < 1. || block.centroid.x() > Ground::columns - 1.)
        continue; // the sides bear what is beside them
      ++inside;
      Vec6 force = springs.bonds.segment<6>(6 * b);
      force[1] -= part * p.weight_at_rest * gravity;
      force.tail<3>() -= p.area * block.stress;
      EXPECT_LT(force.norm(), 1e-9 * weight) << b;
    }
  EXPECT_EQ(inside, 2 * Ground::rows * (Ground::columns - 2));
}



TEST(InitialBlockStress, planes_of_the_bedrock_bear_it)
{
  Ground            ground;
  const BeddingRest rest =
    stress_bedding_planes(ground.mesh, ground.scene, ground.model, true, ground.state);
  EXPECT_TRUE(rest.equilibrium);
  EXPECT_EQ(rest.slipping + rest.open, 0);
  const double weight = ground.scene.materials.at("rock").density * gravity;
  int          n      = 0;
  for (std::size_t j = 0; j < ground.model.joints.size(); ++j)
    if (ground.model.joints[j].kind == JointKind::bedding)
      {
        const Joint &joint = ground.model.joints[j];
        const auto  &g     = ground.model.initial;
        const double depth =
          Ground::rows - 0.5 * (g.vertices[joint.edge].y() + g.vertices[g.next(joint.edge)].y());
        const auto &points = ground.state.joints[j].points;
        EXPECT_NEAR(0.5 * (points[0].normal + points[1].normal),
                    ratio * weight * depth + 1e3,
                    1e-4 * weight);
        EXPECT_NEAR(points[0].shear, 0., 1e-4 * weight);
        ++n;
      }
  EXPECT_EQ(n, 5);
}
