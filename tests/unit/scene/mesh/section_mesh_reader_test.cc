// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/mesh_check.h>
#include <hybrid/scene/mesh/section_mesh_reader.h>
#include <hybrid/scene/text_table.h>

#include "temporary_files.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hybrid::scene::test
{
  namespace
  {
    const std::string mesh_directory = std::string(HYBRID_SOURCE_DIR) + "/meshes/";

    using SectionMeshReader = TemporaryFiles;


    SectionMesh read(const std::string                                 &file,
                     const std::vector<std::pair<std::string, double>> &numbers = {})
    {
      MeshParameters parameters;
      parameters.file    = file;
      parameters.numbers = numbers;
      return read_section_mesh(parameters);
    }


    template <typename Cell>
    double area(const SectionMesh &mesh, const Cell &cell)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < cell.size(); ++i)
        sum += 0.5 * cross(mesh.nodes[cell[i]], mesh.nodes[cell[(i + 1) % cell.size()]]);
      return sum;
    }


    template <typename Cells>
    double total_area(const SectionMesh &mesh, const Cells &cells)
    {
      double sum = 0.;
      for (const auto &cell : cells)
        sum += area(mesh, cell);
      return sum;
    }


    double length(const SectionMesh &mesh, const std::string &line)
    {
      double sum = 0.;
      for (const auto &edge : mesh.lines.at(line))
        sum += (mesh.nodes[edge[1]] - mesh.nodes[edge[0]]).norm();
      return sum;
    }


    /// Smallest corner angle of a polygon [deg].
    template <typename Cell>
    double smallest_angle(const SectionMesh &mesh, const Cell &cell)
    {
      double            smallest = 180.;
      const std::size_t n        = cell.size();
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vec2 a = mesh.nodes[cell[(i + 1) % n]] - mesh.nodes[cell[i]];
          const Vec2 b = mesh.nodes[cell[(i + n - 1) % n]] - mesh.nodes[cell[i]];
          smallest     = std::min(smallest, std::atan2(cross(a, b), a.dot(b)) * 180. / M_PI);
        }
      return smallest;
    }


    double smallest_scaled_jacobian(const SectionMesh &mesh)
    {
      double smallest = 1.;
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          {
            const Vec2 a = mesh.nodes[cell[(i + 1) % 4]] - mesh.nodes[cell[i]];
            const Vec2 b = mesh.nodes[cell[(i + 3) % 4]] - mesh.nodes[cell[i]];
            smallest     = std::min(smallest, cross(a, b) / (a.norm() * b.norm()));
          }
      return smallest;
    }


    std::vector<Vec2> slip_surface_points()
    {
      std::vector<Vec2> points;
      for (const TableRow &row : read_text_table(mesh_directory + "majiagou_section.csv"))
        if (row.fields[0] == "slip_surface")
          points.emplace_back(std::stod(row.fields[1]), std::stod(row.fields[2]));
      return points;
    }


    /// Area between straight lines through the points and a curve whose slope at each point is
    /// that of the parabola through it and its neighbours; positive if the curve lies below.
    double area_below_chords(const std::vector<Vec2> &x)
    {
      const auto slope_between = [](const Vec2 &a, const Vec2 &b) {
        return (b.y() - a.y()) / (b.x() - a.x());
      };
      const std::size_t   last = x.size() - 1;
      std::vector<double> slope;
      for (std::size_t i = 0; i <= last; ++i)
        {
          const std::size_t a    = std::min(i == 0 ? 0 : i - 1, last - 2);
          const double      d    = slope_between(x[a], x[a + 1]);
          const double      bend = (slope_between(x[a + 1], x[a + 2]) - d) / (x[a + 2] - x[a]).x();
          slope.push_back(d + bend * (2. * x[i].x() - x[a].x() - x[a + 1].x()));
        }
      double area = 0.;
      for (std::size_t i = 0; i < last; ++i)
        area += std::pow(x[i + 1].x() - x[i].x(), 2) / 12. * (slope[i + 1] - slope[i]);
      return area;
    }


    /// Every edge of the slip surface is an edge of one bedrock cell and of one block.
    void expect_shared_slip_edges(const SectionMesh &mesh)
    {
      std::multiset<std::pair<int, int>> rock, mass;
      for (const auto &cell : mesh.bedrock_cells)
        for (int i = 0; i < 4; ++i)
          rock.insert(std::minmax(cell[i], cell[(i + 1) % 4]));
      for (const auto &block : mesh.blocks)
        for (std::size_t i = 0; i < block.size(); ++i)
          mass.insert(std::minmax(block[i], block[(i + 1) % block.size()]));
      for (const auto &edge : mesh.lines.at("sliding_surface"))
        {
          EXPECT_EQ(rock.count(std::minmax(edge[0], edge[1])), 1u);
          EXPECT_EQ(mass.count(std::minmax(edge[0], edge[1])), 1u);
        }
    }
  } // namespace


  TEST_F(SectionMeshReader, MajiagouHasTheSectionsAreasAndLengths)
  {
    const SectionMesh mesh = read(mesh_directory + "majiagou.geo");

    // 9,907 and 383,237 m2: shoelace formula on the polylines of the section. The curve through the
    // points of the slip surface, seen as cubics with slopes s over lengths h, lies below by
    // sum h^2 / 12 (s_right - s_left); element edges are chords of it.
    const double below = area_below_chords(slip_surface_points());
    EXPECT_NEAR(below, 50.256, 1e-3);
    EXPECT_NEAR(total_area(mesh, mesh.blocks), 9907. + below, 1.);
    EXPECT_NEAR(total_area(mesh, mesh.bedrock_cells), 383237. - below, 1.);
    EXPECT_NEAR(total_area(mesh, mesh.blocks) + total_area(mesh, mesh.bedrock_cells),
                393144.,
                1e-6);
    EXPECT_NEAR(length(mesh, "base"), 1300., 1e-9);
    EXPECT_NEAR(length(mesh, "left"), 275., 1e-9);
    EXPECT_NEAR(length(mesh, "right"), 398., 1e-9);
    EXPECT_NEAR(length(mesh, "sliding_surface"), 538.93, 0.02);
    for (const char *const plane : {"bedding_1", "bedding_2", "bedding_3", "bedding_4"})
      EXPECT_NEAR(length(mesh, plane), 900. / std::cos(16.5 * M_PI / 180.), 0.01);

    SceneParameters scene;
    scene.bedding.names = {"bedding_1", "bedding_2", "bedding_3", "bedding_4"};
    EXPECT_NO_THROW(check_section_mesh(mesh, scene));
  }


  TEST_F(SectionMeshReader, MajiagouIsWellShapedAtEveryResolution)
  {
    for (const double h : {2., 4., 8.})
      {
        const SectionMesh mesh = read(mesh_directory + "majiagou.geo", {{"Resolution/h", h}});
        EXPECT_GT(smallest_scaled_jacobian(mesh), 0.3) << "h = " << h;
        double angle = 180.;
        for (const auto &block : mesh.blocks)
          angle = std::min(angle, smallest_angle(mesh, block));
        EXPECT_GT(angle, 11.9) << "h = " << h; // the section's wedge at the crest
        expect_shared_slip_edges(mesh);
        if (h == 4.)
          {
            EXPECT_GT(mesh.blocks.size(), 1500u);
            EXPECT_LT(mesh.blocks.size(), 3000u);
            EXPECT_GT(mesh.bedrock_cells.size(), 2000u);
            EXPECT_LT(mesh.bedrock_cells.size(), 3000u);
          }
      }
  }


  TEST_F(SectionMeshReader, MajiagouFollowsThePolylinesOfTheSection)
  {
    const SectionMesh mesh = read(mesh_directory + "majiagou.geo", {{"Resolution/h", 8.}});
    std::set<std::pair<double, double>> nodes;
    for (const Vec2 &x : mesh.nodes)
      nodes.insert({std::round(1e6 * x.x()), std::round(1e6 * x.y())});

    int points = 0;
    for (const TableRow &row : read_text_table(mesh_directory + "majiagou_section.csv"))
      {
        const std::string &name = row.fields[0];
        if (name == "ground" || name == "slip_surface" || name == "box" ||
            name.rfind("bedding_", 0) == 0)
          {
            const double x = std::stod(row.fields[1]), y = std::stod(row.fields[2]);
            EXPECT_EQ(nodes.count({std::round(1e6 * x), std::round(1e6 * y)}), 1u)
              << name << " " << x << " " << y;
            ++points;
          }
      }
    EXPECT_EQ(points, 40);
  }


  TEST_F(SectionMeshReader, SameFileGivesTheSameBits)
  {
    const SectionMesh a = read(mesh_directory + "majiagou.geo", {{"Resolution/h", 8.}});
    const SectionMesh b = read(mesh_directory + "majiagou.geo", {{"Resolution/h", 8.}});
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.bedrock_cells, b.bedrock_cells);
    EXPECT_EQ(a.blocks, b.blocks);
    EXPECT_EQ(a.lines, b.lines);
  }


  TEST_F(SectionMeshReader, ColumnTakesItsNumbers)
  {
    const SectionMesh mesh =
      read(mesh_directory + "column.geo",
           {{"Width", 6.}, {"Height", 30.}, {"Layer height", 10.}, {"Resolution/h", 2.}});
    EXPECT_EQ(mesh.bedrock_cells.size(), 3u * 15u);
    EXPECT_EQ(mesh.nodes.size(), 4u * 16u);
    ASSERT_EQ(mesh.bedrock_region_names, (std::vector<std::string>{"bedrock", "bedrock_soft"}));
    EXPECT_EQ(std::count(mesh.bedrock_region.begin(), mesh.bedrock_region.end(), 1), 3 * 5);
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      {
        EXPECT_NEAR(area(mesh, mesh.bedrock_cells[c]), 4., 1e-9);
        EXPECT_EQ(mesh.bedrock_region[c], mesh.nodes[mesh.bedrock_cells[c][0]].y() > 19.9 ? 1 : 0);
      }

    // chained upwards and to the right
    EXPECT_NEAR((mesh.nodes[mesh.lines.at("left").front()[0]] - Vec2(0., 0.)).norm(), 0., 1e-12);
    EXPECT_NEAR((mesh.nodes[mesh.lines.at("left").back()[1]] - Vec2(0., 30.)).norm(), 0., 1e-12);
    EXPECT_NEAR((mesh.nodes[mesh.lines.at("ground").back()[1]] - Vec2(6., 30.)).norm(), 0., 1e-12);
    for (const auto &[name, edges] : mesh.lines)
      for (std::size_t e = 1; e < edges.size(); ++e)
        EXPECT_EQ(edges[e][0], edges[e - 1][1]) << name;
  }


  TEST_F(SectionMeshReader, HalfBlocksShareTheSurface)
  {
    const SectionMesh mesh =
      read(mesh_directory + "half_blocks.geo",
           {{"Width", 4.}, {"Height", 10.}, {"Block height", 6.}, {"Resolution/h", 1.}});
    EXPECT_EQ(mesh.bedrock_cells.size(), 16u);
    EXPECT_EQ(mesh.blocks.size(), 48u);
    EXPECT_NEAR(total_area(mesh, mesh.blocks), 24., 1e-9);
    for (const auto &block : mesh.blocks)
      EXPECT_NEAR(area(mesh, block), 0.5, 1e-9);
    expect_shared_slip_edges(mesh);
    EXPECT_NO_THROW(check_section_mesh(mesh, SceneParameters()));
  }


  TEST_F(SectionMeshReader, WrongNumbersAreRefused)
  {
    const std::string column = mesh_directory + "column.geo";
    expect_part(
      message_of([&]() {
        read(column, {{"Resolution", 2.}});
      }),
      "no number 'Resolution'; the file defines Height, Layer height, Resolution/h, Width");
    expect_part(message_of([&]() {
                  read(column, {{"Width", -2.}});
                }),
                "'Width' is -2; it must be at least 0.001");
    expect_part(message_of([&]() {
                  read(column, {{"Layer height", 500.}});
                }),
                "Layer height = 500 must be less than Height = 100");
  }


  namespace
  {
    /// A unit square with @p more lines; its surface is 1, its curves are 1 to 4.
    std::string square(const std::string &more)
    {
      return "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};\n"
             "Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
             "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Transfinite Surface {1};\n"
             "Transfinite Curve {1, 2, 3, 4} = 3;\n" +
             more;
    }
  } // namespace


  TEST_F(SectionMeshReader, WrongGroupsAreRefused)
  {
    const auto message = [&](const std::string &more) {
      return message_of([&]() { read(write("square.geo", square(more))); });
    };
    const std::string triangle = message("Physical Surface(\"bedrock\") = {1};\n");
    expect_part(triangle, "has a triangle at (");
    expect_part(triangle, "quadrilaterals only");

    const std::string unknown = message("Physical Surface(\"rock\") = {1};\n");
    expect_part(unknown, "'rock' of dimension 2 is not known");
    expect_part(
      unknown,
      "sliding_mass_<suffix>; curves sliding_surface, bedding_<n>, joint_<suffix>, base, left, right, ground");

    expect_part(message("Physical Curve(\"bedding_a\") = {1};\n"),
                "'bedding_a' of dimension 1 is not known");
    expect_part(message("Physical Surface(7) = {1};\n"), "group 7 of dimension 2 is not known");
    expect_part(
      message(
        "Physical Surface(\"sliding_mass\") = {1}; Physical Surface(\"sliding_mass_b\") = {1};\n"),
      "in two physical groups, sliding_mass and sliding_mass_b");
    expect_part(message("Physical Surface(\"sliding_mass\") = {2};\n Foo\n"), "square.geo");
  }


  TEST_F(SectionMeshReader, JointsOfTheMassMayCrossAndBranch)
  {
    const SectionMesh mesh   = read(write(
      "square.geo",
      square("Point(11) = {0.5, 0.5, 0}; Point(12) = {0.2, 0.2, 0}; Point(13) = {0.8, 0.2, 0};\n"
               "Point(14) = {0.5, 0.8, 0};\n"
               "Line(11) = {12, 11}; Line(12) = {13, 11}; Line(13) = {11, 14};\n"
               "Curve{11, 12, 13} In Surface{1};\n"
               "Physical Surface(\"sliding_mass\") = {1}; Physical Curve(\"joint_a\") = {11, 12};\n"
               "Physical Curve(\"joint_b\") = {13};\n")));
    double            length = 0.;
    for (const auto &edge : mesh.lines.at("joint_a"))
      length += (mesh.nodes[edge[1]] - mesh.nodes[edge[0]]).norm();
    EXPECT_NEAR(length, 2. * 0.3 * std::sqrt(2.), 1e-12);
    EXPECT_FALSE(mesh.lines.at("joint_b").empty());
  }


  TEST_F(SectionMeshReader, NumbersWithoutARangeTakeAnyValue)
  {
    const std::string file = write(
      "numbers.geo",
      "DefineConstant[ a = {-25, Name \"Angle\"}, b = {0.5, Name \"Part\"}, c = {3, Min 1, Max 4, Name \"Three\"} ];\n" +
        square("Physical Surface(\"bedrock\") = {1}; Recombine Surface {1};\n"));
    EXPECT_NO_THROW(read(file, {{"Angle", 25.}, {"Part", 100.}}));
    expect_part(message_of([&]() {
                  read(file, {{"Three", 5.}});
                }),
                "'Three' is 5; it must be at least 1 and at most 4");
  }


  TEST_F(SectionMeshReader, ClockwiseSurfacesComeOutCounterClockwise)
  {
    const SectionMesh mesh = read(write(
      "square.geo",
      square(
        "Physical Surface(\"bedrock\") = {-1}; Recombine Surface {1}; Reverse Surface {1};\n")));
    ASSERT_EQ(mesh.bedrock_cells.size(), 4u);
    for (const auto &cell : mesh.bedrock_cells)
      EXPECT_NEAR(area(mesh, cell), 0.25, 1e-12);
  }


  TEST_F(SectionMeshReader, AMeshThatWouldTakeHoursIsRefused)
  {
    const std::string message = message_of([&]() {
      read(mesh_directory + "disc.geo", {{"Diameter", 1000.}, {"Resolution/h", 0.1}});
    });
    expect_part(message, "disc.geo: the mesh would have about 1.6e+08 cells");
    expect_part(message,
                "are 0.1 m long on average; at most 2e+06 cells are allowed, so coarsen it by 8.9");
  }


  TEST_F(SectionMeshReader, ASectionOfMillionsOfKilometresIsNotMeshed)
  {
    expect_part(message_of([&]() {
                  read(mesh_directory + "column.geo", {{"Width", 1e8}});
                }),
                "The section from (0, 0) to (1e+08, 100) m is 1e+05 km large");
  }


  TEST_F(SectionMeshReader, CoordinatesMustBeFinite)
  {
    const std::string file = write("nan.msh",
                                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                   "$PhysicalNames\n1\n2 1 \"sliding_mass\"\n$EndPhysicalNames\n"
                                   "$Nodes\n3\n1 0 0 0\n2 2 nan 0\n3 0 3 0\n$EndNodes\n"
                                   "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
    expect_part(message_of([&]() { read(file); }),
                "nan.msh: the coordinate y of node 2 is not a finite number.");
    expect_part(message_of([&]() { read(write("inf.geo", "Point(7) = {1, 2, 1e400};\n")); }),
                "inf.geo: the coordinate z of point 7 is not a finite number.");
  }


  TEST_F(SectionMeshReader, MshFilesAreReadAndTakeNoNumbers)
  {
    const std::string file = write("one.msh",
                                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                   "$PhysicalNames\n1\n2 1 \"sliding_mass\"\n$EndPhysicalNames\n"
                                   "$Nodes\n4\n1 0 0 0\n2 9 9 0\n3 2 0 0\n4 0 3 0\n$EndNodes\n"
                                   "$Elements\n1\n1 2 2 1 1 1 4 3\n$EndElements\n");
    const SectionMesh mesh = read(file);
    ASSERT_EQ(mesh.nodes.size(), 3u); // the unused node is dropped
    ASSERT_EQ(mesh.blocks.size(), 1u);
    EXPECT_NEAR(area(mesh, mesh.blocks[0]), 3., 1e-15);
    expect_part(message_of([&]() { read(file, {{"h", 1.}}); }), "only a .geo file has numbers");
  }


  TEST_F(SectionMeshReader, MissingAndForeignFilesAreRefused)
  {
    expect_part(message_of([&]() { read((directory / "absent.geo").string()); }),
                "there is no such mesh file");
    expect_part(message_of([&]() { read(write("mesh.vtk", "")); }), "must end in .geo or .msh");
    expect_part(message_of(
                  [&]() { read(write("broken.geo", "Point(1) = {0, 0, 0};\nfoo = bar;\n")); }),
                "broken.geo:2: gmsh: Unknown variable");
    expect_part(message_of([&]() {
                  read(write("high.msh",
                             "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                             "$PhysicalNames\n1\n2 1 \"sliding_mass\"\n$EndPhysicalNames\n"
                             "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 5\n$EndNodes\n"
                             "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n"));
                }),
                "(0, 1, 5) m is outside the plane z = 0");
  }
} // namespace hybrid::scene::test
