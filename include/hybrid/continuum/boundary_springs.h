// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/lagrange_line.h>
#include <hybrid/continuum/node_matrices.h>
#include <hybrid/scene/types.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::continuum
{
  /**
   * The elastic part of a visco-elastic boundary: on each face the traction
   *   t = k (u_ff - u),  k = (G / r) (alpha_n n n^T + alpha_t (1 - n n^T)),
   * r the distance of the face from the load (Deeks & Randolph 1994 for the form, from a
   * cylindrical wave; Liu et al. 2006 for alpha_n = 1 and alpha_t = 0.5 in plane strain). A plane
   * wave that falls in normally is reflected by k / (2 i omega Z + k), Z the dashpots' impedance:
   * far from the load, and at high frequency, the boundary absorbs like one of dashpots alone.
   *
   * Vectors "on the boundary" are those of BoundaryForces.
   */
  class BoundarySprings
  {
  public:
    /// Springs on one face.
    struct Face
    {
      std::vector<int> nodes; ///< places on the boundary
      double           length;
      Eigen::Matrix2d  stiffness;    ///< k [Pa/m]
      bool             follows_free; ///< relative to the free field; else to the place at rest
    };

    /// Displacement on the boundary, and of the free field there [m].
    struct Displacement
    {
      const std::vector<double> &model;
      const std::vector<double> &free;
    };

    explicit BoundarySprings(const LagrangeLine &basis)
      : line(basis)
    {}

    bool empty() const
    {
      return faces.empty();
    }

    void add(Face face)
    {
      faces.push_back(std::move(face));
    }

    /// Add the springs to 2 x 2 blocks on the pattern of @p matrices; @p nodes of the boundary.
    void add_stiffness(const NodeMatrices     &matrices,
                       const std::vector<int> &nodes,
                       std::vector<double>    &blocks) const;

    /// Add the springs' forces on the model [N/m].
    void add_forces(const Displacement &u, std::vector<double> &force) const;

    /// int (da - da_ff) k (b - b_ff): with a change and a mean what the springs take up, with twice
    /// the same state twice their energy [J/m].
    double product(const Displacement &a, const Displacement &b) const;

  private:
    /// int N_i (u - u_ff) over the face for its node i.
    Vec2 relative(const Face &face, int i, const Displacement &u) const;

    LagrangeLine      line;
    std::vector<Face> faces;
  };
} // namespace hybrid::continuum
