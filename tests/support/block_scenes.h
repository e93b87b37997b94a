// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/step/block_solver.h>
#include <hybrid/dda/step/initial_state.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

/// Small block scenes that several tests share.
namespace hybrid::test
{
  /// A block scene with one material "rock" (no bonds, no belt) and defaults otherwise.
  inline scene::SceneParameters block_parameters(const double friction_angle,
                                                 const double young_modulus = 50e6,
                                                 const double density       = 2220.)
  {
    scene::SceneParameters s;
    Material               rock;
    rock.name           = "rock";
    rock.density        = density;
    rock.young_modulus  = young_modulus;
    rock.poisson_ratio  = 0.25;
    rock.friction_angle = friction_angle;
    s.materials["rock"] = rock;
    s.blocks.material   = "rock";
    s.blocks.bonded     = false;
    return s;
  }



  /// columns x rows squares of the given size, corner at the origin, turned by the angle [rad];
  /// neighbouring squares share mesh nodes.
  inline scene::SectionMesh
  square_blocks(const int columns, const int rows, const double size = 1., const double angle = 0.)
  {
    scene::SectionMesh mesh;
    const double       c = std::cos(angle), s = std::sin(angle);
    for (int j = 0; j <= rows; ++j)
      for (int i = 0; i <= columns; ++i)
        mesh.nodes.push_back(Vec2(c * i - s * j, s * i + c * j) * size);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        {
          const int n = j * (columns + 1) + i;
          mesh.blocks.push_back({n, n + 1, n + columns + 2, n + columns + 1});
          mesh.block_region.push_back(0);
        }
    mesh.block_region_names = {"sliding_mass"};
    return mesh;
  }



  /// A row of square_blocks() of 1 m, and another square 0.02 m beside it, half a metre up.
  inline scene::SectionMesh row_and_square(const int columns)
  {
    scene::SectionMesh mesh = square_blocks(columns, 1);
    const int          n    = static_cast<int>(mesh.nodes.size());
    const Vec2         corner(columns + 0.02, 0.5);
    for (const Vec2 &x : {Vec2(0., 0.), Vec2(1., 0.), Vec2(1., 1.), Vec2(0., 1.)})
      mesh.nodes.push_back(corner + x);
    mesh.blocks.push_back({n, n + 1, n + 2, n + 3});
    mesh.block_region.push_back(0);
    return mesh;
  }



  /// A straight foundation through the origin at the angle [rad], from -before to +after along it,
  /// in pieces.
  inline std::vector<Vec2> straight_foundation(const double angle,
                                               const double before,
                                               const double after,
                                               const int    pieces = 1)
  {
    std::vector<Vec2> nodes;
    for (int k = 0; k <= pieces; ++k)
      nodes.push_back((-before + (before + after) * k / pieces) *
                      Vec2(std::cos(angle), std::sin(angle)));
    return nodes;
  }



  /// A block scene on a fixed foundation that steps at constant dt, halving where the iteration
  /// asks for it.
  class FixedBaseRun
  {
  public:
    FixedBaseRun(const scene::SectionMesh     &mesh,
                 const scene::SceneParameters &scene,
                 const std::vector<Vec2>      &foundation_nodes)
      : model(dda::build_model(mesh, scene, foundation_nodes))
      , state(dda::initial_state(model))
      , solver(model)
    {
      foundation.displacement = state.foundation_displacement;
    }

    /// Advance to the end time. @return false if a step of dt / 2^10 did not converge.
    bool run(const double end_time, const double dt)
    {
      while (state.time < end_time - 1e-9 * dt)
        if (!advance(dt, 10))
          return false;
      return true;
    }

    /// One step of dt, in two halves where it does not converge.
    bool advance(const double dt, const int halvings)
    {
      const dda::StepResult result = solver.solve(state, foundation, dt);
      iterations += result.iterations;
      solver_iterations += result.solver_iterations;
      if (result.converged)
        {
          solver.accept(state);
          ++steps;
          return true;
        }
      ++cuts;
      return halvings > 0 && advance(0.5 * dt, halvings - 1) && advance(0.5 * dt, halvings - 1);
    }

    dda::Model              model;
    dda::DdaState           state;
    dda::BlockSolver        solver;
    dda::FoundationResponse foundation;
    int                     steps = 0, iterations = 0, solver_iterations = 0, cuts = 0;
  };
} // namespace hybrid::test
