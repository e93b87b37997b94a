// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/cell_materials.h>

namespace
{
  using namespace hybrid;
  using continuum::CellMaterials;

  Material named(const std::string &name)
  {
    Material material;
    material.name = name;
    return material;
  }
} // namespace



TEST(CellMaterials, a_cell_has_that_of_its_kind)
{
  const CellMaterials of({named("rock"), named("soft")}, {1, 0, 0, 1, 1});
  ASSERT_EQ(of.size(), 5u);
  for (const std::size_t cell : {1, 2})
    EXPECT_EQ(of[cell].name, "rock");
  for (const std::size_t cell : {0, 3, 4})
    EXPECT_EQ(of[cell].name, "soft");
  EXPECT_EQ(&of[3], &of[4]);
}



TEST(CellMaterials, cells_may_have_their_own)
{
  const CellMaterials of = std::vector<Material>{named("a"), named("b")};
  ASSERT_EQ(of.size(), 2u);
  EXPECT_EQ(of[0].name, "a");
  EXPECT_EQ(of[1].name, "b");
}
