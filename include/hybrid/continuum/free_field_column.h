// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/column_joints.h>
#include <hybrid/continuum/lagrange_line.h>
#include <hybrid/scene/maxwell_body.h>
#include <hybrid/scene/newmark.h>
#include <hybrid/scene/types.h>

#include <array>
#include <vector>

namespace hybrid::continuum
{
  /// What moves the foot of a column or the base of the model.
  enum class Foot
  {
    impedance,  ///< dashpots over a half space, traction 2 Z v_up
    prescribed, ///< given acceleration (zero: fixed)
  };


  /**
   * The ground beside the model: a horizontally layered column of unit width in which nothing
   * varies along x, so that u_x(y) is a shear wave and u_y(y) a P wave,
   *   rho u_x'' = (G u_x,y),y   rho u_y'' = ((lambda + 2 G) u_y,y),y,
   * with the same elements along y, the same Newmark scheme, inertia and damping as the model's
   * side. Where a bedding plane meets the side two nodes lie at one place, held together by the
   * joint of the plane (ColumnJoints). Free on top.
   */
  class FreeFieldColumn
  {
  public:
    struct Element
    {
      double bottom, top; ///< [m]
      double density;     ///< [kg/m3]
      double lambda;      ///< [Pa]
      double shear;       ///< G [Pa]
    };

    struct Model
    {
      std::vector<Element> elements; ///< from the foot to the top
      Foot                 foot = Foot::impedance;
      Vec2                 foot_impedance{0., 0.}; ///< rho c_s, rho c_p of the rock below [Pa s/m]
      Newmark              newmark;
      double               rayleigh_mass = 0., rayleigh_stiffness = 0.;
      MaxwellBody          maxwell;
      ColumnJoints::Model  joints;
      bool                 joints_relax = true; ///< elastic ones take Maxwell damping with the rock
    };

    /// What acts on the foot at the end of a step.
    struct Input
    {
      Vec2 wave_velocity{0., 0.}; ///< v_up [m/s], for Foot::impedance
      Vec2 acceleration{0., 0.};  ///< [m/s2], for Foot::prescribed
    };

    FreeFieldColumn(const LagrangeLine &line, Model model);

    int n_nodes() const
    {
      return n;
    }

    /// The first node of element @p e.
    int first_node(const int e) const
    {
      return e * width + joints.below(e);
    }

    ColumnJoints &plane_joints()
    {
      return joints;
    }

    const ColumnJoints &plane_joints() const
    {
      return joints;
    }

    const Model &description() const
    {
      return model;
    }

    /// Motion of all nodes from the foot up: pointers to (x0, y0, x1, y1, ...).
    struct Motion
    {
      double *u, *v, *a;
      double *change = nullptr; ///< of a that is remembered, for a Newmark::filter only
      double *branch = nullptr; ///< strains of the Maxwell branches, MaxwellState::strain [m]
    };

    struct ConstMotion
    {
      const double *u, *v, *a;
      const double *change    = nullptr; ///< of a that was remembered
      double        last_step = 0.;      ///< of it [s]
      const double *branch    = nullptr; ///< as of Motion
      std::size_t   stride    = 0;       ///< from one branch to the next, in both
    };

    /// One Newmark step; with beta = 0 one of central differences, which takes a basis whose mass
    /// is by Lobatto's quadrature.
    /// @param slip of the joints at the start, if they may slip
    /// @return false if their slip was not found.
    bool step(const ConstMotion &old,
              const Motion      &next,
              double             dt,
              const Input       &input,
              const SlipState   *slip = nullptr);

  private:
    /// The matrix A = K + M/(beta dt^2) + gamma/(beta dt) C of a step; shear, P.
    struct Factor
    {
      double                         dt = 0.;
      std::array<Eigen::MatrixXd, 2> matrix; ///< its Cholesky factor
      std::array<Eigen::VectorXd, 2> foot;   ///< its first column, of the foot
      ColumnJoints::Response         response;
    };

    const Factor &factor_for(double dt);

    /// By damping, of the joints' stiffness in a step [-].
    double excess(double dt) const;

    /// Motion of component @p c in an implicit step without the joints, into u.
    void step_alone(const ConstMotion &old, double dt, const Input &input, int c);

    /// Write component @p c of an implicit step, whose end is u.
    void finish(const ConstMotion &old, const Motion &next, double dt, int c) const;

    void step_explicitly(const ConstMotion &old, const Motion &next, double dt, const Input &input);

    /// What strains component @p c in an explicit step, into past; its branches move on.
    void strain_explicitly(const ConstMotion &old, const Motion &next, double dt, int c);

    /// Less the strain of the branches in a step in which component @p c goes to zero, into past.
    void find_past(const ConstMotion &old, double dt, int c);

    /// Branches of component @p c at the end of a step.
    void advance(const ConstMotion &old, const Motion &next, double dt, int c) const;

    // Matrices are in LAPACK's lower band storage: band(r, j) = A(j + r, j).
    Model                          model;
    ColumnJoints                   joints;
    int                            width, n;
    Eigen::MatrixXd                mass;
    std::array<Eigen::MatrixXd, 2> stiffness;                ///< shear, P
    std::array<Eigen::MatrixXd, 2> inertia_correction;       ///< shear, P; see inertia_correction.h
    std::vector<Factor>            factors;                  ///< the last few step sizes
    ColumnJoints::Nodal            predicted, rate, u, past; ///< u: forces before
  };
} // namespace hybrid::continuum
