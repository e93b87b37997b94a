// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::scene
{
  /**
   * Vertical stress of the overburden: what stands straight above a point, with the weights that
   * the run has.
   *
   *   sigma_v(x, y) = g int_y^top rho_w(x, y') dy'
   *
   * rho_w is the density that gravity acts on; below the water of `submerged` and `pressures` the
   * mass weighs its density less the water's, so that its stress is effective. So does the bedrock
   * where its planes have pore pressure (SceneParameters::has_wet_planes()); else its stress is
   * total, and on it lie the mass and, with `pressures`, the water above the rock. Gaps between
   * blocks weigh nothing.
   */
  class Overburden
  {
  public:
    Overburden(const SectionMesh &mesh, const SceneParameters &scene);

    /// Effective vertical stress in the mass [Pa], compression positive.
    /// @param inside a point of the same body: @p place may be on its outline, where another begins
    double in_mass(const Vec2 &place, const Vec2 &inside) const;

    /// The same in the bedrock, see above.
    double in_bedrock(const Vec2 &place, const Vec2 &inside) const;

  private:
    /// A polygon of one weight.
    struct Solid
    {
      int    first, size;          ///< of its corners
      double unit_weight;          ///< above the water [N/m3]
      double submerged_weight;     ///< below it [N/m3]
      double left, right, highest; ///< [m]
    };

    /// Solids by the strips of equal width that they reach into.
    struct Strips
    {
      std::vector<Solid>            solids;
      std::vector<std::vector<int>> of_strip;
    };

    /// What stands above a place.
    struct Column
    {
      double weight; ///< per area [Pa]
      double top;    ///< [m]
    };

    std::vector<Vec2>           corners;
    Strips                      mass, rock;
    double                      left = 0., width = 1.; ///< of the first strip [m]
    EnvironmentParameters       around;
    double                      water_weight    = 0.;    ///< [N/m3]; 0: no buoyancy
    bool                        presses_on_rock = false; ///< the water
    mutable std::vector<double> crossings;               ///< [m]

    void add(Strips &strips, std::vector<Vec2> polygon, double weight, double submerged);
    void sort_into_strips(Strips &strips, int n_strips) const;

    Column above(const Strips &strips, double x, double y) const;

    /// Of the water that acts [m].
    double level(double x) const;
  };
} // namespace hybrid::scene
