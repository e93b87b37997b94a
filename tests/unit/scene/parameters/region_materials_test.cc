// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/region_materials.h>

#include <gtest/gtest.h>

namespace hybrid::scene
{
  namespace
  {
    using Names = std::vector<std::string>;


    TEST(RegionMaterials, OneNameIsThatOfEveryRegion)
    {
      const RegionMaterials rock = RegionMaterials::parse("rock");
      EXPECT_EQ(rock.of("sliding_mass"), "rock");
      EXPECT_EQ(rock.of("sliding_mass_debris"), "rock");
      EXPECT_EQ(rock.names(), Names{"rock"});
      EXPECT_TRUE(rock.regions().empty());
    }


    TEST(RegionMaterials, EachRegionHasItsOwn)
    {
      const RegionMaterials two = RegionMaterials::parse(
        "sliding_mass_debris: soil; sliding_mass: rock; sliding_mass_b: rock");
      EXPECT_EQ(two.of("sliding_mass"), "rock");
      EXPECT_EQ(two.of("sliding_mass_debris"), "soil");
      EXPECT_EQ(two.of("sliding_mass_c"), "");
      EXPECT_EQ(two.names(), (Names{"rock", "soil"}));
      EXPECT_EQ(two.regions(), (Names{"sliding_mass", "sliding_mass_b", "sliding_mass_debris"}));
      EXPECT_EQ(two.in_words(), "rock, soil");
    }


    TEST(RegionMaterials, AStarIsEveryOtherRegion)
    {
      const RegionMaterials others = RegionMaterials::parse("*: rock; sliding_mass_debris: soil");
      EXPECT_EQ(others.of("sliding_mass"), "rock");
      EXPECT_EQ(others.of("sliding_mass_debris"), "soil");
      EXPECT_EQ(others.regions(), Names{"sliding_mass_debris"});
    }


    TEST(RegionMaterials, NoneIsEmpty)
    {
      EXPECT_TRUE(RegionMaterials::parse("").empty());
      EXPECT_EQ(RegionMaterials().of("sliding_mass"), "");
    }


    TEST(RegionMaterials, ARegionStandsOnce)
    {
      EXPECT_THROW(RegionMaterials::parse("a: rock; a: soil"), InputError);
      EXPECT_THROW(RegionMaterials::parse("a: rock; b"), InputError);
    }
  } // namespace
} // namespace hybrid::scene
