// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/slip_solver.h>
#include <hybrid/continuum/slip_state.h>
#include <hybrid/scene/types.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace hybrid::continuum
{
  /// Where a bedding plane crosses a free-field column.
  struct ColumnJoint
  {
    int  element = 0;     ///< the first one above it
    Vec2 tangent{1., 0.}; ///< of the plane, towards +x
    int  point = -1;      ///< the one of BeddingPlanes next to the column
  };


  /**
   * The joints of the bedding planes in a free-field column, as BeddingPlanes has them in the rock:
   * the jump j of the part above against that below is the same all along the plane, of which a
   * column of unit width has the length 1 / cos(inclination). So the tractions are t = D (j - p),
   * (normal, tension positive; shear) along the plane, and the column's parts bear t over that
   * length. D = (k_n, k_s); p, opening and slip, is zero without strength.
   *
   * The column's matrices know nothing of the joints. With C the jumps that tractions of one take
   * back in a step (D^-1 + C)^-1 = G is what BeddingPlanes calls relaxation, and
   *   t = G (j_0 - p),   j_0 the jumps of the parts that nothing joins.
   */
  class ColumnJoints
  {
  public:
    struct Model
    {
      std::vector<ColumnJoint>     joints; ///< from the foot to the top
      JointStiffness               stiffness;
      std::optional<PlaneStrength> strength; ///< none: elastic
    };

    /// Unknowns of all nodes of the column: x, y.
    using Nodal = std::array<Eigen::VectorXd, 2>;

    /// @param degree of the column's elements
    ColumnJoints(Model model, int degree);

    bool empty() const
    {
      return model.joints.empty();
    }

    int count() const
    {
      return static_cast<int>(model.joints.size());
    }

    bool slips() const
    {
      return model.strength.has_value() && !empty();
    }

    /// Joints below element @p e, so many nodes more than elements share.
    int below(int e) const;

    /// How a column answers its joints in a step of one size.
    struct Response
    {
      /// Of each joint: what a pair of unit forces that pulls its sides apart does to all nodes,
      /// along x and along y [m per Pa].
      std::array<Eigen::MatrixXd, 2> motion;
      Eigen::MatrixXd                relaxation; ///< G [Pa/m]
    };

    /// Forces on the nodes above (1) and below (-1) joint @p joint.
    void pull_apart(int joint, Eigen::VectorXd &force) const;

    /// Complete a response whose motion is known. @param excess of the joints' stiffness in a step
    /// over D, by damping [-]
    void find_relaxation(double excess, Response &response) const;

    /// Tractions at rest on the points of BeddingPlanes [Pa], and which have failed.
    void set_rest(const std::vector<double> &traction, const std::vector<char> &failed);

    SlipState initial_state() const;

    /// Join the parts of @p u, found without joints [m], in a step.
    /// @param slack displacement at which joints that damp bear nothing [m]; null: zero
    /// @param slip at the start of the step; not asked for without strength
    /// @return false if no slip was found that the strength allows.
    bool join(const Response &response, const Nodal *slack, const SlipState *slip, Nodal &u);

    /// Write the slip of the last join() into the state.
    void keep(SlipState &state) const;

    /// Add the forces of elastic joints under the jumps of @p u [Pa].
    void add_forces(const Nodal &u, Nodal &force);

  private:
    Model            model;
    std::vector<int> above; ///< node; the one below it is the one before

    /// jump += factor times the jumps of @p u along normal and tangent.
    void add_jumps(const Nodal &u, double factor);

    /// The force per unit width of a traction.
    Vec2 force_of(int joint, const Eigen::VectorXd &traction) const;

    Vec2 normal(const int joint) const
    {
      return {-model.joints[joint].tangent.y(), model.joints[joint].tangent.x()};
    }

    std::optional<SlipSolver> solver;
    std::vector<double>       rest; ///< tractions at rest [Pa]
    std::vector<char>         rest_failed, failed;
    Eigen::VectorXd           jump, traction;
  };
} // namespace hybrid::continuum
