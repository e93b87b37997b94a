// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/banded_condensation.h>
#include <hybrid/continuum/surface_band.h>

#include <algorithm>

namespace hybrid::continuum
{
  struct BandedCondensation::Parts final : Factor
  {
    std::shared_ptr<Factor> interior; ///< of A_II
    std::vector<double>     coupling; ///< entries of A_GI
    Eigen::MatrixXd         band;     ///< of S
    Eigen::MatrixXd         factor;   ///< of the band

    static Parts &of(Factor &factor)
    {
      return static_cast<Parts &>(factor);
    }

    static const Parts &of(const Factor &factor)
    {
      return static_cast<const Parts &>(factor);
    }
  };



  std::vector<double> BandedCondensation::Pattern::values(const std::vector<double> &all) const
  {
    std::vector<double> result(source.size());
    for (std::size_t k = 0; k < source.size(); ++k)
      result[k] = all[source[k]];
    return result;
  }



  BandedCondensation::BandedCondensation(const std::vector<int> &column_start,
                                         const std::vector<int> &row,
                                         const int               surface_unknowns,
                                         const int               reach)
    : n_interior(static_cast<int>(column_start.size()) - 1 - surface_unknowns)
    , n_surface(surface_unknowns)
    , expected_reach(std::min(reach, surface_unknowns - 1))
    , load(n_interior, 0.)
    , solution(n_interior, 0.)
    , surface_load(Eigen::VectorXd::Zero(surface_unknowns))
    , motion(Eigen::VectorXd::Zero(surface_unknowns))
    , none(0)
  {
    for (int j = 0; j < size(); ++j)
      {
        for (int e = column_start[j]; e < column_start[j + 1]; ++e)
          {
            const bool on_surface = row[e] >= n_interior;
            Pattern   &pattern =
              j >= n_interior ? of_surface : (on_surface ? of_coupling : of_interior);
            pattern.row.push_back(on_surface ? row[e] - n_interior : row[e]);
            pattern.source.push_back(e);
          }
        if (j >= n_interior)
          of_surface.column_start.push_back(static_cast<int>(of_surface.row.size()));
        else
          for (Pattern *pattern : {&of_interior, &of_coupling})
            pattern->column_start.push_back(static_cast<int>(pattern->row.size()));
      }
    interior =
      std::make_unique<CondensedFactorisation>(of_interior.column_start, of_interior.row, 0);
  }



  double BandedCondensation::factor_memory() const
  {
    // S, a copy of it and its factor; right-hand sides, their solutions and work while S is found.
    const double band = 3. * (expected_reach + 1.) * n_surface;
    const double work = 3. * columns_of_product * static_cast<double>(size());
    return interior->factor_memory() +
           sizeof(double) * (band + work + 2. * static_cast<double>(of_interior.row.size()));
  }



