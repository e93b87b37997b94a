// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/stable_step.h>
#include <hybrid/scene/parameters/time_integrator.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Stable step over a P wave's way between the nearest nodes. Squares of degree 2 to 8 have
    /// 0.63 to 0.66, of degree 1 0.82, by Lanczos (ExplicitWaves); cells that lean have less.
    constexpr double courant = 0.6;



    /// Distance of the two nodes at the end of an edge of length 1, Gauss-Lobatto points.
    double nearest_nodes(const int degree)
    {
      // The outermost inner point is the largest zero of the derivative of Legendre's polynomial.
      constexpr double first[] = {1.,
                                  0.5,
                                  0.276393202250021,
                                  0.172673164646011,
                                  0.117472338035268,
                                  0.084888051860717,
                                  0.064129925745197,
                                  0.050121002294270};
      return first[std::clamp(degree, 1, 8) - 1];
    }
  } // namespace



  double estimated_stable_step(const SectionMesh &mesh, const SceneParameters &scene)
  {
    double shortest = 1e300; // way of a P wave between two nodes [s]
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      {
        const std::string &region = mesh.bedrock_region_names[mesh.bedrock_region[c]];
        const double       speed  = scene.bedrock_material(region).p_wave_speed();
        const auto        &cell   = mesh.bedrock_cells[c];
        for (std::size_t i = 0; i < cell.size(); ++i)
          {
            const Vec2 edge = mesh.nodes[cell[(i + 1) % cell.size()]] - mesh.nodes[cell[i]];
            shortest        = std::min(shortest, edge.norm() / speed);
          }
      }
    const double undamped = courant * nearest_nodes(scene.continuum.degree) * shortest;
    // dt^2 w^2 + 2 beta_K w^2 dt = 4 with w = 2 / undamped
    const double beta = scene.continuum.rayleigh_stiffness;
    return std::sqrt(beta * beta + undamped * undamped) - beta;
  }



  SceneParameters with_time_integrator(SceneParameters scene, const SectionMesh &mesh)
  {
    if (scene.continuum.integrator == TimeIntegrator::automatic &&
        why_not_explicit(scene).empty() &&
        scene.time.time_step <= parts_of_an_implicit_step * estimated_stable_step(mesh, scene))
      take_explicit(scene);
    return scene;
  }
} // namespace hybrid::scene
