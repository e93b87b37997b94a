// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <deal.II/multigrid/mg_transfer_global_coarsening.h>

#include <hybrid/continuum/elastic_joints.h>
#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/restrained_model.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * The static rock once more with elements of degree 1 on the same cells: what corrects the smooth
   * part of an error in elements of a higher degree (p-multigrid, Ronquist and Patera 1987). Its
   * matrix has a few unknowns per cell, each rank holds its rows, and one cycle of Trilinos ML
   * (smoothed aggregation, Vanek, Mandel and Brezina 1996) stands for its inverse.
   */
  class CoarseRock
  {
  public:
    using Vector = ElasticProduct::Vector;

    /// @param fine the rock of higher degree; its cells have to outlive this object.
    explicit CoarseRock(const RestrainedModel &fine);

    /// u += P K_1^-1 P^T residual, as ML has the inverse. Supported unknowns have no residual.
    void correct(const Vector &residual, Vector &u) const;

  private:
    using Index = dealii::types::global_dof_index;

    /// deal.II's numbers of the unknowns of the rock's vertices, that this rank has to do with.
    void number_vertices(const RestrainedModel &fine);
    void support_unknowns();
    void add_cells(const RestrainedModel &fine);
    void add_joints(const ElasticJoints &joints);
    void make_pattern(const ElasticJoints &joints);

    MPI_Comm                               comm;
    dealii::FESystem<2>                    fe;
    dealii::DoFHandler<2>                  dofs;
    dealii::IndexSet                       relevant;
    dealii::AffineConstraints<double>      constraints;
    std::vector<long>                      dof_of; ///< per unknown of a vertex; -1: not known here
    std::vector<char>                      supported; ///< likewise
    dealii::TrilinosWrappers::SparseMatrix matrix;
    dealii::TrilinosWrappers::PreconditionAMG inverse;
    dealii::MGTwoLevelTransfer<2, Vector>     transfer;
    mutable Vector                            load, correction;
  };
} // namespace hybrid::continuum
