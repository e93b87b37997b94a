// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/element_nodes.h>
#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/node_matrices.h>
#include <hybrid/continuum/rock_mesh.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace hybrid::continuum
{
  /**
   * The joints along bedding planes seen as points: at the Gauss points that integrate the elastic
   * joints of assemble_elastic() exactly, the displacement jump is j = B u and the traction
   * t = D (j - p), p the plastic part. So the joints' forces on the nodes are -B^T W t, W the
   * lengths of the points, and with p = 0 they equal the joints' part of K to round-off.
   *
   * Vectors "on the points" hold two numbers per point: opening and slip of the jump [m], or normal
   * (tension positive) and shear traction [Pa]. The tangent of a point runs to +x (upwards where
   * the plane is vertical), the normal is to its left, and the jump is that of the side to the left
   * against the other.
   */
  class BeddingPlanes
  {
  public:
    /// A Gauss point.
    struct Point
    {
      Vec2   position; ///< [m]
      Vec2   tangent, normal;
      double length; ///< its share of the plane [m]
      int    plane;  ///< FacePair::plane
      int    sample; ///< which Gauss point of its face
      int    first;  ///< of the face's node pairs
    };

    BeddingPlanes(const RockMesh &rock, const ElementNodes &nodes, const JointStiffness &stiffness);

    const std::vector<Point> &points() const
    {
      return gauss;
    }

    const JointStiffness &stiffness() const
    {
      return k;
    }

    /// j = B u on the points.
    void jumps(const std::vector<double> &u, std::vector<double> &jump) const;

    /// Largest |u| of the planes' nodes [m].
    double largest_displacement(const std::vector<double> &u) const;

    /// t = D j.
    void tractions(const std::vector<double> &jump, std::vector<double> &traction) const;

    /// f += factor B^T W t.
    void add_forces(const std::vector<double> &traction,
                    double                     factor,
                    std::vector<double>       &force) const;

    /// Add factor B^T W D B to 2 x 2 blocks on the pattern of @p matrices.
    void
    add_stiffness(const NodeMatrices &matrices, double factor, std::vector<double> &blocks) const;

    /// Nodes on the two sides (that to the left of the tangent first) whose jump is independent.
    const std::vector<std::array<int, 2>> &node_pairs() const
    {
      return pairs;
    }

    /**
     * G = D - D B X B^T W D from the compliance of the node pairs: what the tractions lose per
     * plastic jump.
     * @param compliance of the pairs' jumps (x0, y0, x1, ...) to forces on them [m per N/m].
     */
    Eigen::MatrixXd relaxation(const Eigen::MatrixXd &compliance) const;

  private:
    LagrangeLine                    line;
    JointStiffness                  k;
    std::vector<Point>              gauss;
    std::vector<std::array<int, 2>> pairs;
    std::vector<int>                pair_of; ///< per node of each face: place in pairs, -1: a tip
    std::vector<double>             shape;   ///< N_i at Gauss point q: shape[q (p + 1) + i]
    int                             n = 0;   ///< nodes per face

    Eigen::MatrixXd jump_matrix() const;
  };
} // namespace hybrid::continuum
