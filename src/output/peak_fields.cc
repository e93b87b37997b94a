// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/peak_fields.h>
#include <hybrid/output/vtu_writer.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hybrid::output
{
  namespace
  {
    std::vector<double> flat(const std::vector<Vec2> &points)
    {
      std::vector<double> numbers;
      for (const Vec2 &x : points)
        numbers.insert(numbers.end(), {x.x(), x.y()});
      return numbers;
    }


    /// What run.h5 has of points.
    struct Table
    {
      const char *name, *unit;
      std::size_t columns;
      const char *description;
    };

    constexpr Table tables[] = {
      {"position", "m", 2, "initial"},
      {"peak_acceleration", "m/s2", 2, "largest of each component, absolute, low-passed"},
      {"peak_velocity", "m/s", 2, "largest of each component, absolute"},
      {"peak_displacement",
       "m",
       2,
       "largest of each component, relative to the base monitor if there is one"},
      {"peak_slip", "m", 1, "largest magnitude"}};

    constexpr Table cells_table = {"cells", "1", 4, "nodes of quadrilaterals"};


    /// Fields of points, one after the other.
    struct PointFields
    {
      std::vector<double> values[4]; ///< acceleration, velocity, displacement (pairs), slip

      void add(const PeakMotion &peaks, const std::vector<double> &slip, const std::size_t point)
      {
        const std::vector<double> *of[] = {&peaks.peak_acceleration(),
                                           &peaks.peak_velocity(),
                                           &peaks.peak_displacement()};
        for (int k = 0; k < 3; ++k)
          values[k].insert(values[k].end(), {(*of[k])[2 * point], (*of[k])[2 * point + 1]});
        values[3].push_back(slip[point]);
      }
    };
  } // namespace



  PeakFields::PeakFields(const dda::Model           *all_blocks,
                         const continuum::Continuum *bedrock,
                         const double                corner)
    : model(all_blocks)
    , continuum(bedrock)
    , nodes(corner)
    , blocks(corner)
  {
    if (continuum != nullptr)
      facing = continuum->facing_nodes();
  }



  void PeakFields::gather_blocks(const dda::DdaState &state)
  {
    displacement.resize(2 * centroids.size());
    velocity.resize(2 * centroids.size());
    for (std::size_t b = 0; b < centroids.size(); ++b)
      for (int c = 0; c < 2; ++c)
        {
          displacement[2 * b + c] = state.blocks[b].centroid[c] - centroids[b][c];
          velocity[2 * b + c]     = state.blocks[b].velocity[c];
        }
  }



  void PeakFields::start(const coupling::CoupledState &state)
  {
    if (continuum != nullptr)
      {
        const std::size_t n = continuum->n_unknowns() / 2;
        nodes.start(state.continuum.velocity.data(), 2 * n);
        node_slip.assign(n, 0.);
      }
    if (model == nullptr)
      return;
    for (const dda::BlockState &block : state.blocks.blocks)
      centroids.push_back(block.centroid);
    gather_blocks(state.blocks);
    blocks.start(velocity.data(), velocity.size());
  }



  void PeakFields::record(const coupling::CoupledState &state, const double dt, const Vec2 &base)
  {
    if (continuum != nullptr)
      {
        const std::vector<double> &u = state.continuum.displacement;
        nodes.add(u.data(), state.continuum.velocity.data(), dt, base.data());
        for (const auto &[left, right, tangent] : facing)
          {
            const Vec2   jump(u[2 * left] - u[2 * right], u[2 * left + 1] - u[2 * right + 1]);
            const double slip = std::abs(jump.dot(tangent));
            node_slip[left]   = std::max(node_slip[left], slip);
            node_slip[right]  = std::max(node_slip[right], slip);
          }
      }
    if (model == nullptr)
      return;
    gather_blocks(state.blocks);
    blocks.add(displacement.data(), velocity.data(), dt, base.data());
  }



  void PeakFields::write_part(HistoryFile               &file,
                              const std::string         &path,
                              const PeakMotion          &peaks,
                              const std::vector<Vec2>   &position,
                              const std::vector<double> &slip) const
  {
    const std::vector<double>  positions = flat(position);
    const std::vector<double> *values[]  = {&positions,
                                            &peaks.peak_acceleration(),
                                            &peaks.peak_velocity(),
                                            &peaks.peak_displacement(),
                                            &slip};
    for (std::size_t k = 0; k < std::size(tables); ++k)
      {
        const auto &[name, unit, columns, description] = tables[k];
        file.write_table(
          path + name, unit, values[k]->data(), position.size(), columns, description);
      }
  }



  void
  PeakFields::declare_nodes(HistoryFile &file, const std::size_t n_nodes, const std::size_t n_cells)
  {
    for (const auto &[name, unit, columns, description] : tables)
      file.declare_table(std::string(nodes_group) + name, unit, n_nodes, columns, description);
    const auto &[name, unit, columns, description] = cells_table;
    file.declare_table(std::string(nodes_group) + name, unit, n_cells, columns, description);
  }



  void PeakFields::write(const std::vector<double> &block_slip,
                         HistoryFile               &file,
                         const std::string         &picture) const
  {
    VtuWriter   vtu;
    PointFields fields;
    if (continuum != nullptr && !node_slip.empty())
      {
        write_part(file, nodes_group, nodes, continuum->node_positions(), node_slip);
        std::vector<double> cells;
        for (const Vec2 &x : continuum->node_positions())
          fields.add(nodes, node_slip, static_cast<std::size_t>(vtu.add_point(x)));
        for (const auto &cell : continuum->cells())
          {
            vtu.add_cell(CellShape::quad, cell.data(), 4);
            cells.insert(cells.end(), cell.begin(), cell.end());
          }
        const auto &[name, unit, columns, description] = cells_table;
        file.write_table(nodes_group + std::string(name),
                         unit,
                         cells.data(),
                         cells.size() / 4,
                         columns,
                         description);
      }
    if (model != nullptr && !centroids.empty())
      {
        write_part(file, "fields/blocks/", blocks, centroids, block_slip);
        const dda::Geometry &g = model->initial;
        for (int b = 0; b < g.n_blocks(); ++b)
          {
            std::vector<int> corners;
            for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
              {
                corners.push_back(vtu.add_point(g.vertices[v]));
                fields.add(blocks, block_slip, b);
              }
            vtu.add_cell(corners.size() == 3 ? CellShape::triangle : CellShape::polygon, corners);
          }
      }
    if (vtu.n_points() == 0)
      return;
    vtu.add_point_field("peak acceleration [m/s2]", {"x", "y"}, fields.values[0]);
    vtu.add_point_field("peak velocity [m/s]", {"x", "y"}, fields.values[1]);
    vtu.add_point_field("peak displacement [m]", {"x", "y"}, fields.values[2]);
    vtu.add_point_field("peak slip [m]", fields.values[3]);
    vtu.write(picture);
  }



  void PeakFields::serialize(restart::Archive &archive)
  {
    archive(nodes, blocks, node_slip, centroids);
  }
} // namespace hybrid::output
