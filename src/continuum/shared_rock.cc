// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <hybrid/continuum/shared_rock.h>

#include <algorithm>
#include <numeric>

namespace hybrid::continuum
{
  using namespace dealii;

  SharedRock::SharedRock(ElementSpace &space, const MPI_Comm communicator)
    : triangulation(communicator)
    , fe(FE_Q<2>(space.nodes.line.degree()), 2)
    , dof_handler(triangulation)
  {
    space.forget_unknowns();
    GridTools::partition_triangulation(Utilities::MPI::n_mpi_processes(communicator),
                                       space.triangulation);
    {
      const auto description =
        TriangulationDescription::Utilities::create_description_from_triangulation(
          static_cast<const Triangulation<2> &>(space.triangulation), communicator);
      space.triangulation.clear();
      triangulation.create_triangulation(description);
    }
    dof_handler.distribute_dofs(fe);
    number_unknowns(space);
  }



  void SharedRock::number_unknowns(const ElementSpace &space)
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

} // namespace hybrid::continuum
