// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/distributed/fully_distributed_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <hybrid/continuum/element_space.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * The cells of the bedrock shared out among the ranks by METIS, and the unknowns of each rank. A
   * rank holds its cells, their nodes and one layer of neighbours.
   */
  class SharedRock
  {
  public:
    /// @param space on the whole bedrock; only its nodes are left afterwards
    SharedRock(ElementSpace &space, MPI_Comm communicator);

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

  private:
    void number_unknowns(const ElementSpace &space);

    dealii::parallel::fullydistributed::Triangulation<2> triangulation;
    dealii::FESystem<2>                                  fe;
    dealii::DoFHandler<2>                                dof_handler;
    std::vector<int>                                     owned;
  };
} // namespace hybrid::continuum
