// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/block_motion.h>
#include <hybrid/scene/linear_table.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace hybrid::dda
{
  /**
   * Water below its surface h(x), the higher one of a level and of a phreatic line: the pressure at
   * the height y is rho_w g (h(x) - y) (Dupuit). The level may change in time.
   */
  struct Water
  {
    enum class Action
    {
      none,     ///< no force
      buoyancy, ///< of the submerged part of each block
      pressures ///< on the faces of each block, and pore pressure inside
    };

    Action action      = Action::none;
    double level       = 0.; ///< at the start, or at the time of at() [m]
    double unit_weight = 0.; ///< rho_w g [N/m3]

    std::shared_ptr<const scene::LinearTable> line = {}; ///< phreatic line [m]; nullptr: none
    std::shared_ptr<const scene::LinearTable> history =
      {};                         ///< level in time [s, m]; nullptr: stays
    bool static_as_drawn = false; ///< the static stage has the loads of the drawn places

    bool changes() const
    {
      return history != nullptr;
    }

    /// The same with the level of @p time [s]; before 0 that of the start.
    Water at(double time) const;

    /// The same with pressures in place of buoyancy: forces of blocks are effective with both, and
    /// rock below them feels the water as well.
    Water as_pressures() const;
  };


  /// Outline of a block in a trial: where its vertices were and how far they have moved.
  struct MovedOutline
  {
    const Vec2 *vertices;      ///< [m], counter-clockwise
    const Vec2 *displacements; ///< [m]; nullptr: none
    int         n;

    Vec2 at(const int k) const
    {
      return displacements == nullptr ? vertices[k] : Vec2(vertices[k] + displacements[k]);
    }
  };


  /// What the water does to a block.
  struct WaterLoad
  {
    Vec6   force     = Vec6::Zero(); ///< generalised [N/m, N]
    double potential = 0.;           ///< [J/m]; only differences between places of one block count
    bool   full      = false;        ///< all of the block is below one piece of the surface
    int    piece     = -1;           ///< WaterPiece::number of this piece
  };


  /**
   * Load of water on a saturated block (mass and weight of the block are total: with its pore
   * water).
   *
   * With pore pressure p = rho_w g (h - y) below the surface and Terzaghi's effective stress the
   * water's virtual work is
   *   - int_faces p n . du ds + int_block p div(du) dA = int_submerged rho_w g (du_y - h' du_x) dA,
   * buoyancy and, where the surface is inclined, seepage force.
   * `pressures` computes the left side, face by face (outer faces, joints, cracks and contacts
   * alike: what joints and contacts carry is effective); `buoyancy` the right side. Both refer to
   * the block's first area A_0, as a drained block takes up or gives off water while it is
   * strained; so the force has the potential
   *   U = A_0/A int_submerged rho_w g (h - y) dA.
   *
   * @param first_area A_0 [m2].  @param motion of the step, from the outline's places.
   */
  WaterLoad water_load(const Water        &water,
                       double              first_area,
                       const BlockMotion  &motion,
                       const MovedOutline &outline);


  /// U after less U before, of a block whose centroid moved by @p moved [m], the level being the
  /// same: without cancellation where it stays below one piece of the surface.
  double potential_change(const WaterLoad &before, const WaterLoad &after, const Vec2 &moved);


  /// Pore pressure at a place [Pa]; 0 above the surface, and where water acts no force.
  double pore_pressure(const Water &water, const Vec2 &place);


  /// Hydrostatic force on the nodes of the bedrock's surface (x0, y0, x1, ...) [N/m], those of the
  /// faces of elements of this @p degree: its virtual work is that of the pressure with their
  /// displacements, Lagrange polynomials along each face. Two nodes in one place are no face.
  Eigen::VectorXd
  water_on_surface(const Water &water, const std::vector<Vec2> &nodes, int degree = 1);

  /// The same into @p force, which allocates nothing if it has its size.
  void water_on_surface(const Water             &water,
                        const std::vector<Vec2> &nodes,
                        int                      degree,
                        Eigen::VectorXd         &force);
} // namespace hybrid::dda
