// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/slip_state.h>

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <vector>

namespace hybrid::scene
{
  struct BeddingParameters;
}

namespace hybrid::continuum
{
  /// Mohr-Coulomb strength of a bedding plane.
  struct PlaneStrength
  {
    double friction = 0.; ///< tan phi [-]
    double cohesion = 0.; ///< c [Pa]
    double tension  = 0.; ///< F_t [Pa], at most c / tan phi
  };

  /// Of the scene's planes; none if they are elastic.
  std::optional<PlaneStrength> strength_of(const scene::BeddingParameters &bedding);


  /**
   * Mohr-Coulomb slip with tension cut-off at all points of the bedding planes at once.
   *
   * Unknown is the plastic jump p = (opening o, slip s) of each point at the end of a step; the
   * tractions (sigma, tension positive, and tau) follow from it through the rock around,
   *   t = t_0 - G (p - p_0),  G = D - D B A^-1 B^T W D  (bedding_planes.h).
   * - Intact: o = 0 and sigma <= F_t; |tau| <= c - sigma tan phi, slip only at the limit, in the
   *   direction of tau.
   * - Once sigma exceeds F_t the point has failed: c = F_t = 0, o >= 0, sigma <= 0, o sigma = 0.
   *   It closes again where it was and has friction then.
   * Slip does not dilate. These complementarity conditions are solved by semismooth Newton (Alart &
   * Curnier 1991; as primal-dual active set Hintermueller, Ito & Kunisch 2003): the conditions of
   * all points are guessed from t + diag(G) p, the linear system of the points at their limit is
   * solved exactly, until no condition changes; where that goes round in circles, sweeps of
   * projected Gauss-Seidel point by point (Jean 1999) come between.
   */
  class SlipSolver
  {
  public:
    SlipSolver(std::size_t n_points, const PlaneStrength &strength);

    /// The step's problem; vectors "on the points" of BeddingPlanes.
    struct Problem
    {
      const Eigen::MatrixXd     &relaxation; ///< G [Pa/m]
      const Eigen::VectorXd     &traction;   ///< t_0 [Pa]
      const std::vector<double> &old;        ///< p_0 [m], at the start of the step
    };

    /// @param failed per point; points that break are added.
    /// @return false if the conditions did not settle or the planes carry no more load.
    bool solve(const Problem &problem, std::vector<char> &failed);

    /// p at the end of the step [m].
    const std::vector<double> &jump() const
    {
      return plastic;
    }

    const std::vector<PlaneCondition> &conditions() const
    {
      return condition;
    }

    int iterations() const
    {
      return count;
    }

    /// Shear traction of an intact point beyond c - sigma tan(phi) [Pa].
    double excess(const double sigma, const double tau) const
    {
      return std::abs(tau) + sigma * strength.friction - strength.cohesion;
    }

    /// Tension at which a point breaks: F_t, at most c / tan phi [Pa].
    double cut_off() const
    {
      return strength.tension;
    }

  private:
    void guess(const Problem &problem, const std::vector<char> &failed);
    bool solve_limits(const Problem &problem, const std::vector<char> &failed);
    void sweep(const Problem &problem, const std::vector<char> &failed);
    bool settle(const Problem &problem, const std::vector<char> &failed);

    PlaneStrength               strength;
    std::vector<PlaneCondition> condition;
    std::vector<signed char> direction, old_direction; ///< of slip: -1, 0, 1; 2: no strength left
    std::vector<PlaneCondition> old_condition;
    std::vector<double>         plastic;
    std::vector<int>            active; ///< components at their limit
    Eigen::VectorXd             t, change, rhs;
    Eigen::MatrixXd             system;
    double                      min_margin = 0.; ///< a condition changes beyond its bound only [Pa]
    double                      stiffest   = 0.; ///< largest diagonal entry of G [Pa/m]
    int                         count      = 0;
  };
} // namespace hybrid::continuum
