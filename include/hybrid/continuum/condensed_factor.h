// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/condensation.h>

#include <functional>

namespace hybrid::continuum
{
  /**
   * Supernodal Cholesky factor A = P^T L L^T P with the surface unknowns last, so that the trailing
   * block of L gives the condensed matrix, all entries of it: S = L_GG L_GG^T. A step
   * solves with L_II only, so it reads neither L_GG nor S here.
   *
   * Every rank factors the whole matrix on its own: at the sizes of a section (1e4 to 1e5 unknowns)
   * two triangular solves take a few milliseconds, less than a distributed factor would spend on
   * messages.
   */
  class CondensedFactorisation final : public Condensation
  {
  public:
    /**
     * @param column_start, row lower triangle by columns (diagonal included, rows ascending).
     * @param n_surface the last unknowns of the numbering are the surface's.
     */
    CondensedFactorisation(std::vector<int> column_start, std::vector<int> row, int n_surface);
    ~CondensedFactorisation() override;

    int size() const override;

    double factor_memory() const override;

    std::shared_ptr<Factor> factor(const std::vector<double> &values) override
    {
      return factor(values, nullptr);
    }

    /// b := A^-1 b, by products of dense matrices.
    using SolveMany = std::function<void(Eigen::MatrixXd &b)>;

    /// The same. @param use is told how to solve for many right-hand sides while the factor is
    /// made; nullptr: nobody asks
    std::shared_ptr<Factor> factor(const std::vector<double>                    &values,
                                   const std::function<void(const SolveMany &)> &use);

    /// S = L_GG L_GG^T.
    SurfaceStiffness surface_stiffness(const Factor &factor) const override;

    /// y = L_II^-1 b_I, g = b_G - L_GI y.
    void forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g) override;

    /// x_I = L_II^-T (y - L_GI^T x_G).
    void backward(Factor &factor, const Eigen::VectorXd &surface, std::vector<double> &x) override;

    void backward(Factor &factor, std::vector<double> &x) override;

    void solve_load_on_surface(Factor                &factor,
                               const Eigen::VectorXd &load,
                               std::vector<double>   &x) override;

    void solve(const Factor &factor, Eigen::MatrixXd &b) override;

  private:
    struct Cholmod;
    struct Parts;

    /// Take the interior's part and L_GG from the numbers of a whole factor.
    void take_parts(const double *values, Parts &parts) const;

    /// b := S^-1 b, unknowns of the surface.
    template <typename Values>
    static void solve_surface(const Parts &parts, Values &b);

    std::unique_ptr<Cholmod> cholmod;
  };
} // namespace hybrid::continuum
