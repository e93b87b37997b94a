// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"
#include "coupled_section.h"

#include <hybrid/dda/failure/belt_parting.h>
#include <hybrid/dda/springs/bonded_area.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/scene/bedrock/layers_bedrock.h>
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/bedrock/triangles_bedrock.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  double tan_deg(const double angle)
  {
    return std::tan(angle * M_PI / 180.);
  }

  /// Friction 25 degrees in the mass, 12 on the belt, 15 in the rock if it is given.
  scene::SceneParameters parameters(const char *bedrock, const bool rock_has_friction)
  {
    scene::SceneParameters p = coupled_parameters();
    p.bedrock                = std::string(bedrock) == "triangles" ? scene::triangles_bedrock()
                               : std::string(bedrock) == "layers"  ? scene::layers_bedrock()
                                                                   : scene::rigid_bedrock();
    p.materials["mass"].friction_angle    = 25.;
    p.materials["mass"].cohesion          = 1e4;
    p.materials["mass"].residual_cohesion = 5e3;
    p.materials["rock"].friction_angle    = 15.;
    p.materials["rock"].given_friction_angle =
      rock_has_friction ? p.materials["rock"].friction_angle : -1.;
    p.materials["belt"]                   = p.materials["mass"];
    p.materials["belt"].name              = "belt";
    p.materials["belt"].friction_angle    = 12.;
    p.materials["belt"].cohesion          = 2e4;
    p.materials["belt"].tensile_strength  = 1e4;
    p.materials["belt"].residual_cohesion = -1.;
    p.bedrock                             = scene::rigid_bedrock();
    p.bedding.names                       = {"bedding_1"};
    p.blocks.belt_material                = "belt";
    return p;
  }

  /// The model of a mass on the middle two of four columns.
  Model model_of(const char *bedrock, const bool rock_has_friction)
  {
    Section s;
    s.columns               = 4;
    s.first                 = 1;
    s.plane_row             = 1;
    scene::SectionMesh mesh = section_mesh(s);
    for (int c = 0; c < s.rows * s.columns; ++c)
      mesh.bedrock_surface.push_back(c < s.columns ? 1 : 2);
    const scene::SceneParameters p = parameters(bedrock, rock_has_friction);
    std::vector<Vec2>            nodes;
    if (p.has_bedrock_blocks())
      for (const int node : cut_bedrock(mesh, p).foundation)
        nodes.push_back(mesh.nodes[node]);
    else
      for (int i = 0; i <= s.columns; ++i)
        nodes.push_back(mesh.nodes[s.rows * (s.columns + 1) + i]);
    return build_model(mesh, p, nodes);
  }

  /// Law of a vertex of block 0 on the edge of the ground whose middle is at @p x on y = 0.
  const JointLaw *law_at(const Model &model, const double x)
  {
    const Geometry &g     = model.initial;
    const auto      is_at = [x](const Vec2 &a, const Vec2 &b) {
      return (0.5 * (a + b) - Vec2(x, 0.)).norm() < 1e-9;
    };
    for (int k = 0; k + 1 < model.n_foundation_nodes(); ++k)
      if (is_at(g.foundation_nodes[k], g.foundation_nodes[k + 1]))
        return &model.contacts.law(g, {0, 0, foundation_body, k}, model.n_mass()).law;
    for (int b = model.n_mass(); b < model.n_blocks(); ++b)
      for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
        if (is_at(g.vertices[v], g.vertices[g.next(v)]))
          return &model.contacts.law(g, {0, 0, b, v}, model.n_mass()).law;
    return nullptr;
  }

  /// Law of a vertex of a block on an edge of another block, or of the ground.
  const JointLaw &
  law_on(const Model &model, const int vertex_body, const int edge_body, const int edge)
  {
    const int first = edge_body == foundation_body ? 0 : model.initial.offset[edge_body];
    return model.contacts
      .law(model.initial, {vertex_body, 0, edge_body, first + edge}, model.n_mass())
      .law;
  }

  /// Friction coefficient and cohesion of a law.
  Vec2 strength(const JointLaw &law)
  {
    const double gap = -1e-5, normal = -gap * law.normal_stiffness();
    const double cohesion = -law.respond({0., 10.}, {}).shear;
    return {(-law.respond({gap, 10.}, {}).shear - cohesion) / normal, cohesion};
  }
} // namespace



