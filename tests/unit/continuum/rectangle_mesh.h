// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::test
{
  /// 0, length/n, ..., length, shifted by @p start.
  inline std::vector<double> equal_spacing(const double start, const double length, const int n)
  {
    std::vector<double> result;
    for (int i = 0; i <= n; ++i)
      result.push_back(start + length * i / n);
    return result;
  }


  /// A rectangle of bedrock with lines base, left, right and ground; one region "bedrock".
  /// Row j, column i of cells is cell j * columns + i, node likewise.
  inline scene::SectionMesh rectangle_mesh(const std::vector<double> &x,
                                           const std::vector<double> &y)
  {
    scene::SectionMesh mesh;
    const int          nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size());
    for (const double yj : y)
      for (const double xi : x)
        mesh.nodes.emplace_back(xi, yj);
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i)
        {
          const int n = j * nx + i;
          mesh.bedrock_cells.push_back({n, n + 1, n + nx + 1, n + nx});
          mesh.bedrock_region.push_back(0);
        }
    mesh.bedrock_region_names = {"bedrock"};
    for (int i = 0; i + 1 < nx; ++i)
      {
        mesh.lines["base"].push_back({i, i + 1});
        mesh.lines["ground"].push_back({(ny - 1) * nx + i, (ny - 1) * nx + i + 1});
      }
    for (int j = 0; j + 1 < ny; ++j)
      {
        mesh.lines["left"].push_back({j * nx, (j + 1) * nx});
        mesh.lines["right"].push_back({j * nx + nx - 1, (j + 1) * nx + nx - 1});
      }
    return mesh;
  }


  /// A triangle far above, so that the ground becomes a contact surface.
  inline void add_block(scene::SectionMesh &mesh)
  {
    const int n = static_cast<int>(mesh.nodes.size());
    for (const Vec2 &corner : {Vec2(0., 1e3), Vec2(1., 1e3), Vec2(0., 1001.)})
      mesh.nodes.push_back(corner);
    mesh.blocks.push_back({n, n + 1, n + 2});
    mesh.block_region.push_back(0);
    mesh.block_region_names = {"sliding_mass"};
  }


  /// Rock of unit-friendly numbers: rho = 2000, c_s = 1000 m/s, nu = 0.25 (c_p = 1732 m/s).
  inline Material rock_material()
  {
    Material rock;
    rock.name          = "rock";
    rock.density       = 2000.;
    rock.poisson_ratio = 0.25;
    rock.young_modulus = 2. * 1.25 * 2000. * 1000. * 1000.;
    return rock;
  }


  inline scene::SceneParameters rock_scene()
  {
    scene::SceneParameters scene;
    scene.materials["rock"]              = rock_material();
    scene.continuum.region_material["*"] = "rock";
    return scene;
  }
} // namespace hybrid::test
