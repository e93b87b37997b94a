// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <hybrid/continuum/element_nodes.h>
#include <hybrid/continuum/rock_mesh.h>

#include <memory>

namespace hybrid::continuum
{
  /// Boundary ids of the triangulation; bedding planes and the ground keep 0.
  enum BoundaryId : unsigned int
  {
    free_boundary  = 0,
    base_boundary  = 1,
    left_boundary  = 2,
    right_boundary = 3
  };


  /**
   * deal.II's view of the bedrock: a shared triangulation without artificial cells (so that
   * both sides of a bedding plane are known on every rank) and the vector-valued space of
   * FE_Q on Gauss-Lobatto nodes.
   */
  class ElementSpace
  {
  public:
    /// The region of each cell in @p section is its material id.
    ElementSpace(const RockMesh           &rock,
                 const scene::SectionMesh &section,
                 int                       degree,
                 MPI_Comm                  communicator,
                 MassQuadrature            of_mass = MassQuadrature::gauss);

    dealii::parallel::shared::Triangulation<2> triangulation;
    const dealii::FE_Q<2>                      scalar_fe;
    const dealii::FESystem<2>                  fe;
    dealii::DoFHandler<2>                      dof_handler;
    const std::shared_ptr<ElementNodes>        all_nodes; ///< may outlive the space
    ElementNodes                              &nodes;     ///< the same

    /// deal.II's number of an unknown -> ours (2 node + component).
    std::vector<int> canonical;

    /// Per shape function of scalar_fe: its place in ElementNodes::cells.
    std::vector<int> local_node;

    /// deal.II's unknowns go, with `canonical`; cells and nodes stay.
    void forget_unknowns();

  private:
    void number_nodes(const RockMesh &rock);
  };
} // namespace hybrid::continuum
