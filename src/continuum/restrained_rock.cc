// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <hybrid/continuum/restrained_rock.h>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    constexpr int    most_iterations  = 1000;
    constexpr double residual_left    = 1e-12; ///< over that of u = 0
    constexpr int    smoothing_degree = 5;
    constexpr double smoothing_range  = 20.; ///< largest eigenvalue over the least that is smoothed
    constexpr int    steps_to_largest = 20;  ///< of Lanczos, to the largest eigenvalue
  }                                          // namespace



  RestrainedRock::RestrainedRock(const RestrainedModel &model)
    : unknowns(model.shared.unknowns())
    , stiffness(model)
    , coarse(model)
  {
    Smoother::AdditionalData settings;
    settings.degree              = smoothing_degree;
    settings.smoothing_range     = smoothing_range;
    settings.eig_cg_n_iterations = steps_to_largest;
    settings.preconditioner      = std::make_shared<Diagonal>(stiffness.diagonal());
    for (double &x : settings.preconditioner->get_vector())
      x = 1. / x;
    smoother.initialize(stiffness, settings);
  }



  void RestrainedRock::Preconditioner::vmult(Vector &u, const Vector &residual) const
  {
    rock.smoother.vmult(u, residual);
    rock.stiffness.vmult(work, u);
    work.sadd(-1., 1., residual);
    rock.stiffness.support(work);
    rock.coarse.correct(work, u);
    rock.smoother.step(u, residual);
  }



  RestrainedRock::Solution RestrainedRock::solve(const std::vector<double> &load) const
  {
    Vector f = stiffness.make_vector(), u = f, work = f;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      f.local_element(i) = load[unknowns[i]];
    stiffness.support(f);
    ReductionControl control(most_iterations, 0., residual_left);
    SolverCG<Vector> solver(control);
    Solution         result;
    try
      {
        solver.solve(stiffness, u, f, Preconditioner{*this, work});
        result.converged = true;
      }
    catch (const SolverControl::NoConvergence &)
      {}
    result.iterations = static_cast<int>(control.last_step());
    result.displacement.assign(u.begin(), u.end());
    return result;
  }
} // namespace hybrid::continuum
