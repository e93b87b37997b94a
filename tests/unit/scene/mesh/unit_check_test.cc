// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/mesh/unit_check.h>

#include "rigid_scene.h"
#include "temporary_files.h"

namespace hybrid::scene::test
{
  namespace
  {
    /// A bedrock of 2 x 1 and a triangular block of half the unit area, times @p scale [m].
    SectionMesh section(const double scale)
    {
      SectionMesh mesh;
      mesh.nodes         = {{0., 0.}, {2., 0.}, {2., 1.}, {0., 1.}, {0., 2.}};
      mesh.bedrock_cells = {{0, 1, 2, 3}};
      mesh.blocks        = {{3, 2, 4}};
      for (Vec2 &x : mesh.nodes)
        x *= scale;
      return mesh;
    }


    std::string error_of(const SectionMesh &mesh, const SceneParameters &scene = {})
    {
      return message_of([&]() { check_unit(mesh, scene); });
    }
  } // namespace


  TEST(UnitCheck, SlopesInMetresPassWithoutAWarning)
  {
    for (const double size : {3., 90.})
      {
        EXPECT_NO_THROW(check_unit(section(size), {}));
        EXPECT_TRUE(unit_warnings(section(size), {}).empty());
      }
  }


  TEST(UnitCheck, MillimetresAreRefusedOrDoubted)
  {
    EXPECT_EQ(error_of(section(150e3)),
              "The section from (0, 0) to (300000, 300000) m is 300 km large; at most 30 km are "
              "allowed; coordinates are read as metres: if they are millimetres, multiply them by "
              "0.001 (300 m).");
    EXPECT_NO_THROW(check_unit(section(3e3), {})); // 6 m
    const auto warnings = unit_warnings(section(3e3), {});
    ASSERT_EQ(warnings.size(), 2u);
    expect_part(warnings[0], "is 6 km large, more than 5 km");
    expect_part(warnings[0], "if they are millimetres, multiply them by 0.001 (6 m)");
    expect_part(warnings[1], "the block at (0, 3000) m is 3 km large, more than 100 m");
  }


  TEST(UnitCheck, KilometresAreRefusedOrDoubtedWhereWavesRun)
  {
    EXPECT_EQ(error_of(section(0.15)),
              "The section from (0, 0) to (0.3, 0.3) m is 0.3 m large; at least 0.5 m are needed "
              "where the ground shakes; coordinates are read as metres: if they are kilometres, "
              "multiply them by 1000 (300 m).");
    EXPECT_NO_THROW(check_unit(section(0.15), rigid_scene())); // blocks in a laboratory
    const auto warnings = unit_warnings(section(1.), {});
    ASSERT_EQ(warnings.size(), 1u);
    expect_part(warnings[0], "is 2 m large, less than 5 m");
    EXPECT_TRUE(unit_warnings(section(1.), rigid_scene()).empty());
    EXPECT_EQ(unit_warnings(section(0.04), rigid_scene()).size(), 1u);
  }


  TEST(UnitCheck, StrengthsInKilopascalAreDoubtedWhereBlocksHaveMetres)
  {
    SceneParameters scene;
    scene.blocks.material              = "clay";
    scene.blocks.belt_material         = "belt";
    scene.materials["clay"].density    = 2000.;
    scene.materials["clay"].cohesion   = 80.;
    scene.materials["belt"].cohesion   = 50e3;
    scene.materials["unused"].cohesion = 80.;
    auto warnings                      = unit_warnings(section(3.), scene); // blocks of 3 m
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(
      warnings[0],
      "Materials/clay/Cohesion = 80 Pa is doubtful with blocks of 3 m: it carries the weight "
      "of 4.08 mm of them; if it was meant in kPa, give 80000");
    scene.materials["clay"].cohesion         = 1000.;
    scene.materials["belt"].tensile_strength = 999.;
    warnings                                 = unit_warnings(section(3.), scene);
    ASSERT_EQ(warnings.size(), 1u);
    expect_part(warnings[0], "Materials/belt/Tensile strength = 999 Pa");
    SceneParameters small = scene;
    EXPECT_TRUE(unit_warnings(section(0.9), rigid_scene()).empty());
    small.bedrock = rigid_bedrock();
    EXPECT_TRUE(unit_warnings(section(0.9), small).empty()); // a model in the laboratory
  }
} // namespace hybrid::scene::test
