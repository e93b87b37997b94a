// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/option_registry.h>
#include <hybrid/scene/parameters/bedrock_model.h>

#include <gtest/gtest.h>

namespace hybrid::scene::test
{
  // The recipe of the developer guide is followed in tests/support/bedrock_section.h: another
  // bedrock is cut, joined and bears a mass at rest.
  TEST(BedrockModel, NamesAreDifferent)
  {
    for (const BedrockModel &bedrock : bedrock_models())
      EXPECT_EQ(find_option(bedrock.name, bedrock_models()), &bedrock);
  }



  TEST(BedrockModel, SidesThatItCanHaveAreNamed)
  {
    const auto sides = [](const std::string &name) {
      const BedrockModel &bedrock = *find_option(name, bedrock_models());
      return names_in_words(side_boundaries(),
                            [&](const SideBoundary &side) { return bedrock.can_have(side); });
    };
    EXPECT_EQ(sides("continuum"), "viscous, free field, roller or fixed");
    EXPECT_EQ(sides("layers"), "viscous");
    EXPECT_EQ(sides("triangles"), "viscous or free field");
  }



  TEST(BedrockModel, ItIsElementsOrBlocksOrNeither)
  {
    for (const BedrockModel &bedrock : bedrock_models())
      {
        EXPECT_FALSE(bedrock.is_elements && bedrock.cut != nullptr) << bedrock.name;
        EXPECT_EQ(bedrock.has_cells(), bedrock.name != "rigid");
      }
  }
} // namespace hybrid::scene::test
