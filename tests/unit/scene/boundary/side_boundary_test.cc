// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/boundary/side_boundary.h>
#include <hybrid/scene/parameters/parameter_section.h>

#include <gtest/gtest.h>

namespace hybrid::scene::test
{
  namespace
  {
    /// The recipe of the developer guide: sides that hold one direction and absorb in the other.
    SideBoundary normal_dashpots_side()
    {
      SideBoundary side{"normal dashpots", "dashpots along the normal"};
      side.holds_y         = true;
      side.normal_dashpots = 0.8;
      return side;
    }


    /// Continuum/Sides = @p name, of these options.
    SideBoundary read(const std::string &name, const std::vector<SideBoundary> &sides)
    {
      SideBoundary     side = sides.front();
      ParameterTable   table("test");
      ParameterSection section(table, {"Continuum"});
      section.option("Sides", side, sides, "Left and right side.");
      table.set(parse_override("Continuum/Sides=" + name));
      table.assign();
      return side;
    }
  } // namespace



  TEST(SideBoundary, AnotherOneIsAFileAndALine)
  {
    std::vector<SideBoundary> sides = side_boundaries();
    sides.push_back(normal_dashpots_side());
    const SideBoundary side = read("normal dashpots", sides);
    EXPECT_EQ(side.words, "dashpots along the normal");
    EXPECT_TRUE(side.is_held() && side.has_dashpots() && !side.has_free_field);
    try
      {
        read("normal dashpots", side_boundaries());
        FAIL() << "the program has no such side";
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("viscous | free field | roller | fixed"),
                  std::string::npos)
          << error.what();
      }
  }



  TEST(SideBoundary, NamesAreDifferent)
  {
    for (const SideBoundary &side : side_boundaries())
      EXPECT_EQ(find_option(side.name, side_boundaries()), &side);
    EXPECT_EQ(find_option(std::string("periodic"), side_boundaries()), nullptr);
  }



  TEST(SideBoundary, ItHoldsOrAbsorbs)
  {
    for (const SideBoundary &side : side_boundaries())
      EXPECT_NE(side.is_held(), side.has_dashpots()) << side.name;
  }
} // namespace hybrid::scene::test
