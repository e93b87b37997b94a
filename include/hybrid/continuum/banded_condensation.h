// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/condensed_factor.h>

namespace hybrid::continuum
{
  /**
   * Condensation onto a long surface: a sparse factor of the interior alone, and of S the band that
   * counts (surface_band()), with its Cholesky factor. Nothing is as large as the square of the
   * surface. A step solves twice with A_II, where CondensedFactorisation does once.
   */
  class BandedCondensation final : public Condensation
  {
  public:
    /**
     * @param column_start, row lower triangle by columns (diagonal included, rows ascending).
     * @param n_surface the last unknowns of the numbering are the surface's, from one end to the
     * other.
     * @param expected_reach how far entries of S reach, for factor_memory().
     */
    BandedCondensation(const std::vector<int> &column_start,
                       const std::vector<int> &row,
                       int                     n_surface,
                       int                     expected_reach);

    int size() const override
    {
      return n_interior + n_surface;
    }

    double factor_memory() const override;

    std::shared_ptr<Factor> factor(const std::vector<double> &values) override;

    SurfaceStiffness surface_stiffness(const Factor &factor) const override;

    void forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g) override;

    void backward(Factor &factor, const Eigen::VectorXd &surface, std::vector<double> &x) override;

    void backward(Factor &factor, std::vector<double> &x) override;

    void solve_load_on_surface(Factor                &factor,
                               const Eigen::VectorXd &load,
                               std::vector<double>   &x) override;

    void solve(const Factor &factor, Eigen::MatrixXd &b) override;

  private:
    struct Parts;

    /// Entries of A by columns, and where they are among those of the whole matrix.
    struct Pattern
    {
      std::vector<int> column_start = {0}, row, source;

      std::vector<double> values(const std::vector<double> &all) const;
    };

    int                                     n_interior, n_surface, expected_reach;
    Pattern                                 of_interior; ///< A_II, lower triangle
    Pattern                                 of_coupling; ///< A_GI, rows counted in the surface
    Pattern                                 of_surface;  ///< A_GG, lower triangle, likewise
    std::unique_ptr<CondensedFactorisation> interior;
    std::vector<double>                     load, solution; ///< b_I of the step, and A_II^-1 of it
    Eigen::VectorXd                         surface_load;   ///< g of forward()
    Eigen::VectorXd                         motion;         ///< of the surface, solved for
    Eigen::VectorXd                         none;           ///< the interior's own surface

    /// S times columns. @param solve b := A_II^-1 b
    Eigen::MatrixXd product(const std::vector<double>                    &surface,
                            const Parts                                  &parts,
                            const std::function<void(Eigen::MatrixXd &)> &solve,
                            const Eigen::MatrixXd                        &x) const;

    /// g -= A_GI x_I. @param x, g numbers of one vector
    void subtract_from_surface(const Parts &parts, const double *x, double *g) const;

    /// b_I -= A_IG x_G.
    void subtract_from_interior(const Parts &parts, const double *surface, double *b) const;

    /// x_I = A_II^-1 load, x_G = the surface's.
    void solve_interior(Parts &parts, const Eigen::VectorXd &surface, std::vector<double> &x);
  };
} // namespace hybrid::continuum
