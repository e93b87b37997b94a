// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/locked_foot.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// A slope of 30 degrees from (-10, 0) to its foot at x = 0, the ground beyond, and a wedge
    /// above the lowest 6 m along x.
    class LockedFoot : public testing::Test
    {
    protected:
      SectionMesh  mesh;
      const double rise = std::tan(M_PI / 6.);

      void SetUp() override
      {
        mesh.nodes                    = {{-10., 10. * rise}, {-6., 6. * rise}, {0., 0.}, {8., 0.}};
        mesh.lines["sliding_surface"] = {{1, 0}, {1, 2}};
        mesh.lines["ground"]          = {{2, 3}};
        add_block({{-6., 6. * rise}, {0., 0.}, {-6., 12. * rise}});
      }

      void add_block(const std::vector<Vec2> &vertices)
      {
        std::vector<int> block;
        for (const Vec2 &x : vertices)
          {
            block.push_back(static_cast<int>(mesh.nodes.size()));
            mesh.nodes.push_back(x);
          }
        mesh.blocks.push_back(block);
      }

      /// Either way: the text hangs neither on the direction nor on where the section lies.
      bool is_told(const std::string &words)
      {
        const bool found = locked_foot(mesh).find(words) != std::string::npos;
        for (Vec2 &x : mesh.nodes)
          x.x() = -x.x();
        for (auto &block : mesh.blocks)
          std::reverse(block.begin(), block.end());
        EXPECT_EQ(locked_foot(mesh).find(words) != std::string::npos, found);
        return found;
      }
    };
  } // namespace


  TEST_F(LockedFoot, AMassThatEndsOnLevelGroundIsTold)
  {
    EXPECT_TRUE(is_told("the mass ends at (0, 0) m on ground that falls by 30 degrees less"));
  }


  TEST_F(LockedFoot, GroundThatGoesOnAsSteepOrBendsByLittleIsNot)
  {
    mesh.nodes[3] = {8., -8. * std::tan(28. * M_PI / 180.)};
    EXPECT_TRUE(locked_foot(mesh).empty());
    mesh.nodes[3] = {8., -8. * std::tan(26. * M_PI / 180.)};
    EXPECT_TRUE(is_told("by 4 degrees less"));
  }


  TEST_F(LockedFoot, AMassThatEndsAboveTheFootIsNot)
  {
    for (std::size_t n = 4; n < mesh.nodes.size(); ++n)
      mesh.nodes[n] += Vec2(-2., 2. * rise);
    EXPECT_TRUE(locked_foot(mesh).empty());
  }


  TEST_F(LockedFoot, AMassThatLiesOnTheGroundBeyondIsNot)
  {
    add_block({{0., 0.}, {3., 0.}, {-6., 12. * rise}});
    EXPECT_TRUE(locked_foot(mesh).empty());
  }


  TEST_F(LockedFoot, AWallIsMeantToHold)
  {
    mesh.nodes[3] = {1., 8.};
    EXPECT_TRUE(locked_foot(mesh).empty());
  }
} // namespace hybrid::scene
