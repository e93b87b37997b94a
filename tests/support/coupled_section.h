// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

/// A section of rock and blocks that the coupled tests share.
namespace hybrid::test
{
  /// Layout of a rectangular mass of triangles on a rectangle of rock; its surface is y = 0.
  struct Section
  {
    int    columns      = 2;  ///< cells of the rock across
    int    rows         = 2;  ///< cells of the rock downwards
    int    first        = 0;  ///< column where the mass begins
    int    mass_columns = 2;  ///< cells of two triangles across
    int    mass_rows    = 2;  ///< upwards
    double size         = 1.; ///< of a cell [m]
    int    plane_row    = -1; ///< cells of rock below the line bedding_1; -1: none
    bool   walled =
      false; ///< sides belong to the contact surface (for WalledFoundation), not to left and right
  };



  /// The section with lines base, left, right, ground and sliding_surface. With walls, the lines
  /// left and right are those of one separate cell of rock.
  inline scene::SectionMesh section_mesh(const Section &s)
  {
    scene::SectionMesh mesh;
    const int          nx = s.columns + 1, mx = s.mass_columns + 1;
    for (int j = 0; j <= s.rows; ++j)
      for (int i = 0; i < nx; ++i)
        mesh.nodes.push_back(s.size * Vec2(i, j - s.rows));
    for (int j = 0; j < s.rows; ++j)
      for (int i = 0; i < s.columns; ++i)
        mesh.bedrock_cells.push_back(
          {j * nx + i, j * nx + i + 1, (j + 1) * nx + i + 1, (j + 1) * nx + i});
    const int top = s.rows * nx, above = static_cast<int>(mesh.nodes.size()) - mx;
    for (int j = 1; j <= s.mass_rows; ++j)
      for (int i = 0; i < mx; ++i)
        mesh.nodes.push_back(s.size * Vec2(s.first + i, j));
    const auto node = [&](const int i, const int j) {
      return j == 0 ? top + s.first + i : above + j * mx + i;
    };
    for (int j = 0; j < s.mass_rows; ++j)
      for (int i = 0; i < s.mass_columns; ++i)
        {
          const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
          if ((i + j) % 2 == 0)
            mesh.blocks.insert(mesh.blocks.end(), {{a, b, c}, {a, c, d}});
          else
            mesh.blocks.insert(mesh.blocks.end(), {{a, b, d}, {b, c, d}});
        }
    mesh.block_region.assign(mesh.blocks.size(), 0);
    mesh.block_region_names = {"sliding_mass"};

    for (int i = 0; i < s.columns; ++i)
      {
        mesh.lines["base"].push_back({i, i + 1});
        const bool covered = i >= s.first && i < s.first + s.mass_columns;
        mesh.lines[covered ? "sliding_surface" : "ground"].push_back({top + i, top + i + 1});
      }
    for (int j = 0; j < s.rows; ++j)
      {
        mesh.lines[s.walled ? "ground" : "left"].push_back({j * nx, (j + 1) * nx});
        mesh.lines[s.walled ? "ground" : "right"].push_back(
          {j * nx + nx - 1, (j + 1) * nx + nx - 1});
      }
    for (int i = 0; i < s.columns && s.plane_row > 0; ++i)
      mesh.lines["bedding_1"].push_back({s.plane_row * nx + i, s.plane_row * nx + i + 1});
    if (s.walled)
      {
        const int  n    = static_cast<int>(mesh.nodes.size());
        const Vec2 away = s.size * Vec2(1000., -s.rows);
        for (const Vec2 &corner : {Vec2(0., 0.), Vec2(1., 0.), Vec2(1., 1.), Vec2(0., 1.)})
          mesh.nodes.push_back(away + s.size * corner);
        mesh.bedrock_cells.push_back({n, n + 1, n + 2, n + 3});
        mesh.lines["left"]  = {{n, n + 3}};
        mesh.lines["right"] = {{n + 1, n + 2}};
      }
    mesh.bedrock_region.assign(mesh.bedrock_cells.size(), 0);
    mesh.bedrock_region_names = {"bedrock"};
    return mesh;
  }



  /// Materials "rock" and "mass" (c_s = 200 m/s, nu = 0.25), "mass" also as belt; bonds that do not
  /// break.
  inline scene::SceneParameters coupled_parameters()
  {
    scene::SceneParameters scene;
    Material               mass;
    mass.name             = "mass";
    mass.density          = 2000.;
    mass.poisson_ratio    = 0.25;
    mass.young_modulus    = 2. * 1.25 * 2000. * 200. * 200.;
    mass.cohesion         = 1e12;
    mass.tensile_strength = 1e12;
    scene.materials       = {{"mass", mass}, {"rock", mass}};

    scene.materials["rock"].name         = "rock";
    scene.continuum.region_material["*"] = "rock";
    scene.blocks.material                = "mass";
    scene.blocks.belt_material           = "mass";
    return scene;
  }
} // namespace hybrid::test
