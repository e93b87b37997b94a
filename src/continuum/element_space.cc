// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/grid/grid_tools.h>

#include <hybrid/continuum/element_space.h>

#include <cmath>
#include <set>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    SubCellData boundary_lines(const RockMesh &rock, const scene::SectionMesh &section)
    {
      SubCellData                               lines;
      const std::pair<const char *, BoundaryId> named[] = {{"base", base_boundary},
                                                           {"left", left_boundary},
                                                           {"right", right_boundary}};
      for (const auto &[name, id] : named)
        if (const auto line = section.lines.find(name); line != section.lines.end())
          for (const auto &face : boundary_faces(rock, line->second))
            {
              CellData<1> data(2);
              data.vertices    = {static_cast<unsigned int>(face.a),
                                  static_cast<unsigned int>(face.b)};
              data.boundary_id = id;
              lines.boundary_lines.push_back(data);
            }
      return lines;
    }
  } // namespace


  ElementSpace::ElementSpace(const RockMesh           &rock,
                             const scene::SectionMesh &section,
                             const int                 degree,
                             const MPI_Comm            communicator,
                             const MassQuadrature      of_mass)
    : triangulation(communicator,
                    Triangulation<2>::none,
                    /*allow_artificial_cells*/ false,
                    parallel::shared::Triangulation<2>::partition_zorder)
    , scalar_fe(degree)
    , fe(scalar_fe, 2)
    , dof_handler(triangulation)
    , all_nodes(std::make_shared<ElementNodes>(degree, of_mass))
    , nodes(*all_nodes)
  {
    std::vector<Point<2>> vertices;
    for (const Vec2 &node : rock.nodes)
      vertices.emplace_back(node.x(), node.y());
    std::vector<CellData<2>> cells;
    for (std::size_t c = 0; c < rock.cells.size(); ++c)
      {
        const auto &corner = rock.cells[c];
        CellData<2> data(4);
        for (int i = 0; i < 4; ++i)
          data.vertices[i] = corner[i < 2 ? i : 5 - i];
        data.material_id = section.bedrock_region[c];
        cells.push_back(data);
      }
    GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(vertices, cells, boundary_lines(rock, section));
    dof_handler.distribute_dofs(fe);
    number_nodes(rock);
  }


  void ElementSpace::forget_unknowns()
  {
    dof_handler.clear();
    canonical = std::vector<int>(); // {} would keep its memory
  }


  void ElementSpace::number_nodes(const RockMesh &rock)
  {
    const auto &points = nodes.line.nodes();
    const int   n      = nodes.line.degree() + 1;
    const auto  place  = [&](const double x) {
      int best = 0;
      for (int i = 1; i < n; ++i)
        if (std::abs(points[i] - x) < std::abs(points[best] - x))
          best = i;
      return best;
    };
    for (unsigned int i = 0; i < scalar_fe.n_dofs_per_cell(); ++i)
      {
        const auto p = scalar_fe.unit_support_point(i);
        local_node.push_back(place(p[0]) + n * place(p[1]));
      }

    nodes.positions.reserve(dof_handler.n_dofs() / 2);
    nodes.cells.assign(rock.cells.size(), std::vector<int>(n * n));
    nodes.corners.resize(rock.cells.size());
    nodes.corner_positions = rock.nodes;
    canonical.assign(dof_handler.n_dofs(), -1);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> dof_of_local(2 * n * n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const unsigned int c = cell->index();
        for (int v = 0; v < 4; ++v)
          nodes.corners[c][v] = cell->vertex_index(v);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [component, index]                   = fe.system_to_component_index(i);
            dof_of_local[2 * local_node[index] + component] = dofs[i];
          }
        for (int k = 0; k < n * n; ++k)
          {
            if (canonical[dof_of_local[2 * k]] < 0)
              {
                const int    node = nodes.n_nodes++;
                const double x = points[k % n], y = points[k / n];
                Vec2         position(0., 0.);
                for (int v = 0; v < 4; ++v)
                  position += (v % 2 == 0 ? 1. - x : x) * (v / 2 == 0 ? 1. - y : y) *
                              rock.nodes[nodes.corners[c][v]];
                nodes.positions.push_back(position);
                canonical[dof_of_local[2 * k]]     = 2 * node;
                canonical[dof_of_local[2 * k + 1]] = 2 * node + 1;
              }
            nodes.cells[c][k] = canonical[dof_of_local[2 * k]] / 2;
          }
      }
  }
} // namespace hybrid::continuum