TEST(ContactLaws, belt_only_where_it_bonded_and_friction_elsewhere_on_every_bedrock)
{
  for (const char *bedrock : {"rigid", "layers", "triangles"})
    for (const bool given : {false, true})
      {
        const Model model = model_of(bedrock, given);
        for (const double x : {0.5, 1.5, 2.5, 3.5})
          {
            const JointLaw *law = law_at(model, x);
            ASSERT_NE(law, nullptr) << bedrock << ' ' << x;
            const bool belt  = x > 1. && x < 3.;
            const Vec2 found = strength(*law);
            EXPECT_NEAR(found[0],
                        tan_deg(belt    ? 12.
                                : given ? 15.
                                        : 25.),
                        1e-6)
              << bedrock << ' ' << x;
            EXPECT_NEAR(found[1], belt ? 2e4 : 0., 1e-6) << bedrock << ' ' << x;
          }
      }
}



TEST(ContactLaws, a_pair_has_the_smaller_friction_whichever_has_the_vertex)
{
  scene::SceneParameters p          = block_parameters(30.);
  p.materials["wet"]                = p.materials["rock"];
  p.materials["wet"].name           = "wet";
  p.materials["wet"].friction_angle = 20.;
  p.blocks.saturated_material       = "wet";
  p.environment.water_level         = 1.;
  const Model model    = build_model(square_blocks(1, 3), p, straight_foundation(0., 1., 2.));
  const auto  friction = [&](const int vertex_body, const int edge_body) {
    return strength(law_on(model, vertex_body, edge_body, 0))[0];
  };
  EXPECT_NEAR(friction(0, 1), tan_deg(20.), 1e-6);
  EXPECT_NEAR(friction(1, 0), tan_deg(20.), 1e-6);
  EXPECT_NEAR(friction(1, 2), tan_deg(30.), 1e-6);
  EXPECT_NEAR(friction(0, foundation_body), tan_deg(20.), 1e-6);
  EXPECT_NEAR(friction(2, foundation_body), tan_deg(30.), 1e-6);
}



TEST(ContactLaws, regions_of_the_mass_bring_their_materials)
{
  scene::SceneParameters p = block_parameters(30.);
  p.materials["soil"]      = p.materials["rock"];
  Material &soil           = p.materials["soil"];
  soil.name                = "soil";
  soil.friction_angle      = 20.;
  soil.density             = 1800.;
  soil.young_modulus       = 10e6;
  p.blocks.bonded          = true;
  p.blocks.material = scene::RegionMaterials::parse("sliding_mass: rock; sliding_mass_top: soil");
  scene::SectionMesh mesh = square_blocks(1, 3);
  mesh.block_region       = {0, 0, 1};
  mesh.block_region_names = {"sliding_mass", "sliding_mass_top"};
  const Model model       = build_model(mesh, p, straight_foundation(0., 1., 2.));
  EXPECT_NEAR(model.blocks[1].mass, 2220., 1e-9);
  EXPECT_NEAR(model.blocks[2].mass, 1800., 1e-9);
  const auto friction = [&](const int vertex_body, const int edge_body) {
    return strength(law_on(model, vertex_body, edge_body, 0))[0];
  };
  EXPECT_NEAR(friction(0, 1), tan_deg(30.), 1e-6);
  EXPECT_NEAR(friction(1, 2), tan_deg(20.), 1e-6);
  EXPECT_NEAR(friction(2, 1), tan_deg(20.), 1e-6);
  ASSERT_EQ(model.joints.size(), 2u);
  EXPECT_NEAR(strength(model.joints[0].law)[0], tan_deg(30.), 1e-6);
  EXPECT_NEAR(strength(model.joints[1].law)[0], tan_deg(20.), 1e-6);
  EXPECT_NEAR(model.joints[1].law.normal_stiffness() / model.joints[0].law.normal_stiffness(),
              0.2,
              1e-12); // of the softer side
}



