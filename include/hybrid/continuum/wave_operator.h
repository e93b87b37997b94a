// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/distributed/fully_distributed_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/matrix_free.h>

#include <hybrid/continuum/element_space.h>
#include <hybrid/scene/material.h>

#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Stiffness and mass of the bedrock as sums over its cells, which no rank ever holds as matrices:
   * spectral elements (Komatitsch and Vilotte 1998), all integrals by Gauss-Lobatto quadrature on
   * the nodes themselves, so that the mass is diagonal. Bedding planes and boundaries are not part
   * of it.
   *
   * The cells are shared out among the ranks by METIS. A rank holds its cells, their nodes and one
   * layer of neighbours.
   */
  class WaveOperator
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    /// @param space on the whole bedrock; it may go afterwards @param material per cell
    WaveOperator(const ElementSpace          &space,
                 const std::vector<Material> &material,
                 MPI_Comm                     communicator);

    MPI_Comm communicator() const
    {
      return triangulation.get_communicator();
    }

    /// The unknowns of this rank (2 node + component), ascending; vectors hold them in this order.
    const std::vector<int> &unknowns() const
    {
      return owned;
    }

    /// Zero, with room for what the neighbours own.
    Vector make_vector() const;

    /// f = - K u: the force of the rock on its nodes [N/m]. Takes the neighbours' part of @p u from
    /// them.
    void elastic_force(Vector &u, Vector &f) const;

    /// Diagonal of the mass matrix [kg/m], as unknowns().
    const std::vector<double> &mass() const
    {
      return diagonal_mass;
    }

  private:
    using MatrixFree = dealii::MatrixFree<2, double>;
    using Lanes      = dealii::VectorizedArray<double>;
    using Range      = std::pair<unsigned int, unsigned int>;

    struct CellModuli
    {
      Lanes lambda, shear, density; ///< [Pa], [Pa], [kg/m3]
    };

    void number_unknowns(const ElementSpace &space);
    void take_materials(const std::vector<Material> &material);
    void add_elastic_force(const MatrixFree &, Vector &f, const Vector &u, const Range &) const;
    void add_mass(const MatrixFree &, Vector &mass, const Vector &, const Range &) const;

    dealii::parallel::fullydistributed::Triangulation<2> triangulation;
    dealii::FESystem<2>                                  fe;
    dealii::DoFHandler<2>                                dof_handler;
    MatrixFree                                           loop;
    std::vector<int>                                     owned;
    dealii::AlignedVector<CellModuli>                    moduli; ///< per batch of cells
    std::vector<double>                                  diagonal_mass;
  };
} // namespace hybrid::continuum
