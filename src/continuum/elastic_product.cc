// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/tools.h>

#include <hybrid/continuum/elastic_product.h>

#include <algorithm>
#include <functional>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    using CellEvaluation = FEEvaluation<2, -1, 0, 2, double>;

    /// From the gradients of the displacement on the points to the stresses there.
    void submit_stress(CellEvaluation                &cell,
                       const VectorizedArray<double> &lambda,
                       const VectorizedArray<double> &shear)
    {
      for (unsigned int q = 0; q < cell.n_q_points; ++q)
        {
          const auto gradient = cell.get_gradient(q);
          const auto volume   = lambda * (gradient[0][0] + gradient[1][1]);
          const auto slant    = shear * (gradient[0][1] + gradient[1][0]);
          Tensor<1, 2, Tensor<1, 2, VectorizedArray<double>>> stress;
          stress[0][0] = volume + 2. * shear * gradient[0][0];
          stress[1][1] = volume + 2. * shear * gradient[1][1];
          stress[0][1] = stress[1][0] = slant;
          cell.submit_gradient(stress, q);
        }
    }
  } // namespace



  ElasticProduct::ElasticProduct(const DoFHandler<2>             &dofs,
                                 const std::vector<Material>     &material,
                                 const AffineConstraints<double> &supported,
                                 const Quadrature<1>             &points)
  {
    MatrixFree::AdditionalData settings;
    settings.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
    settings.mapping_update_flags  = update_values | update_gradients | update_JxW_values;
    loop.reinit(MappingQ1<2>(), dofs, supported, points, settings);
    take_materials(material);
  }



  void ElasticProduct::take_materials(const std::vector<Material> &material)
  {
    moduli.resize(loop.n_cell_batches());
    for (unsigned int batch = 0; batch < loop.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
        {
          const unsigned int last     = loop.n_active_entries_per_cell_batch(batch) - 1;
          const auto         cell     = loop.get_cell_iterator(batch, std::min(lane, last));
          const Material    &of       = material[cell->id().get_coarse_cell_id()];
          moduli[batch].lambda[lane]  = of.lame_lambda();
          moduli[batch].shear[lane]   = of.shear_modulus();
          moduli[batch].density[lane] = of.density;
        }
  }



  ElasticProduct::Vector ElasticProduct::make_vector() const
  {
    Vector vector;
    loop.initialize_dof_vector(vector);
    return vector;
  }



  void ElasticProduct::multiply(const double factor, const Vector &u, Vector &f) const
  {
    const std::function<void(const MatrixFree &, Vector &, const Vector &, const Range &)> add =
      [&](const MatrixFree &, Vector &force, const Vector &by, const Range &range) {
        CellEvaluation cell(loop);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            cell.reinit(batch);
            cell.gather_evaluate(by, EvaluationFlags::gradients);
            submit_stress(cell, factor * moduli[batch].lambda, factor * moduli[batch].shear);
            cell.integrate_scatter(EvaluationFlags::gradients, force);
          }
      };
    loop.cell_loop(add, f, u, true);
  }



  ElasticProduct::Vector ElasticProduct::diagonal() const
  {
    Vector result = make_vector();
    MatrixFreeTools::compute_diagonal<2, -1, 0, 2, double, Lanes>(
      loop, result, [this](CellEvaluation &cell) {
        const CellModuli &of = moduli[cell.get_current_cell_index()];
        cell.evaluate(EvaluationFlags::gradients);
        submit_stress(cell, of.lambda, of.shear);
        cell.integrate(EvaluationFlags::gradients);
      });
    for (const unsigned int i : loop.get_constrained_dofs())
      result.local_element(i) = 1.;
    return result;
  }



  ElasticProduct::Vector ElasticProduct::masses() const
  {
    Vector mass = make_vector(), unused = make_vector();
    loop.cell_loop(&ElasticProduct::add_masses, this, mass, unused, true);
    return mass;
  }



  void ElasticProduct::add_masses(const MatrixFree &,
                                  Vector &mass,
                                  const Vector &,
                                  const Range &range) const
  {
    CellEvaluation cell(loop);
    for (unsigned int batch = range.first; batch < range.second; ++batch)
      {
        Tensor<1, 2, Lanes> density;
        density[0] = density[1] = moduli[batch].density;
        cell.reinit(batch);
        for (unsigned int q = 0; q < cell.n_q_points; ++q)
          cell.submit_value(density, q);
        cell.integrate_scatter(EvaluationFlags::values, mass);
      }
  }
} // namespace hybrid::continuum