// Three squares on each other: the lower joint is of clay, and so is the right side of the upper
// block.
TEST(ContactLaws, joints_of_the_mass_bring_their_material_to_their_edges)
{
  scene::SceneParameters p     = block_parameters(30.);
  p.materials["rock"].cohesion = p.materials["rock"].residual_cohesion = 1e6;
  p.materials["clay"]                                                  = p.materials["rock"];
  p.materials["clay"].name                                             = "clay";
  p.materials["clay"].friction_angle                                   = 40.;
  p.materials["clay"].cohesion = p.materials["clay"].residual_cohesion = 2e4;
  p.materials["wet"]                                                   = p.materials["clay"];
  p.materials["wet"].name                                              = "wet";
  p.materials["wet"].friction_angle                                    = 10.;
  p.blocks.bonded                                                      = true;
  p.blocks.joint_materials           = scene::RegionMaterials::parse("joint_a: clay");
  p.blocks.saturated_joint_materials = "wet";
  scene::SectionMesh mesh            = square_blocks(1, 3);
  mesh.lines["joint_a"]              = {{3, 2}, {5, 7}};
  mesh.lines["joint_b"]              = {{4, 5}}; // has no material
  for (const bool is_wet : {false, true})
    {
      p.environment.water_level = is_wet ? 1.5 : -1.;
      const Model  model        = build_model(mesh, p, straight_foundation(0., 1., 2.));
      const double angle        = is_wet ? 10. : 40.;
      ASSERT_EQ(model.joints.size(), 2u);
      EXPECT_NEAR(strength(model.joints[0].law)[0], tan_deg(angle), 1e-6);
      EXPECT_NEAR(strength(model.joints[0].law)[1], 2e4, 1e-6);
      EXPECT_NEAR(strength(model.joints[1].law)[0], tan_deg(30.), 1e-6);
      EXPECT_NEAR(strength(model.joints[1].law)[1], 1e6, 1e-3);
      EXPECT_NEAR(strength(law_on(model, 0, 1, 0))[0],
                  tan_deg(angle),
                  1e-6); // bottom of the middle
      EXPECT_NEAR(strength(law_on(model, 1, 0, 2))[0], tan_deg(angle), 1e-6); // top of the lowest
      EXPECT_NEAR(strength(law_on(model, 2, 0, 2))[0],
                  tan_deg(angle),
                  1e-6); // whatever block slides there
      EXPECT_NEAR(strength(law_on(model, 0, 2, 1))[0], tan_deg(40.), 1e-6); // above the water
      EXPECT_NEAR(strength(law_on(model, 1, 2, 0))[0], tan_deg(30.), 1e-6);
      EXPECT_NEAR(strength(law_on(model, 0, 1, 1))[0], tan_deg(30.), 1e-6);
      EXPECT_NEAR(strength(law_on(model, 1, foundation_body, 0))[0], tan_deg(30.), 1e-6);
    }
}



TEST(ContactLaws, residual_cohesion_needs_a_joint_between_the_two_blocks)
{
  scene::SceneParameters p = block_parameters(30.);
  EXPECT_FALSE(build_model(square_blocks(1, 2), p, {}).contacts.were_bonded(0, 1));
  p.blocks.bonded   = true;
  const Model model = build_model(square_blocks(1, 3), p, {});
  EXPECT_TRUE(model.contacts.were_bonded(1, 0));
  EXPECT_TRUE(model.contacts.were_bonded(1, 2));
  EXPECT_FALSE(model.contacts.were_bonded(0, 2));
}



TEST(BondedArea, an_end_that_has_opened_or_left_the_belt_is_lost_for_good)
{
  Model    model = model_of("rigid", false);
  DdaState state = initial_state(model);
  int      j     = 0; // the belt's joint of x = 1..2
  while (model.joints[j].kind != JointKind::belt || model.joints[j].points[0].other_vertex != 1)
    ++j;
  BeltParting  parting;
  BondedArea   area;
  const Joint &belt  = model.joints[j];
  const int    block = belt.block;
  const auto   place = [&](const Vec2 &moved, const double lifted_end) {
    for (int v = state.geometry.offset[block]; v < state.geometry.offset[block + 1]; ++v)
      state.geometry.vertices[v] = model.initial.vertices[v] + moved;
    state.geometry.vertices[state.geometry.next(belt.edge)].y() += lifted_end;
    parting.update(model, state);
    area.update(model, state);
    return area.edges[belt.edge];
  };
  EXPECT_EQ(place({0., 0.}, 0.), 0) << "not released: the joint bears its cohesion itself";
  state.joints[j].released = true;
  EXPECT_EQ(place({0.3, -1e-3}, 0.), BondedArea::both) << "slides along the belt";
  const double opens = belt.law.parting_opening();
  EXPECT_EQ(place({0.3, 0.}, 0.5 * opens), BondedArea::both);
  EXPECT_EQ(place({0.3, 0.}, 2. * opens), BondedArea::first);
  EXPECT_EQ(place({0.3, 0.}, 0.), BondedArea::first) << "closed again";
  EXPECT_EQ(place({-0.3, 0.}, 0.), 0) << "hangs over the end of the belt";
  EXPECT_EQ(place({0., 0.}, 0.), 0);
  EXPECT_EQ(area.segments, (std::vector<char>{0, BondedArea::both, BondedArea::both, 0, 0}));
}
