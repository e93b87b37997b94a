// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <hybrid/continuum/elastic_assembly.h>
#include <hybrid/continuum/inertia_correction.h>

#include <algorithm>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    /// One face pair: deal.II's unknowns of both faces (x, y of each node, first face first) and
    /// its matrix.
    struct JointElement
    {
      std::vector<Index> dofs;
      FullMatrix<double> matrix;
      int                cell; ///< its rank assembles the joint
    };

    std::vector<JointElement>
    joint_elements(const ElementSpace &space, const RockMesh &rock, const JointStiffness &k)
    {
      std::vector<Index> dof_of(space.canonical.size());
      for (std::size_t d = 0; d < dof_of.size(); ++d)
        dof_of[space.canonical[d]] = d;

      const auto               &mass = space.nodes.line.mass();
      const int                 n    = mass.rows();
      std::vector<JointElement> result;
      for (const auto &pair : rock.joints)
        {
          const auto   a = space.nodes.along(pair.first), b = space.nodes.along(pair.second);
          const Vec2   along  = rock.nodes[pair.first.b] - rock.nodes[pair.first.a];
          const double length = along.norm();
          const Vec2   t      = along / length, normal(t.y(), -t.x());
          const Eigen::Matrix2d spring =
            k.normal * normal * normal.transpose() + k.shear * t * t.transpose();

          JointElement joint{{}, FullMatrix<double>(4 * n, 4 * n), pair.first.cell};
          for (const auto &side : {a, b})
            for (const int node : side)
              for (int c = 0; c < 2; ++c)
                joint.dofs.push_back(dof_of[2 * node + c]);
          for (int i = 0; i < 2 * n; ++i)
            for (int j = 0; j < 2 * n; ++j)
              for (int c = 0; c < 2; ++c)
                for (int d = 0; d < 2; ++d)
                  joint.matrix(2 * i + c, 2 * j + d) =
                    ((i < n) == (j < n) ? 1. : -1.) * length * mass(i % n, j % n) * spring(c, d);
          result.push_back(joint);
        }
      return result;
    }

    void cell_matrices(const FEValues<2>  &values,
                       const Material     &material,
                       const FESystem<2>  &fe,
                       FullMatrix<double> &mass,
                       FullMatrix<double> &stiffness)
    {
      const double lambda = material.lame_lambda(), mu = material.shear_modulus();
      mass      = 0.;
      stiffness = 0.;
      for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
        for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
          {
            const auto [a, si] = fe.system_to_component_index(i);
            const auto [b, sj] = fe.system_to_component_index(j);
            for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
              {
                const auto &gi = values.shape_grad(si, q), &gj = values.shape_grad(sj, q);
                double      k = lambda * gi[a] * gj[b] + mu * gi[b] * gj[a];
                if (a == b)
                  {
                    k += mu * (gi * gj);
                    mass(i, j) += material.density * values.shape_value(si, q) *
                                  values.shape_value(sj, q) * values.JxW(q);
                  }
                stiffness(i, j) += k * values.JxW(q);
              }
          }
    }

    /// What inertia_correction() adds to the mass of a cell.
    void cell_correction(const FullMatrix<double> &mass,
                         const FullMatrix<double> &stiffness,
                         const double              step,
                         FullMatrix<double>       &correction)
    {
      const Eigen::Index n = static_cast<Eigen::Index>(mass.m());
      Eigen::MatrixXd    m(n, n), k(n, n);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          {
            m(i, j) = mass(i, j);
            k(i, j) = stiffness(i, j);
          }
      const Eigen::MatrixXd added = inertia_correction(m, k, step);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          correction(i, j) = added(i, j);
    }

    void make_node_pattern(const ElementSpace &space, const RockMesh &rock, NodeMatrices &matrices)
    {
      std::vector<std::vector<int>> rows(space.nodes.size());
      const auto                    couple = [&](const std::vector<int> &nodes) {
        for (const int i : nodes)
          rows[i].insert(rows[i].end(), nodes.begin(), nodes.end());
      };
      for (const auto &cell : space.nodes.cells)
        couple(cell);
      for (const auto &pair : rock.joints)
        {
          auto both = space.nodes.along(pair.first);
          for (const int node : space.nodes.along(pair.second))
            both.push_back(node);
          couple(both);
        }
      matrices.row_start = {0};
      for (auto &row : rows)
        {
          std::sort(row.begin(), row.end());
          row.erase(std::unique(row.begin(), row.end()), row.end());
          matrices.column.insert(matrices.column.end(), row.begin(), row.end());
          matrices.row_start.push_back(static_cast<int>(matrices.column.size()));
        }
      matrices.mass.assign(matrices.column.size(), 0.);
    }

    /// The same array from all ranks, one after the other.
    template <typename T>
    std::vector<T>
    gather_all(const std::vector<T> &mine, const MPI_Datatype type, const MPI_Comm comm)
    {
      int       size  = 1;
      const int count = static_cast<int>(mine.size());
      MPI_Comm_size(comm, &size);
      std::vector<int> counts(size), offsets(size + 1, 0);
      MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
      for (int r = 0; r < size; ++r)
        offsets[r + 1] = offsets[r] + counts[r];
      std::vector<T> all(offsets[size]);
      MPI_Allgatherv(
        mine.data(), count, type, all.data(), counts.data(), offsets.data(), type, comm);
      return all;
    }

    /// Entries of the locally owned rows of a matrix, moved to our numbering, from all ranks.
    struct Entries
    {
      std::vector<int>    row, column;
      std::vector<double> value;
    };

    Entries gather_entries(const TrilinosWrappers::SparseMatrix &matrix,
                           const std::vector<int>               &canonical,
                           const MPI_Comm                        comm)
    {
      const Epetra_CrsMatrix &epetra = matrix.trilinos_matrix();
      Entries                 mine;
      for (int r = 0; r < epetra.NumMyRows(); ++r)
        {
          int     n       = 0;
          double *values  = nullptr;
          int    *columns = nullptr;
          epetra.ExtractMyRowView(r, n, values, columns);
          for (int k = 0; k < n; ++k)
            {
              mine.row.push_back(canonical[epetra.GRID(r)]);
              mine.column.push_back(canonical[epetra.GCID(columns[k])]);
              mine.value.push_back(values[k]);
            }
        }
      return {gather_all(mine.row, MPI_INT, comm),
              gather_all(mine.column, MPI_INT, comm),
              gather_all(mine.value, MPI_DOUBLE, comm)};
    }

    /// What the ranks sum up; the correction only where it is asked for.
    struct Matrices
    {
      TrilinosWrappers::SparseMatrix mass, stiffness, correction;
    };

    /// 2 x 2 blocks of a matrix in the order of our pattern.
    void take_blocks(const TrilinosWrappers::SparseMatrix &matrix,
                     const std::vector<int>               &canonical,
                     const MPI_Comm                        comm,
                     const NodeMatrices                   &pattern,
                     std::vector<double>                  &blocks)
    {
      blocks.assign(4 * pattern.column.size(), 0.);
      const Entries s = gather_entries(matrix, canonical, comm);
      for (std::size_t k = 0; k < s.value.size(); ++k)
        blocks[4 * pattern.entry(s.row[k] / 2, s.column[k] / 2) + 2 * (s.row[k] % 2) +
               s.column[k] % 2] = s.value[k];
    }

    void assemble(const ElementSpace              &space,
                  const CellMaterials             &material,
                  const std::vector<JointElement> &joints,
                  const double                     corrected_step,
                  Matrices                        &matrices)
    {
      const auto        &fe = space.fe;
      const unsigned int n  = fe.n_dofs_per_cell();
      FEValues<2>        values(space.scalar_fe,
                         QGauss<2>(space.nodes.line.degree() + 1),
                         update_values | update_gradients | update_JxW_values);
      FullMatrix<double> cell_mass(n, n), cell_stiffness(n, n), correction(n, n);
      std::vector<Index> dofs(n);
      std::vector<bool>  mine(space.triangulation.n_active_cells(), false);
      for (const auto &cell : space.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            mine[cell->index()] = true;
            values.reinit(static_cast<const Triangulation<2>::cell_iterator &>(cell));
            cell_matrices(values, material[cell->index()], fe, cell_mass, cell_stiffness);
            cell->get_dof_indices(dofs);
            matrices.mass.add(dofs, cell_mass);
            matrices.stiffness.add(dofs, cell_stiffness);
            if (corrected_step != 0.)
              {
                cell_correction(cell_mass, cell_stiffness, corrected_step, correction);
                matrices.correction.add(dofs, correction);
              }
          }
      for (const auto &joint : joints)
        if (mine[joint.cell])
          matrices.stiffness.add(joint.dofs, joint.matrix);
      matrices.mass.compress(VectorOperation::add);
      matrices.stiffness.compress(VectorOperation::add);
      if (corrected_step != 0.)
        matrices.correction.compress(VectorOperation::add);
    }
  } // namespace


  NodeMatrices assemble_elastic(const ElementSpace   &space,
                                const RockMesh       &rock,
                                const CellMaterials  &material,
                                const JointStiffness &joint_stiffness,
                                const double          corrected_step)
  {
    const MPI_Comm comm   = space.triangulation.get_communicator();
    const auto     joints = joint_elements(space, rock, joint_stiffness);

    // Every rank knows every cell: each builds the whole pattern and keeps its rows.
    DynamicSparsityPattern pattern(space.dof_handler.n_dofs());
    std::vector<Index>     dofs(space.fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (const Index i : dofs)
          for (const Index j : dofs)
            pattern.add(i, j);
      }
    for (const auto &joint : joints)
      for (const Index i : joint.dofs)
        for (const Index j : joint.dofs)
          pattern.add(i, j);
    const IndexSet &owned = space.dof_handler.locally_owned_dofs();
    Matrices        matrices;
    matrices.mass.reinit(owned, owned, pattern, comm);
    matrices.stiffness.reinit(owned, owned, pattern, comm);
    if (corrected_step != 0.)
      matrices.correction.reinit(owned, owned, pattern, comm);
    assemble(space, material, joints, corrected_step, matrices);

    NodeMatrices result;
    make_node_pattern(space, rock, result);
    const Entries m = gather_entries(matrices.mass, space.canonical, comm);
    for (std::size_t k = 0; k < m.value.size(); ++k)
      if (m.row[k] % 2 == 0 && m.column[k] % 2 == 0)
        result.mass[result.entry(m.row[k] / 2, m.column[k] / 2)] = m.value[k];
    take_blocks(matrices.stiffness, space.canonical, comm, result, result.stiffness);
    if (corrected_step != 0.)
      take_blocks(matrices.correction, space.canonical, comm, result, result.inertia_correction);
    result.share_rows(comm);
    return result;
  }
} // namespace hybrid::continuum
