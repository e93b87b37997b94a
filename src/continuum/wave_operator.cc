// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <deal.II/lac/affine_constraints.h>

#include <deal.II/matrix_free/fe_evaluation.h>

#include <hybrid/continuum/wave_operator.h>

#include <algorithm>
#include <numeric>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    using Evaluation = FEEvaluation<2, -1, 0, 2, double>;
  } // namespace



  WaveOperator::WaveOperator(const ElementSpace          &space,
                             const std::vector<Material> &material,
                             const MPI_Comm               communicator)
    : triangulation(communicator)
    , fe(FE_Q<2>(space.nodes.line.degree()), 2)
    , dof_handler(triangulation)
  {
    assert(material.size() == space.nodes.cells.size());
    {
      Triangulation<2> whole;
      whole.copy_triangulation(space.triangulation);
      GridTools::partition_triangulation(Utilities::MPI::n_mpi_processes(communicator), whole);
      triangulation.create_triangulation(
        TriangulationDescription::Utilities::create_description_from_triangulation(whole,
                                                                                   communicator));
    }
    dof_handler.distribute_dofs(fe);
    number_unknowns(space);

    AffineConstraints<double> none;
    none.close();
    MatrixFree::AdditionalData settings;
    settings.tasks_parallel_scheme = MatrixFree::AdditionalData::none;
    settings.mapping_update_flags  = update_values | update_gradients | update_JxW_values;
    loop.reinit(
      MappingQ1<2>(), dof_handler, none, QGaussLobatto<1>(space.nodes.line.degree() + 1), settings);
    take_materials(material);

    Vector mass = make_vector(), unused = make_vector();
    loop.cell_loop(&WaveOperator::add_mass, this, mass, unused, true);
    diagonal_mass.assign(mass.begin(), mass.end());
  }



  void WaveOperator::number_unknowns(const ElementSpace &space)
  {
    const IndexSet                      &mine  = dof_handler.locally_owned_dofs();
    const types::global_dof_index        first = mine.n_elements() > 0 ? *mine.begin() : 0;
    std::vector<int>                     ours(mine.n_elements(), -1);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          const auto &nodes = space.nodes.cells[cell->id().get_coarse_cell_id()];
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (mine.is_element(dofs[i]))
              {
                const auto [component, index] = fe.system_to_component_index(i);
                ours[dofs[i] - first] =
                  2 * nodes[space.local_node[index]] + static_cast<int>(component);
              }
        }
    std::vector<int> order(ours.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const int a, const int b) {
      return ours[a] < ours[b];
    });
    std::vector<types::global_dof_index> number(ours.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      {
        number[order[k]] = first + k;
        owned.push_back(ours[order[k]]);
      }
    dof_handler.renumber_dofs(number);
  }



  void WaveOperator::take_materials(const std::vector<Material> &material)
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



  WaveOperator::Vector WaveOperator::make_vector() const
  {
    Vector vector;
    loop.initialize_dof_vector(vector);
    return vector;
  }



  void WaveOperator::elastic_force(Vector &u, Vector &f) const
  {
    loop.cell_loop(&WaveOperator::add_elastic_force, this, f, u, true);
  }



  void WaveOperator::add_elastic_force(const MatrixFree &,
                                       Vector       &f,
                                       const Vector &u,
                                       const Range  &range) const
  {
    Evaluation cell(loop);
    for (unsigned int batch = range.first; batch < range.second; ++batch)
      {
        const Lanes lambda = -moduli[batch].lambda, shear = -moduli[batch].shear;
        cell.reinit(batch);
        cell.gather_evaluate(u, EvaluationFlags::gradients);
        for (unsigned int q = 0; q < cell.n_q_points; ++q)
          {
            const auto                        gradient = cell.get_gradient(q);
            const Lanes                       volume   = lambda * (gradient[0][0] + gradient[1][1]);
            const Lanes                       slant    = shear * (gradient[0][1] + gradient[1][0]);
            Tensor<1, 2, Tensor<1, 2, Lanes>> stress;
            stress[0][0] = volume + 2. * shear * gradient[0][0];
            stress[1][1] = volume + 2. * shear * gradient[1][1];
            stress[0][1] = stress[1][0] = slant;
            cell.submit_gradient(stress, q);
          }
        cell.integrate_scatter(EvaluationFlags::gradients, f);
      }
  }



  void
  WaveOperator::add_mass(const MatrixFree &, Vector &mass, const Vector &, const Range &range) const
  {
    Evaluation cell(loop);
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
