// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_orders.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    /// Two cells of 1 m beside each other, the upper right corner @p rise higher than the others.
    scene::SectionMesh two_cells(const std::vector<int> &regions, const double rise = 0.)
    {
      scene::SectionMesh mesh;
      mesh.nodes          = {{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1. + rise}};
      mesh.bedrock_cells  = {{{0, 1, 4, 3}}, {{1, 2, 5, 4}}};
      mesh.bedrock_region = regions;
      return mesh;
    }



    scene::SceneParameters of_degree(const int degree)
    {
      scene::SceneParameters scene;
      scene.continuum.degree = degree;
      return scene;
    }



    TEST(MeshOrders, of_level_ground_are_assumed_to_be_that_of_dispersion)
    {
      const MeshOrders orders = mesh_orders(of_degree(3), two_cells({0, 0}), false);
      EXPECT_EQ(orders.lowest, 2.);
      EXPECT_EQ(orders.highest, 6.);
      EXPECT_EQ(orders.assumed, 4.); // no more, where meshes do not resolve the waves
      EXPECT_EQ(orders.left, 0.5);
      EXPECT_EQ(mesh_orders(of_degree(1), two_cells({0, 0}), false).assumed, 2.);
    }



    TEST(MeshOrders, are_assumed_to_be_the_lowest_at_corners_planes_and_loads)
    {
      EXPECT_EQ(mesh_orders(of_degree(3), two_cells({0, 1}), false).assumed, 2.);
      EXPECT_EQ(mesh_orders(of_degree(3), two_cells({0, 0}, 0.2), false).assumed, 2.);
      scene::SceneParameters has_plane = of_degree(3), has_load = of_degree(3);
      has_plane.bedding.names = {"bedding_1"};
      has_load.point_loads.loads.resize(1);
      EXPECT_EQ(mesh_orders(has_plane, two_cells({0, 0}), false).assumed, 2.);
      EXPECT_EQ(mesh_orders(has_load, two_cells({0, 0}), false).assumed, 2.);
      EXPECT_EQ(mesh_orders(has_plane, two_cells({0, 0}), false).left, 0.25);
      EXPECT_EQ(mesh_orders(has_load, two_cells({0, 0}), false).left, 0.5);
    }



    TEST(MeshOrders, of_blocks_lie_between_the_first_and_the_second)
    {
      const MeshOrders orders = mesh_orders(of_degree(3), two_cells({0, 0}), true);
      EXPECT_EQ(orders.lowest, 1.);
      EXPECT_EQ(orders.highest, 2.);
      EXPECT_EQ(orders.assumed, 1.);
      EXPECT_EQ(orders.left, 0.5);
    }
  } // namespace
} // namespace hybrid::output
