// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"

#include <hybrid/dda/springs/contact_length.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  constexpr double degree = M_PI / 180.;

  constexpr double corner_alone = 0.5; // what a corner alone stands for [m]

  /// Lengths of the contacts that a search finds between two bodies.
  struct Lengths
  {
    int    n     = 0;
    double total = 0., largest = 0., springs = 0.; // m

    Lengths(const scene::SectionMesh &mesh,
            const std::vector<Vec2>  &foundation,
            const int                 first,
            const int                 second)
    {
      FixedBaseRun run(mesh, block_parameters(30.), foundation);
      run.solver.solve(run.state, run.foundation, 1e-4);
      for (const Contact &c : run.state.contacts)
        if (std::minmax(c.vertex_body, c.edge_body) == std::minmax(first, second))
          {
            const ContactLength length =
              contact_length(run.state.geometry, run.state.contacts, c, corner_alone);
            ++n;
            total += length.overlap;
            largest = std::max(largest, length.overlap);
            springs += length.spring;
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



TEST(ContactLength, is_that_of_the_edge_in_all_whatever_the_pieces_of_the_base)
{
  for (const int pieces : {1, 3, 50})
    for (const double angle : {0., 35. * degree})
      for (const double size : {0.2, 1., 3.})
        {
          const Lengths l(square_blocks(1, 1, size, angle),
                          straight_foundation(angle, 1.3, 7., pieces),
                          foundation_body,
                          0);
          EXPECT_NEAR(l.total, size, 1e-12);
          EXPECT_NEAR(l.springs, size, 1e-12);
          EXPECT_TRUE(pieces > 1 || l.n == 2) << l.n;
          EXPECT_LE(l.largest, 0.5 * size + 1e-12);
        }
  for (const double height : {0.2, 1., 3.})
    {
      const Lengths l(one_block({{0., 0.}, {2., 0.}, {0.7, height}}),
                      straight_foundation(0., 1.3, 7., 9),
                      foundation_body,
                      0);
      EXPECT_EQ(l.n, 4) << height;
      EXPECT_NEAR(l.total, 2., 1e-12) << height;
    }
}



TEST(ContactLength, a_corner_alone_has_none)
{
  for (const double tilt : {5., 30., 45.})
    {
      const Lengths l(square_blocks(1, 1, 1., tilt * degree),
                      straight_foundation(0., 5., 5.),
                      foundation_body,
                      0);
      EXPECT_GE(l.n, 1) << tilt;
      EXPECT_EQ(l.total, 0.) << tilt;
      EXPECT_EQ(l.springs, l.n * corner_alone) << tilt;
    }
  const Lengths nearly(square_blocks(1, 1, 1., 2. * degree),
                       straight_foundation(0., 5., 5.),
                       foundation_body,
                       0);
  EXPECT_EQ(nearly.n, 2);
  EXPECT_NEAR(nearly.total, 1., 1e-3); // projected
}



/// The last place of a surface is a corner: a square that tilts over it by 10 degrees stands on it.
TEST(ContactLength, the_end_of_a_surface_is_a_corner)
{
  for (const double side : {1., -1.}) // the end is the right one, the left one
    {
      const double      c = std::cos(10. * degree), s = -side * std::sin(10. * degree);
      std::vector<Vec2> square;
      for (const Vec2 &p : {Vec2(-0.5, 0.), Vec2(0.5, 0.), Vec2(0.5, 1.), Vec2(-0.5, 1.)})
        {
          const Vec2 moved = p - Vec2(0.15 * side, 0.);
          square.emplace_back(c * moved.x() - s * moved.y(), s * moved.x() + c * moved.y() - 1e-5);
        }
      const std::vector<Vec2> base =
        side > 0. ? std::vector<Vec2>{{-5., 0.}, {0., 0.}} : std::vector<Vec2>{{0., 0.}, {5., 0.}};
      const Lengths found(one_block(square), base, 0, foundation_body);
      EXPECT_EQ(found.n, 1) << side;
      EXPECT_NEAR(found.springs, corner_alone, 1e-12) << side;
    }
}



TEST(ContactLength, blocks_on_blocks_have_their_overlap)
{
  const std::vector<Vec2> foundation = straight_foundation(0., 5., 5.);
  for (const double shift : {0.4, -0.7, 1e-9, 0.})
    {
      const Lengths l(squares({{0., 0.}, {shift, 1.}}), foundation, 0, 1);
      EXPECT_NEAR(l.total, 1. - std::abs(shift), 1e-8) << shift << ", contacts " << l.n;
    }
  // over the seam of a row
  const scene::SectionMesh row = squares({{0., 0.}, {1., 0.}, {0.4, 1.}});
  EXPECT_NEAR(Lengths(row, foundation, 0, 2).total, 0.6, 1e-9);
  EXPECT_NEAR(Lengths(row, foundation, 1, 2).total, 0.4, 1e-9);
}



TEST(ContactLength, gentle_bends_of_the_base_divide_or_belong_to_the_edge)
{
  for (const double bend : {-2., -0.5, 0.5, 2.}) // positive: a ridge below the block [deg]
    {
      const double      dip = std::tan(0.5 * bend * degree);
      std::vector<Vec2> foundation{{-5., -5.3 * dip}, {0.3, 0.}, {5., -4.7 * dip}};
      if (bend < 0.) // its ends touch
        for (Vec2 &node : foundation)
          node.y() += 0.3 * dip;
      const Lengths l(square_blocks(1, 1), foundation, foundation_body, 0);
      EXPECT_NEAR(l.total, 1., 1e-3) << bend;
    }
}



TEST(ContactLength, what_hangs_over_the_end_of_an_edge_does_not_count)
{
  // On the end of the foundation, and on a ridge that is no seam, the node has the other half.
  const Lengths end(square_blocks(1, 1), straight_foundation(0., 5., 0.4), foundation_body, 0);
  EXPECT_EQ(end.n, 2);
  EXPECT_NEAR(end.total, 0.4, 1e-12);
  const Lengths edge(square_blocks(1, 1), {{-5., 0.}, {0.4, 0.}, {5., -4.}}, foundation_body, 0);
  EXPECT_EQ(edge.n, 2);
  EXPECT_NEAR(edge.total, 0.4, 1e-12);
}



TEST(ContactLength, a_face_that_overlaps_by_little_stands_for_a_corner)
{
  // On a wall's top, in one piece and in many; never more than the whole face, for small blocks.
  for (const int pieces : {1, 40})
    for (const double overlap : {1e-3, 0.01, 0.3, 0.7})
      {
        const Lengths l(square_blocks(1, 1),
                        straight_foundation(0., 5., overlap, pieces),
                        foundation_body,
                        0);
        EXPECT_NEAR(l.total, overlap, 1e-12) << pieces;
        EXPECT_NEAR(l.springs, std::max(overlap, corner_alone), 1e-9) << pieces << ' ' << overlap;
      }
  const Lengths small(square_blocks(1, 1, 0.2),
                      straight_foundation(0., 5., 0.1),
                      foundation_body,
                      0);
  EXPECT_NEAR(small.springs, 0.2, 1e-12);
}



TEST(ContactLength, passes_from_overlap_to_corner_as_the_edges_turn_apart)
{
  double before = 1.; // all of the sole
  for (const double tilt : {0.01, 0.5, 1., 2., 2.9, 3.1})
    {
      const Lengths l(square_blocks(1, 1, 1., tilt * degree),
                      straight_foundation(0., 5., 5., 50),
                      foundation_body,
                      0);
      EXPECT_LE(std::abs(l.springs - before), 1.) << tilt;
      before = l.springs;
    }
  EXPECT_NEAR(before, corner_alone, 1e-12) << "the lower corner alone";
}



TEST(ContactLength, is_shared_where_nodes_of_both_are_at_one_place)
{
  for (const double shift : {0., 1e-7, -1e-7, 1e-3, -1e-3, 0.3})
    {
      std::vector<Vec2> foundation = straight_foundation(0., 5., 5., 10); // nodes every metre
      for (Vec2 &node : foundation)
        node.x() += shift;
      const Lengths one(square_blocks(1, 1), foundation, foundation_body, 0);
      EXPECT_NEAR(one.total, 1., 1e-7) << shift;
      EXPECT_NEAR(one.springs, 1., 1e-7) << shift;
      const scene::SectionMesh row = square_blocks(3, 1);
      for (const int block : {0, 1, 2})
        EXPECT_NEAR(Lengths(row, foundation, foundation_body, block).total, 1., 1e-7)
          << shift << " " << block;
    }
}



TEST(ContactLength, corner_that_hangs_over_the_end_of_its_edge_leaves_the_rest_to_the_place_there)
{
  FixedBaseRun run(square_blocks(1, 1), block_parameters(30.), straight_foundation(0., 5., 5., 40));
  run.solver.solve(run.state, run.foundation, 1e-4);
  const std::vector<Vec2> start = run.state.geometry.vertices;
  for (const double shift : {0., 2e-5, -2e-5, 5e-5, -5e-5})
    {
      for (std::size_t v = 0; v < start.size(); ++v)
        run.state.geometry.vertices[v] = start[v] + Vec2(shift, 0.);
      double total = 0.;
      for (const Contact &c : run.state.contacts)
        total += contact_length(run.state.geometry, run.state.contacts, c, corner_alone).overlap;
      EXPECT_NEAR(total, 1., 1e-4) << shift;
    }
}



TEST(ContactLength, straight_corners_of_a_layer_do_not_divide_it)
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
  const Lengths l(mesh, straight_foundation(0., 5., 5., 3), 0, 1);
  EXPECT_EQ(l.n, 2);
  EXPECT_NEAR(l.total, 1., 1e-12);
  EXPECT_NEAR(Lengths(mesh, straight_foundation(0., 5., 5., 3), foundation_body, 1).total,
              4.,
              1e-12);
}
