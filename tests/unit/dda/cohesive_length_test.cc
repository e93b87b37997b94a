// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/cohesive_length.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double degree = M_PI / 180.;

  /// Lengths of the contacts that a search finds between two bodies.
  struct Lengths
  {
    int    n     = 0;
    double total = 0., largest = 0.; // m

    Lengths(const scene::SectionMesh &mesh,
            const std::vector<Vec2>  &base,
            const int                 first,
            const int                 second)
    {
      FixedBaseRun run(mesh, block_parameters(30.), base);
      run.solver.solve(run.state, run.base, 1e-4);
      for (const Contact &c : run.state.contacts)
        if (std::minmax(c.vertex_body, c.edge_body) == std::minmax(first, second))
          {
            const double length = cohesive_length(run.state.geometry, run.state.contacts, c);
            ++n;
            total += length;
            largest = std::max(largest, length);
          }
    }
  };



  scene::SectionMesh one_block(const std::vector<Vec2> &outline)
  {
    scene::SectionMesh mesh;
    mesh.nodes = outline;
    mesh.blocks.emplace_back();
    for (std::size_t k = 0; k < outline.size(); ++k)
      mesh.blocks.back().push_back(static_cast<int>(k));
    mesh.block_region       = {0};
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }



  /// Squares of 1 m with their lower left corners at the given places, which share no nodes.
  scene::SectionMesh squares(const std::vector<Vec2> &corners)
  {
    scene::SectionMesh mesh;
    for (const Vec2 &corner : corners)
      {
        const int n = static_cast<int>(mesh.nodes.size());
        for (const Vec2 &step : {Vec2(0., 0.), Vec2(1., 0.), Vec2(1., 1.), Vec2(0., 1.)})
          mesh.nodes.push_back(corner + step);
        mesh.blocks.push_back({n, n + 1, n + 2, n + 3});
        mesh.block_region.push_back(0);
      }
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }
} // namespace



TEST(CohesiveLength, is_half_of_the_edge_at_each_end_whatever_the_block)
{
  for (const int pieces : {1, 3, 50})
    for (const double angle : {0., 35. * degree})
      for (const double size : {0.2, 1., 3.})
        {
          const Lengths l(square_blocks(1, 1, size, angle),
                          straight_base(angle, 1.3, 7., pieces),
                          base_body,
                          0);
          EXPECT_EQ(l.n, 2);
          EXPECT_NEAR(l.total, size, 1e-12);
          EXPECT_NEAR(l.largest, 0.5 * size, 1e-12);
        }
  for (const double height : {0.2, 1., 3.})
    {
      const Lengths l(one_block({{0., 0.}, {2., 0.}, {0.7, height}}),
                      straight_base(0., 1.3, 7., 9),
                      base_body,
                      0);
      EXPECT_EQ(l.n, 2) << height;
      EXPECT_NEAR(l.total, 2., 1e-12) << height;
    }
}



TEST(CohesiveLength, a_corner_alone_has_none)
{
  for (const double tilt : {5., 30., 45.})
    {
      const Lengths l(square_blocks(1, 1, 1., tilt * degree),
                      straight_base(0., 5., 5.),
                      base_body,
                      0);
      EXPECT_GE(l.n, 1) << tilt;
      EXPECT_EQ(l.total, 0.) << tilt;
    }
  const Lengths nearly(square_blocks(1, 1, 1., 2. * degree),
                       straight_base(0., 5., 5.),
                       base_body,
                       0);
  EXPECT_EQ(nearly.n, 2);
  EXPECT_NEAR(nearly.total, 1., 1e-3); // projected
}



TEST(CohesiveLength, blocks_on_blocks_have_their_overlap)
{
  const std::vector<Vec2> base = straight_base(0., 5., 5.);
  for (const double shift : {0.4, -0.7, 1e-9, 0.})
    {
      const Lengths l(squares({{0., 0.}, {shift, 1.}}), base, 0, 1);
      EXPECT_NEAR(l.total, 1. - std::abs(shift), 1e-8) << shift << ", contacts " << l.n;
    }
  // over the seam of a row
  const scene::SectionMesh row = squares({{0., 0.}, {1., 0.}, {0.4, 1.}});
  EXPECT_NEAR(Lengths(row, base, 0, 2).total, 0.6, 1e-9);
  EXPECT_NEAR(Lengths(row, base, 1, 2).total, 0.4, 1e-9);
}



TEST(CohesiveLength, gentle_bends_of_the_base_divide_or_belong_to_the_edge)
{
  for (const double bend : {-2., -0.5, 0.5, 2.}) // positive: a ridge below the block [deg]
    {
      const double      dip = std::tan(0.5 * bend * degree);
      std::vector<Vec2> base{{-5., -5.3 * dip}, {0.3, 0.}, {5., -4.7 * dip}};
      if (bend < 0.) // its ends touch
        for (Vec2 &node : base)
          node.y() += 0.3 * dip;
      const Lengths l(square_blocks(1, 1), base, base_body, 0);
      EXPECT_EQ(l.n, bend > 0. ? 3 : 2) << bend;
      EXPECT_NEAR(l.total, 1., 1e-3) << bend;
    }
}



TEST(CohesiveLength, what_hangs_over_the_end_of_an_edge_does_not_count)
{
  // On the end of the base, which is no corner, one half is left of what touches.
  const Lengths end(square_blocks(1, 1), straight_base(0., 5., 0.4), base_body, 0);
  EXPECT_EQ(end.n, 1);
  EXPECT_NEAR(end.total, 0.2, 1e-12);
  // On a ridge of the base that is no seam, its node has the other half.
  const Lengths edge(square_blocks(1, 1), {{-5., 0.}, {0.4, 0.}, {5., -4.}}, base_body, 0);
  EXPECT_EQ(edge.n, 2);
  EXPECT_NEAR(edge.total, 0.4, 1e-12);
}



TEST(CohesiveLength, straight_corners_of_a_layer_do_not_divide_it)
{
  scene::SectionMesh mesh = squares({{-0.25, 1.}});
  const int          n    = static_cast<int>(mesh.nodes.size());
  mesh.blocks.push_back({});
  for (const double x : {-2., 2.})
    {
      mesh.nodes.push_back({x, 0.});
      mesh.blocks[1].push_back(static_cast<int>(mesh.nodes.size()) - 1);
    }
  for (int k = 0; k <= 20; ++k)
    {
      mesh.nodes.push_back({2. - 0.2 * k, 1.});
      mesh.blocks[1].push_back(n + 2 + k);
    }
  mesh.block_region.push_back(0);
  const Lengths l(mesh, straight_base(0., 5., 5., 3), 0, 1);
  EXPECT_EQ(l.n, 2);
  EXPECT_NEAR(l.total, 1., 1e-12);
  EXPECT_NEAR(Lengths(mesh, straight_base(0., 5., 5., 3), base_body, 1).total, 4., 1e-12);
}
