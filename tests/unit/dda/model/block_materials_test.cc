// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/block_materials.h>

#include <gtest/gtest.h>

namespace hybrid::dda
{
  namespace
  {
    struct TwoRegions
    {
      scene::SectionMesh     mesh;
      scene::SceneParameters scene;
      BlockMaterials         material{mesh, scene};

      TwoRegions()
      {
        mesh.block_region_names = {"sliding_mass", "sliding_mass_debris"};
        add("rock", 40., 5e6, 1e6);
        add("soil", 20., 1e4, 0.);
        add("wet_soil", 15., 2e7, 0.);
        scene.blocks.material =
          scene::RegionMaterials::parse("sliding_mass: rock; sliding_mass_debris: soil");
        scene.blocks.saturated_material =
          scene::RegionMaterials::parse("sliding_mass_debris: wet_soil");
      }

      void
      add(const std::string &name, const double angle, const double cohesion, const double tension)
      {
        Material &m        = scene.materials[name];
        m.name             = name;
        m.friction_angle   = angle;
        m.cohesion         = cohesion;
        m.tensile_strength = tension;
      }
    };


    TEST(BlockMaterials, OfARegionAboveAndBelowTheWater)
    {
      const TwoRegions two;
      EXPECT_EQ(two.material.mass(0, false).name, "rock");
      EXPECT_EQ(two.material.mass(1, false).name, "soil");
      EXPECT_EQ(two.material.mass(0, true).name, "rock"); // has no saturated one
      EXPECT_EQ(two.material.mass(1, true).name, "wet_soil");
    }


    TEST(BlockMaterials, BondWithinARegionIsOfItsMaterial)
    {
      const TwoRegions two;
      EXPECT_EQ(two.material.bond(0, 0, false).cohesion, 5e6);
      EXPECT_EQ(two.material.bond(1, 1, true).cohesion, 2e7);
    }


    TEST(BlockMaterials, BondBetweenTwoHasTheSmallerOfEachStrength)
    {
      TwoRegions two;
      two.scene.materials["rock"].residual_friction_angle = 10.;
      for (const auto &[a, b] : {std::pair(0, 1), std::pair(1, 0)})
        {
          const Material bond = two.material.bond(a, b, true);
          EXPECT_EQ(bond.friction_angle, 15.);          // of the wet soil
          EXPECT_EQ(bond.cohesion, 5e6);                // of the rock
          EXPECT_EQ(bond.tensile_strength, 0.);         // of the wet soil
          EXPECT_EQ(bond.residual_friction_angle, 10.); // of the rock
        }
    }
  } // namespace
} // namespace hybrid::dda
