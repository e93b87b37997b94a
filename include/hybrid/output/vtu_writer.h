// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/vtu_file.h>
#include <hybrid/scene/types.h>

#include <cstddef>
#include <cstdint>
#include <mpi.h>
#include <string>
#include <vector>

namespace hybrid::output
{
  /// Shape of a cell; the values are VTK's.
  enum class CellShape : std::uint8_t
  {
    vertex   = 1,
    line     = 3,
    triangle = 5,
    polygon  = 7,
    quad     = 9
  };


  /**
   * An unstructured grid with fields, as a .vtu file for ParaView (VTK XML, little endian, zlib,
   * base64).
   *
   * Fill it, write it; clear() keeps the memory for the next picture. Names of fields carry their
   * unit, "displacement [m]". Fields are stored in single precision, points in double. Vectors of
   * two components get z = 0, because ParaView warps and draws arrows with three only.
   */
  class VtuWriter
  {
  public:
    void clear();

    /// Room for what will be added.
    void reserve(std::size_t n_points, std::size_t n_cells, std::size_t n_nodes_of_cells);

    /// @return the index of the point.
    int add_point(const Vec2 &position);

    /// Nodes counter-clockwise. @param nodes indices of points
    void add_cell(CellShape shape, const int *nodes, std::size_t n_nodes);

    void add_cell(CellShape shape, const std::vector<int> &nodes);

    std::size_t n_points() const;

    std::size_t n_cells() const;

    /**
     * A field of one component per point.
     *
     * @param values one after the other. Their number must fit when write() is called.
     */
    void add_point_field(const std::string &name, std::vector<double> values);

    /// Of several. @param components their names @param values point by point.
    void add_point_field(const std::string              &name,
                         const std::vector<std::string> &components,
                         std::vector<double>             values);

    void add_cell_field(const std::string &name, std::vector<double> values);

    void add_cell_field(const std::string              &name,
                        const std::vector<std::string> &components,
                        std::vector<double>             values);

    /// Write to a temporary file, then rename: the file is complete or absent.
    void write(const std::string &file_name) const;

    /// One file by all ranks, of which each has a part of the points and cells: as many on each,
    /// fewer on the last that has any. Cells name points by their numbers in all. Numbers in this
    /// object are spent then. All ranks call it. @throws as restart::SharedFile.
    void write(const std::string &file_name, MPI_Comm communicator);

  private:
    struct Field
    {
      std::string              name;
      std::vector<std::string> components; ///< names; empty: one without
      std::vector<double>      values;
    };

    static void add_fields(VtuFile &file, const std::vector<Field> &fields, std::size_t n_entities);

    void add_mesh(VtuFile &file) const;

    void add_to(VtuFile &file, std::size_t n_all_points, std::size_t n_all_cells) const;

    std::vector<double>       points;       ///< x, y, z of each [m]
    std::vector<std::int32_t> connectivity; ///< nodes of all cells
    std::vector<std::int32_t> offsets;      ///< end of each cell in connectivity
    std::vector<std::uint8_t> shapes;
    std::vector<Field>        point_fields;
    std::vector<Field>        cell_fields;
  };
} // namespace hybrid::output
