// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/tools.h>

#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/inertia_correction.h>

#include <algorithm>
#include <cmath>
#include <cstring>
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
                                 const CellMaterials             &material,
                                 const AffineConstraints<double> &supported,
                                 const Quadrature<1>             &points)
  {
    MatrixFree::AdditionalData settings;
    settings.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
    settings.mapping_update_flags  = update_values | update_gradients | update_JxW_values;
    loop.reinit(MappingQ1<2>(), dofs, supported, points, settings);
    take_materials(material);
  }



  void ElasticProduct::take_materials(const CellMaterials &material)
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



  template <typename Evaluation>
  void ElasticProduct::apply(const Weights &weights, Evaluation &cell) const
  {
    const unsigned int   batch    = cell.get_current_cell_index();
    const CellModuli    &of       = moduli[batch];
    const bool           corrects = weights.correction != 0. && !corrections.empty();
    AlignedVector<Lanes> values;
    if (corrects)
      {
        values.resize_fast(cell.dofs_per_cell);
        std::copy_n(cell.begin_dof_values(), cell.dofs_per_cell, values.begin());
      }
    const auto flags =
      (weights.stiffness != 0. ? EvaluationFlags::gradients : EvaluationFlags::nothing) |
      (weights.mass != 0. ? EvaluationFlags::values : EvaluationFlags::nothing);
    cell.evaluate(flags);
    if (weights.stiffness != 0.)
      submit_stress(cell, weights.stiffness * of.lambda, weights.stiffness * of.shear);
    if (weights.mass != 0.)
      for (unsigned int q = 0; q < cell.n_q_points; ++q)
        cell.submit_value(weights.mass * of.density * cell.get_value(q), q);
    cell.integrate(flags);
    if (corrects)
      corrections.add_product(batch, weights.correction, values.begin(), cell.begin_dof_values());
  }



  void ElasticProduct::multiply(const Weights &weights, const Vector &u, Vector &f) const
  {
    const std::function<void(const MatrixFree &, Vector &, const Vector &, const Range &)> add =
      [&](const MatrixFree &, Vector &force, const Vector &by, const Range &range) {
        CellEvaluation cell(loop);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            cell.reinit(batch);
            cell.read_dof_values(by);
            apply(weights, cell);
            cell.distribute_local_to_global(force);
          }
      };
    loop.cell_loop(add, f, u, true);
  }



  ElasticProduct::Vector ElasticProduct::diagonal(const Weights &weights) const
  {
    Vector result = make_vector();
    MatrixFreeTools::compute_diagonal<2, -1, 0, 2, double, Lanes>(
      loop, result, [&](CellEvaluation &cell) { apply(weights, cell); });
    for (const unsigned int i : loop.get_constrained_dofs())
      result.local_element(i) = 1.;
    return result;
  }



  CellCorrections::Key ElasticProduct::key(const unsigned int batch, const unsigned int lane) const
  {
    // Edges are told apart to 36 binary digits of the cell's size.
    const auto           cell    = loop.get_cell_iterator(batch, lane);
    const double         quantum = std::ldexp(1., std::ilogb(cell->diameter()) - 36);
    const CellModuli    &of      = moduli[batch];
    CellCorrections::Key result{};
    for (unsigned int v = 1; v < 4; ++v)
      for (unsigned int d = 0; d < 2; ++d)
        result[2 * (v - 1) + d] = std::lround((cell->vertex(v)[d] - cell->vertex(0)[d]) / quantum);
    const double kinds[3] = {of.lambda[lane], of.shear[lane], of.density[lane]};
    std::memcpy(&result[6], kinds, sizeof(kinds));
    return result;
  }



  void ElasticProduct::correct_inertia(const double step)
  {
    corrections = CellCorrections();
    CellEvaluation     cell(loop);
    const unsigned int n = cell.dofs_per_cell;
    for (unsigned int batch = 0; batch < loop.n_cell_batches(); ++batch)
      {
        const unsigned int             last = loop.n_active_entries_per_cell_batch(batch) - 1;
        std::array<int, Lanes::size()> numbers;
        for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
          {
            const auto kind = key(batch, std::min(lane, last));
            numbers[lane]   = corrections.find(kind);
            if (numbers[lane] >= 0)
              continue;
            Eigen::MatrixXd matrix[2]; // mass, stiffness
            cell.reinit(batch);
            for (int which = 0; which < 2; ++which)
              {
                matrix[which].resize(n, n);
                const Weights weights{which == 1 ? 1. : 0., which == 0 ? 1. : 0., 0.};
                for (unsigned int i = 0; i < n; ++i)
                  {
                    for (unsigned int j = 0; j < n; ++j)
                      cell.begin_dof_values()[j] = i == j ? 1. : 0.;
                    apply(weights, cell);
                    for (unsigned int j = 0; j < n; ++j)
                      matrix[which](j, i) = cell.begin_dof_values()[j][lane];
                  }
              }
            numbers[lane] = corrections.add(kind, inertia_correction(matrix[0], matrix[1], step));
          }
        corrections.append_batch(numbers);
      }
  }



  double ElasticProduct::memory() const
  {
    return static_cast<double>(loop.memory_consumption()) + corrections.memory();
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
