// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <hybrid/continuum/coarse_rock.h>

namespace hybrid::continuum
{
  using namespace dealii;

  CoarseRock::CoarseRock(const RestrainedModel &fine)
    : comm(fine.shared.communicator())
    , fe(FE_Q<2>(1), 2)
    , dofs(fine.shared.dofs().get_triangulation())
  {
    dofs.distribute_dofs(fe);
    DoFTools::extract_locally_relevant_dofs(dofs, relevant);
    const ElasticJoints joints(fine.rock, fine.joints, 1, [](const RockFace &face) {
      return std::vector<int>{face.a, face.b};
    });
    number_vertices(fine);
    support_unknowns();
    make_pattern(joints);
    add_cells(fine);
    add_joints(joints);
    matrix.compress(VectorOperation::add);

    TrilinosWrappers::PreconditionAMG::AdditionalData settings;
    DoFTools::extract_constant_modes(dofs, ComponentMask(2, true), settings.constant_modes);
    settings.aggregation_threshold = 0.02;
    inverse.initialize(matrix, settings);

    transfer.reinit_polynomial_transfer(fine.shared.dofs(), dofs);
    load.reinit(dofs.locally_owned_dofs(), relevant, comm);
    correction.reinit(load);
  }



  void CoarseRock::number_vertices(const RestrainedModel &fine)
  {
    const int n = fine.nodes.line.degree() + 1, corner[4] = {0, n - 1, n * (n - 1), n * n - 1};
    dof_of.assign(2 * fine.rock.nodes.size(), -1);
    supported.assign(dof_of.size(), 0);
    for (std::size_t c = 0; c < fine.nodes.cells.size(); ++c)
      for (std::size_t v = 0; v < 4; ++v)
        for (int d = 0; d < 2; ++d)
          supported[2 * fine.nodes.corners[c][v] + d] =
            fine.supported[2 * fine.nodes.cells[c][corner[v]] + d];

    std::vector<Index> of_cell(fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const auto &corners = fine.nodes.corners[cell->id().get_coarse_cell_id()];
          cell->get_dof_indices(of_cell);
          for (unsigned int i = 0; i < of_cell.size(); ++i)
            {
              const auto [component, vertex]          = fe.system_to_component_index(i);
              dof_of[2 * corners[vertex] + component] = static_cast<long>(of_cell[i]);
            }
        }
  }



  void CoarseRock::support_unknowns()
  {
    constraints.reinit(relevant);
    for (std::size_t i = 0; i < supported.size(); ++i)
      if (supported[i] && dof_of[i] >= 0)
        constraints.add_line(dof_of[i]);
    constraints.close();
  }



  void CoarseRock::make_pattern(const ElasticJoints &joints)
  {
    // Across a plane the cells are no neighbours: who has them tells the others.
    std::vector<long> of_joints;
    for (const int vertex : joints.nodes())
      for (int c = 0; c < 2; ++c)
        of_joints.push_back(dof_of[2 * vertex + c]);
    MPI_Allreduce(
      MPI_IN_PLACE, of_joints.data(), static_cast<int>(of_joints.size()), MPI_LONG, MPI_MAX, comm);
    for (std::size_t k = 0; k < of_joints.size(); ++k)
      dof_of[2 * joints.nodes()[k / 2] + k % 2] = of_joints[k];

    const IndexSet        &owned = dofs.locally_owned_dofs();
    DynamicSparsityPattern pattern(dofs.n_dofs(), dofs.n_dofs(), relevant);
    DoFTools::make_sparsity_pattern(dofs, pattern, constraints, false);
    joints.for_each_block([&](const int row, const int column, const Eigen::Matrix2d &) {
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          if (owned.is_element(dof_of[2 * joints.nodes()[row] + c]))
            pattern.add(dof_of[2 * joints.nodes()[row] + c],
                        dof_of[2 * joints.nodes()[column] + d]);
    });
    SparsityTools::distribute_sparsity_pattern(pattern, owned, comm, relevant);
    matrix.reinit(owned, owned, pattern, comm);
  }



  void CoarseRock::add_cells(const RestrainedModel &fine)
  {
    const FEValuesExtractors::Vector displacement(0);
    FEValues<2>                      values(fe, QGauss<2>(2), update_gradients | update_JxW_values);
    const unsigned int               n = fe.n_dofs_per_cell();
    FullMatrix<double>               of_cell(n, n);
    std::vector<Index>               numbers(n);
    for (const auto &cell : dofs.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Material &material = fine.material[cell->id().get_coarse_cell_id()];
          const double    lambda = material.lame_lambda(), shear = material.shear_modulus();
          values.reinit(cell);
          of_cell = 0.;
          for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                of_cell(i, j) += (lambda * values[displacement].divergence(i, q) *
                                    values[displacement].divergence(j, q) +
                                  2. * shear * values[displacement].symmetric_gradient(i, q) *
                                    values[displacement].symmetric_gradient(j, q)) *
                                 values.JxW(q);
          cell->get_dof_indices(numbers);
          constraints.distribute_local_to_global(of_cell, numbers, matrix);
        }
  }



  void CoarseRock::add_joints(const ElasticJoints &joints)
  {
    const IndexSet &owned = dofs.locally_owned_dofs();
    joints.for_each_block([&](const int row, const int column, const Eigen::Matrix2d &block) {
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d)
          {
            const int i = 2 * joints.nodes()[row] + c, j = 2 * joints.nodes()[column] + d;
            if (!supported[i] && !supported[j] && owned.is_element(dof_of[i]))
              matrix.add(dof_of[i], dof_of[j], block(c, d));
          }
    });
  }



  void CoarseRock::correct(const Vector &residual, Vector &u) const
  {
    load = 0.;
    transfer.restrict_and_add(load, residual);
    constraints.set_zero(load);
    inverse.vmult(correction, load);
    transfer.prolongate_and_add(u, correction);
  }
} // namespace hybrid::continuum