  std::shared_ptr<Condensation::Factor>
  BandedCondensation::factor(const std::vector<double> &values)
  {
    auto       result        = std::make_shared<Parts>();
    const auto surface       = of_surface.values(values);
    result->coupling         = of_coupling.values(values);
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n_surface);
    for (int j = 0; j < n_surface; ++j)
      diagonal[j] = surface[of_surface.column_start[j]];
    result->interior = interior->factor(
      of_interior.values(values), [&](const CondensedFactorisation::SolveMany &solve) {
        result->band = surface_band(
          [&](const Eigen::MatrixXd &x) { return product(surface, *result, solve, x); }, diagonal);
      });
    result->factor = result->band;
    factorise_band(result->factor);
    return result;
  }



  Eigen::MatrixXd BandedCondensation::product(const std::vector<double>               &surface,
                                              const Parts                             &parts,
                                              const CondensedFactorisation::SolveMany &solve,
                                              const Eigen::MatrixXd                   &x) const
  {
    Eigen::MatrixXd inside = Eigen::MatrixXd::Zero(n_interior, x.cols());
    Eigen::MatrixXd y      = Eigen::MatrixXd::Zero(n_surface, x.cols());
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      {
        subtract_from_interior(parts, x.col(k).data(), inside.col(k).data());
        for (int j = 0; j < n_surface; ++j)
          for (int e = of_surface.column_start[j]; e < of_surface.column_start[j + 1]; ++e)
            {
              const int i = of_surface.row[e];
              y(i, k) += surface[e] * x(j, k);
              if (i != j)
                y(j, k) += surface[e] * x(i, k);
            }
      }
    solve(inside); // -A_II^-1 A_IG x
    inside = -inside;
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      subtract_from_surface(parts, inside.col(k).data(), y.col(k).data());
    return y;
  }



  void
  BandedCondensation::subtract_from_surface(const Parts &parts, const double *x, double *g) const
  {
    for (int j = 0; j < n_interior; ++j)
      for (int e = of_coupling.column_start[j]; e < of_coupling.column_start[j + 1]; ++e)
        g[of_coupling.row[e]] -= parts.coupling[e] * x[j];
  }



  void BandedCondensation::subtract_from_interior(const Parts  &parts,
                                                  const double *surface,
                                                  double       *b) const
  {
    for (int j = 0; j < n_interior; ++j)
      for (int e = of_coupling.column_start[j]; e < of_coupling.column_start[j + 1]; ++e)
        b[j] -= parts.coupling[e] * surface[of_coupling.row[e]];
  }



  SurfaceStiffness BandedCondensation::surface_stiffness(const Factor &factor) const
  {
    return {Parts::of(factor).band, true};
  }



  void BandedCondensation::forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g)
  {
    Parts &parts = Parts::of(factor);
    interior->forward(*parts.interior, b, none);
    interior->backward(*parts.interior, none, solution);
    std::copy(b.begin(), b.begin() + n_interior, load.begin());
    g = Eigen::Map<const Eigen::VectorXd>(b.data() + n_interior, n_surface);
    subtract_from_surface(parts, solution.data(), g.data());
    surface_load = g;
  }



  void BandedCondensation::solve_interior(Parts                 &parts,
                                          const Eigen::VectorXd &surface,
                                          std::vector<double>   &x)
  {
    subtract_from_interior(parts, surface.data(), solution.data());
    interior->forward(*parts.interior, solution, none);
    interior->backward(*parts.interior, none, x);
    std::copy(surface.begin(), surface.end(), x.begin() + n_interior);
  }



  void BandedCondensation::backward(Factor                &factor,
                                    const Eigen::VectorXd &surface,
                                    std::vector<double>   &x)
  {
    solution = load;
    solve_interior(Parts::of(factor), surface, x);
  }



  void BandedCondensation::backward(Factor &factor, std::vector<double> &x)
  {
    Parts &parts = Parts::of(factor);
    motion       = surface_load;
    solve_band(parts.factor, motion.data());
    solution = load;
    solve_interior(parts, motion, x);
  }



  void BandedCondensation::solve_load_on_surface(Factor                &factor,
                                                 const Eigen::VectorXd &load_on_surface,
                                                 std::vector<double>   &x)
  {
    Parts &parts = Parts::of(factor);
    motion       = load_on_surface;
    solve_band(parts.factor, motion.data());
    std::fill(solution.begin(), solution.end(), 0.);
    solve_interior(parts, motion, x);
  }



  void BandedCondensation::solve(const Factor &factor, Eigen::MatrixXd &b)
  {
    const Parts    &parts  = Parts::of(factor);
    Eigen::MatrixXd inside = b;
    interior->solve(*parts.interior, inside);
    for (Eigen::Index k = 0; k < b.cols(); ++k)
      {
        double *surface = b.col(k).data() + n_interior;
        subtract_from_surface(parts, inside.col(k).data(), surface);
        solve_band(parts.factor, surface);
        subtract_from_interior(parts, surface, b.col(k).data());
      }
    interior->solve(*parts.interior, b);
  }
} // namespace hybrid::continuum
