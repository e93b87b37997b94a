// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/shared_vtu.h>
#include <hybrid/output/vtu_writer.h>

#include <algorithm>
#include <stdexcept>

namespace hybrid::output
{
  namespace
  {
    std::string escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        switch (c)
          {
            case '&':
              result += "&amp;";
              break;
            case '<':
              result += "&lt;";
              break;
            case '>':
              result += "&gt;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += c;
          }
      return result;
    }


    template <typename Number>
    const char *vtk_type = nullptr;
    template <>
    const char *vtk_type<double> = "Float64";
    template <>
    const char *vtk_type<float> = "Float32";
    template <>
    const char *vtk_type<std::int32_t> = "Int32";
    template <>
    const char *vtk_type<std::uint8_t> = "UInt8";


    /// @param components names of the components; empty: one without name.
    template <typename Number>
    void add_array(VtuFile                        &file,
                   const std::string              &name,
                   const std::vector<std::string> &components,
                   const std::vector<Number>      &values)
    {
      const std::size_t n   = components.empty() ? 1 : components.size();
      std::string       xml = "        <DataArray type=\"" + std::string(vtk_type<Number>) +
                        "\" Name=\"" + escaped(name) + "\" NumberOfComponents=\"" +
                        std::to_string(n) + "\"";
      for (std::size_t c = 0; c < components.size(); ++c)
        xml += " ComponentName" + std::to_string(c) + "=\"" + escaped(components[c]) + "\"";
      file.add_text(xml + " format=\"binary\">");
      file.add_array(values.data(), values.size() * sizeof(Number));
      file.add_text("</DataArray>\n");
    }


    const std::vector<std::string> no_names, directions{"x", "y", "z"};
  } // namespace



  void VtuWriter::clear()
  {
    points.clear();
    connectivity.clear();
    offsets.clear();
    shapes.clear();
    point_fields.clear();
    cell_fields.clear();
  }



  void VtuWriter::reserve(const std::size_t of_points,
                          const std::size_t of_cells,
                          const std::size_t nodes_of_cells)
  {
    points.reserve(3 * of_points);
    connectivity.reserve(nodes_of_cells);
    offsets.reserve(of_cells);
    shapes.reserve(of_cells);
  }



  int VtuWriter::add_point(const Vec2 &position)
  {
    points.insert(points.end(), {position.x(), position.y(), 0.});
    return static_cast<int>(n_points()) - 1;
  }



  void VtuWriter::add_cell(const CellShape shape, const int *nodes, const std::size_t n_nodes)
  {
    connectivity.insert(connectivity.end(), nodes, nodes + n_nodes);
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    shapes.push_back(static_cast<std::uint8_t>(shape));
  }



  void VtuWriter::add_cell(const CellShape shape, const std::vector<int> &nodes)
  {
    add_cell(shape, nodes.data(), nodes.size());
  }



  std::size_t VtuWriter::n_points() const
  {
    return points.size() / 3;
  }



  std::size_t VtuWriter::n_cells() const
  {
    return shapes.size();
  }



  void VtuWriter::add_point_field(const std::string &name, std::vector<double> values)
  {
    point_fields.push_back({name, {}, std::move(values)});
  }



  void VtuWriter::add_cell_field(const std::string &name, std::vector<double> values)
  {
    cell_fields.push_back({name, {}, std::move(values)});
  }



  void VtuWriter::add_point_field(const std::string              &name,
                                  const std::vector<std::string> &components,
                                  std::vector<double>             values)
  {
    point_fields.push_back({name, components, std::move(values)});
  }



  void VtuWriter::add_cell_field(const std::string              &name,
                                 const std::vector<std::string> &components,
                                 std::vector<double>             values)
  {
    cell_fields.push_back({name, components, std::move(values)});
  }



  void VtuWriter::add_fields(VtuFile                  &file,
                             const std::vector<Field> &fields,
                             const std::size_t         n_entities)
  {
    for (const Field &field : fields)
      {
        const std::size_t n = std::max<std::size_t>(1, field.components.size());
        if (field.values.size() != n * n_entities)
          throw std::logic_error("VTU field '" + field.name + "' has " +
                                 std::to_string(field.values.size()) + " values, expected " +
                                 std::to_string(n * n_entities) + ".");
        const std::size_t  n_written = n == 2 ? 3 : n;
        std::vector<float> values(n_written * n_entities, 0.f);
        for (std::size_t i = 0; i < n_entities; ++i)
          for (std::size_t c = 0; c < n; ++c)
            values[i * n_written + c] = static_cast<float>(field.values[i * n + c]);
        add_array(file, field.name, n == 2 ? directions : field.components, values);
      }
  }



  void VtuWriter::add_mesh(VtuFile &file) const
  {
    file.add_text("      <Points>\n");
    add_array(file, "Points", directions, points);
    file.add_text("      </Points>\n      <Cells>\n");
    add_array(file, "connectivity", no_names, connectivity);
    add_array(file, "offsets", no_names, offsets);
    add_array(file, "types", no_names, shapes);
    file.add_text("      </Cells>\n");
  }



  void VtuWriter::add_to(VtuFile          &file,
                         const std::size_t n_all_points,
                         const std::size_t n_all_cells) const
  {
    file.add_text(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" +
      std::to_string(n_all_points) + "\" NumberOfCells=\"" + std::to_string(n_all_cells) + "\">\n");
    add_mesh(file);
    file.add_text("      <PointData>\n");
    add_fields(file, point_fields, n_points());
    file.add_text("      </PointData>\n      <CellData>\n");
    add_fields(file, cell_fields, n_cells());
    file.add_text("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
  }



  void VtuWriter::write(const std::string &file_name) const
  {
    VtuText text;
    add_to(text, n_points(), n_cells());
    write_atomically(file_name, text.content());
  }



  void VtuWriter::write(const std::string &file_name, const MPI_Comm communicator)
  {
    std::uint64_t before = 0, mine = connectivity.size(), all[] = {n_points(), n_cells()};
    MPI_Exscan(&mine, &before, 1, MPI_UINT64_T, MPI_SUM, communicator);
    MPI_Allreduce(MPI_IN_PLACE, all, 2, MPI_UINT64_T, MPI_SUM, communicator);
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    for (std::int32_t &end : offsets)
      end += rank > 0 ? static_cast<std::int32_t>(before) : 0; // the first one's is undefined
    SharedVtu file(file_name, communicator);
    add_to(file, all[0], all[1]);
    file.finish();
  }
} // namespace hybrid::output
