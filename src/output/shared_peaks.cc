// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/shared_peaks.h>
#include <hybrid/output/shared_tables.h>
#include <hybrid/output/vtu_writer.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hybrid::output
{
  namespace
  {
    double number_at(const char *numbers, const std::size_t k)
    {
      double number;
      std::memcpy(&number, numbers + k * sizeof(double), sizeof(double));
      return number;
    }



    std::vector<std::string> table_names()
    {
      const std::string path = PeakFields::nodes_group;
      return {path + "position",
              path + "peak_acceleration",
              path + "peak_velocity",
              path + "peak_displacement",
              path + "peak_slip",
              path + "cells"};
    }
  } // namespace



  SharedPeaks::SharedPeaks(const continuum::Continuum &bedrock, const double corner)
    : continuum(bedrock)
    , ownership(*bedrock.ownership())
    , peaks(corner)
    , facing(bedrock.facing_nodes())
  {
    const continuum::HeldNodes &held = ownership.held();
    for (const auto &pair : facing)
      {
        slipping_nodes.insert(slipping_nodes.end(), {pair.left, pair.right});
        slots.push_back({held.slot(pair.left), held.slot(pair.right)});
      }
    std::sort(slipping_nodes.begin(), slipping_nodes.end());
    slipping_nodes.erase(std::unique(slipping_nodes.begin(), slipping_nodes.end()),
                         slipping_nodes.end());
    slip.assign(slipping_nodes.size(), 0.);
  }



  double &SharedPeaks::slip_at(const int node)
  {
    return slip[std::lower_bound(slipping_nodes.begin(), slipping_nodes.end(), node) -
                slipping_nodes.begin()];
  }



  void SharedPeaks::start(const continuum::ContinuumState &state)
  {
    peaks.start(state.velocity.data(), ownership.unknowns().size()); // its own stand first
  }



  void SharedPeaks::add(const continuum::ContinuumState &state, const double dt, const double *base)
  {
    const std::vector<double> &u = state.displacement;
    peaks.add(u.data(), state.velocity.data(), dt, base);
    for (std::size_t k = 0; k < facing.size(); ++k) // all processes know their motion
      {
        const auto &[left, right, tangent] = facing[k];
        const int    l = 2 * slots[k][0], r = 2 * slots[k][1];
        const Vec2   jump(u[l] - u[r], u[l + 1] - u[r + 1]);
        const double now = std::abs(jump.dot(tangent));
        slip_at(left)    = std::max(slip_at(left), now);
        slip_at(right)   = std::max(slip_at(right), now);
      }
  }



  std::vector<double> SharedPeaks::portion_of_peaks(const std::vector<double> &own) const
  {
    std::vector<double> result;
    ownership.to_portion(own.data(), 2, result);
    return result;
  }



  std::vector<double> SharedPeaks::portion_of_slip() const
  {
    std::vector<double> result(ownership.portion().size(), 0.);
    for (std::size_t k = 0; k < slip.size(); ++k)
      if (ownership.portion().has(slipping_nodes[k]))
        result[slipping_nodes[k] - ownership.portion().begin] = slip[k];
    return result;
  }



  std::vector<double> SharedPeaks::portion_of_positions() const
  {
    std::vector<double> result;
    for (std::size_t n = ownership.portion().begin; n < ownership.portion().end; ++n)
      {
        const Vec2 &x = continuum.node_position(static_cast<int>(n));
        result.insert(result.end(), {x.x(), x.y()});
      }
    return result;
  }



  void SharedPeaks::write(const std::string &run_file, const std::string &picture) const
  {
    const MPI_Comm                  communicator = ownership.communicator();
    const std::vector<std::string>  names        = table_names();
    std::vector<std::array<int, 4>> cells        = continuum.cells_to_write();
    std::vector<double>             positions    = portion_of_positions();
    VtuWriter                       vtu;
    vtu.reserve(positions.size() / 2, cells.size(), 4 * cells.size());
    for (std::size_t k = 0; k < positions.size(); k += 2)
      vtu.add_point({positions[k], positions[k + 1]});
    for (const auto &cell : cells)
      vtu.add_cell(CellShape::quad, cell.data(), 4);

    constexpr std::size_t per_node = 2 * 4 + 1, per_cell = 4; // numbers
    const std::size_t     numbers_of_all =
      per_node * ownership.n_nodes() + per_cell * continuum.n_cells();
    SharedTables file(run_file, numbers_of_all * sizeof(double), communicator);
    file.write(names[0], 2, positions);
    positions = std::vector<double>(); // {} would keep its memory
    const auto add =
      [&](const std::size_t k, const std::string &field, const std::vector<double> &own) {
        std::vector<double> values = portion_of_peaks(own);
        file.write(names[k], 2, values);
        vtu.add_point_field(field, {"x", "y"}, std::move(values));
      };
    add(1, "peak acceleration [m/s2]", peaks.peak_acceleration());
    add(2, "peak velocity [m/s]", peaks.peak_velocity());
    add(3, "peak displacement [m]", peaks.peak_displacement());
    file.write(names[4], 1, portion_of_slip());
    vtu.add_point_field("peak slip [m]", portion_of_slip());
    std::vector<double> numbers;
    numbers.reserve(4 * cells.size());
    for (const auto &cell : cells)
      numbers.insert(numbers.end(), cell.begin(), cell.end());
    cells = std::vector<std::array<int, 4>>();
    file.write(names[5], 4, numbers);
    file.finish();
    vtu.write(picture, communicator);
  }



  std::vector<restart::SharedVector> SharedPeaks::shared_vectors(PeakFields *of_first)
  {
    std::vector<restart::SharedVector> result;
    const std::size_t                  n = ownership.n_nodes();
    for (int k = 0; k < PeakMotion::n_arrays; ++k)
      {
        std::vector<double> &own     = *peaks.arrays()[k];
        const auto           portion = [this, &own](std::size_t) { return portion_of_peaks(own); };
        const auto           take    = [this, &own](std::size_t, const char *numbers) {
          own = ownership.read(numbers);
        };
        result.push_back({of_first ? of_first->nodes_of_bedrock().arrays()[k] : &own,
                          1,
                          2 * n,
                          0,
                          portion,
                          {},
                          take});
      }
    const auto portion = [this](std::size_t) { return portion_of_slip(); };
    const auto take    = [this](std::size_t, const char *numbers) {
      for (std::size_t k = 0; k < slip.size(); ++k)
        slip[k] = number_at(numbers, slipping_nodes[k]);
    };
    result.push_back({of_first ? &of_first->slip_of_nodes() : &slip, 1, n, 0, portion, {}, take});
    return result;
  }
} // namespace hybrid::output
