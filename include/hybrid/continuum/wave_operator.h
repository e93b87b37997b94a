// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/distributed/fully_distributed_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/element_space.h>

#include <memory>
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
    using Vector = ElasticProduct::Vector;

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

    /// The same unknowns as deal.II has them, of this rank in this order.
    const dealii::DoFHandler<2> &dofs() const
    {
      return dof_handler;
    }

    /// Zero, with room for what the neighbours own.
    Vector make_vector() const
    {
      return stiffness->make_vector();
    }

    /// f = - K u: the force of the rock on its nodes [N/m].
    void elastic_force(const Vector &u, Vector &f) const
    {
      stiffness->multiply(-1., u, f);
    }

    /// Diagonal of the mass matrix [kg/m], as unknowns().
    const std::vector<double> &mass() const
    {
      return diagonal_mass;
    }

  private:
    void number_unknowns(const ElementSpace &space);

    dealii::parallel::fullydistributed::Triangulation<2> triangulation;
    dealii::FESystem<2>                                  fe;
    dealii::DoFHandler<2>                                dof_handler;
    std::vector<int>                                     owned;
    std::unique_ptr<ElasticProduct>                      stiffness;
    std::vector<double>                                  diagonal_mass;
  };
} // namespace hybrid::continuum
