// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/overburden.h>

#include <gtest/gtest.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  constexpr double g = 10., rock = 2500., soil = 2000., water = 1000.; // [m/s2], [kg/m3]

  /// Rock from y = 0 to 4 for x from 0 to 4, its right half to 2 only; blocks on the left half from
  /// 4 to 5 and, above a gap of 1 m, from 6 to 8; one on the right half whose top falls from 4
  /// to 2.
  SectionMesh section()
  {
    SectionMesh mesh;
    mesh.nodes                = {{0, 0},
                                 {2, 0},
                                 {4, 0},
                                 {0, 2},
                                 {2, 2},
                                 {4, 2},
                                 {0, 4},
                                 {2, 4},
                                 {0, 5},
                                 {2, 5},
                                 {0, 6},
                                 {2, 6},
                                 {0, 8},
                                 {2, 8}};
    mesh.bedrock_cells        = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}};
    mesh.bedrock_region       = {0, 0, 0};
    mesh.bedrock_region_names = {"bedrock"};
    mesh.blocks               = {{6, 7, 9, 8}, {10, 11, 13, 12}, {4, 5, 7}};
    mesh.block_region         = {0, 0, 0};
    mesh.block_region_names   = {"sliding_mass"};
    return mesh;
  }

  SceneParameters parameters()
  {
    SceneParameters scene;
    scene.materials["rock"].density      = rock;
    scene.materials["soil"].density      = soil;
    scene.continuum.region_material["*"] = "rock";
    scene.blocks.material                = "soil";
    scene.environment.gravity            = g;
    return scene;
  }
} // namespace



TEST(Overburden, is_the_weight_of_what_stands_straight_above)
{
  const Overburden above(section(), parameters());
  EXPECT_NEAR(above.in_mass({1., 7.}, {1., 7.}), g * soil, 1e-9);
  EXPECT_NEAR(above.in_mass({1., 4.}, {1., 4.5}), 3. * g * soil, 1e-9); // the gap weighs nothing
  EXPECT_NEAR(above.in_bedrock({1., 1.}, {1., 1.}), g * (3. * rock + 3. * soil), 1e-9);
  EXPECT_NEAR(above.in_bedrock({3., 2.}, {3., 1.}), g * soil, 1e-9); // below a slope

  SectionMesh     regions = section(); // the upper square is of rock
  SceneParameters scene   = parameters();
  regions.block_region    = {0, 1, 0};
  regions.block_region_names.push_back("sliding_mass_cap");
  scene.blocks.material = RegionMaterials::parse("sliding_mass: soil; sliding_mass_cap: rock");
  EXPECT_NEAR(Overburden(regions, scene).in_mass({1., 4.}, {1., 4.5}),
              g * (soil + 2. * rock),
              1e-9);
  EXPECT_EQ(above.in_mass({1., 9.}, {1., 7.}), 0.);
}



TEST(Overburden, of_a_place_on_an_outline_is_that_of_the_body)
{
  const Overburden above(section(), parameters());
  // x = 2 is where rock and mass are higher on the left.
  EXPECT_NEAR(above.in_bedrock({2., 1.}, {1., 1.}), g * (3. * rock + 3. * soil), 1e-9);
  EXPECT_NEAR(above.in_bedrock({2., 1.}, {3., 1.}), g * (rock + 2. * soil), 0.1);
  EXPECT_NEAR(above.in_mass({2., 3.}, {3., 3.}), g * soil, 0.1);
}



TEST(Overburden, weighs_less_below_a_phreatic_line)
{
  SceneParameters scene                      = parameters();
  scene.environment.water_method             = WaterMethod::pressures;
  scene.environment.water_tables.line.points = {{0., 6.}, {2., 8.}}; // 7 m at x = 1
  const Overburden line(section(), scene);
  EXPECT_NEAR(line.in_mass({1., 6.5}, {1., 7.}), g * (1.5 * soil - 0.5 * water), 1e-4);
  EXPECT_NEAR(line.in_mass({0.5, 6.}, {0.5, 6.5}), g * (2. * soil - 0.5 * water), 1e-4);
  scene.environment.water_level = 7.5; // the higher one counts
  const Overburden both(section(), scene);
  EXPECT_NEAR(both.in_mass({1., 6.5}, {1., 7.}), g * (1.5 * soil - water), 1e-4);
}



TEST(Overburden, weighs_less_below_the_water)
{
  SceneParameters scene           = parameters();
  scene.environment.water_level   = 7.;
  scene.environment.water_density = water;
  EXPECT_NEAR(Overburden(section(), scene).in_mass({1., 4.}, {1., 4.5}), 3. * g * soil, 1e-9);
  scene.environment.water_method = WaterMethod::submerged;
  const Overburden buoyant(section(), scene);
  EXPECT_NEAR(buoyant.in_mass({1., 6.5}, {1., 7.}), g * (1.5 * soil - 0.5 * water), 1e-9);
  EXPECT_NEAR(buoyant.in_bedrock({1., 2.}, {1., 1.}),
              g * (2. * rock + 3. * soil - 2. * water),
              1e-9);
  // The rock bears the water above it, too.
  scene.environment.water_method = WaterMethod::pressures;
  const Overburden pressed(section(), scene);
  EXPECT_NEAR(pressed.in_mass({1., 6.5}, {1., 7.}), g * (1.5 * soil - 0.5 * water), 1e-9);
  EXPECT_NEAR(pressed.in_bedrock({1., 2.}, {1., 1.}),
              g * (2. * rock + 3. * soil - 2. * water + 3. * water),
              1e-9);
}



TEST(Overburden, saturated_blocks_have_their_material)
{
  SceneParameters scene           = parameters();
  scene.materials["wet"].density  = 2300.;
  scene.blocks.saturated_material = "wet";
  scene.environment.water_level   = 5.5; // centroids of the lower blocks are below it
  const Overburden above(section(), scene);
  EXPECT_NEAR(above.in_mass({1., 4.}, {1., 4.5}), g * (2. * soil + 2300.), 1e-9);
}
