// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_files.h"

#include <hybrid/scene/linear_table.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::scene;

  const ColumnRange x_range = {"x [m]", 1e9};
  const ColumnRange y_range = {"y [m]", 1e5};

  class LinearTableTest : public scene::test::SceneFiles
  {
  protected:
    LinearTable read(const std::string &text) const
    {
      write("table.csv", text);
      return read_linear_table(path("table.csv"), x_range, y_range);
    }

    /// The message for @p text has all @p parts.
    void expect_refused(const std::string &text, const std::vector<std::string> &parts) const
    {
      try
        {
          read(text);
          ADD_FAILURE() << "accepted: " << text;
        }
      catch (const InputError &error)
        {
          for (const std::string &part : parts)
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
              << part << " is not in: " << error.what();
        }
    }
  };
} // namespace



TEST_F(LinearTableTest, IsLinearBetweenItsPointsAndConstantBeyond)
{
  const LinearTable table = {{{-1., 2.}, {1., 6.}, {5., 4.}}};
  EXPECT_EQ(table(-9.), 2.);
  EXPECT_EQ(table(-1.), 2.);
  EXPECT_EQ(table(0.), 4.);
  EXPECT_EQ(table(1.), 6.);
  EXPECT_EQ(table(3.), 5.);
  EXPECT_EQ(table(5.), 4.);
  EXPECT_EQ(table(9.), 4.);
  EXPECT_EQ(table.lowest(), 2.);
  EXPECT_EQ(table.highest(), 6.);
  EXPECT_EQ(table.highest_between(-9., 9.), 6.);
  EXPECT_EQ(table.highest_between(3., 9.), 5.);
  EXPECT_EQ(table.highest_between(-9., 0.), 4.);
  EXPECT_EQ(table.highest_between(7., 9.), 4.);
  EXPECT_EQ(LinearTable({{{3., 7.}}})(0.), 7.);
}



TEST_F(LinearTableTest, IsReadFromAFileWithOrWithoutHeadings)
{
  EXPECT_EQ(read("# a line\nx,y\n0,1\n2,3\n")(1.), 2.);
  EXPECT_EQ(read("0 1\n2 3\n")(1.), 2.);
  EXPECT_EQ(read("7;8\n").points.size(), 1u);
}



TEST_F(LinearTableTest, NonsenseIsRefusedWithFileAndLine)
{
  expect_refused("x,y\n", {"table.csv", "no row", "x [m]", "y [m]"});
  expect_refused("0,1\n0,2\n", {"table.csv:2", "x [m] = 0", "must rise"});
  expect_refused("0,1\n1\n", {"table.csv:2", "found 1 column", "x [m] and y [m]"});
  expect_refused("0,1\n1,high\n", {"table.csv:2", "high"});
  expect_refused("0,1e6\n", {"table.csv:1", "y [m] = 1e6", "between -100000 and 100000"});
}
