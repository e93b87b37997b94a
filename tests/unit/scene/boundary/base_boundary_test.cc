// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/boundary/base_boundary.h>
#include <hybrid/scene/parameters/parameter_section.h>

#include <gtest/gtest.h>

namespace hybrid::scene::test
{
  namespace
  {
    /// The recipe of the developer guide: waves leave, no motion comes in.
    BaseBoundary quiet_base()
    {
      BaseBoundary base{"quiet", "base that waves leave through"};
      base.is_compliant = true;
      return base;
    }
  } // namespace



  TEST(BaseBoundary, AnotherOneIsAFileAndALine)
  {
    std::vector<BaseBoundary> bases = base_boundaries();
    bases.push_back(quiet_base());
    BaseBoundary     base = bases.front();
    ParameterTable   table("test");
    ParameterSection section(table, {"Continuum"});
    section.option("Base", base, bases, "Base of the bedrock.");
    table.set(parse_override("Continuum/Base=quiet"));
    table.assign();
    EXPECT_EQ(base.words, "base that waves leave through");
    EXPECT_TRUE(base.is_compliant && !base.takes_motion && !base.moves());
  }



  TEST(BaseBoundary, NamesAreDifferent)
  {
    for (const BaseBoundary &base : base_boundaries())
      EXPECT_EQ(find_option(base.name, base_boundaries()), &base);
  }



  TEST(BaseBoundary, OnlyARigidOneMovesAsPrescribed)
  {
    for (const BaseBoundary &base : base_boundaries())
      EXPECT_EQ(base.moves(), base.name == "rigid") << base.name;
  }
} // namespace hybrid::scene::test
