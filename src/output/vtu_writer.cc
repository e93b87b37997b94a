// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/vtu_writer.h>

#include <cassert>
#include <stdexcept>

namespace hybrid::output
{
  namespace
  {
    /// Base64 of bytes that come in several pieces.
    class Base64
    {
    public:
      explicit Base64(std::string &target)
        : text(target)
      {}

      void add(const void *data, const std::size_t n_bytes)
      {
        const auto *bytes = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < n_bytes; ++i)
          {
            group = (group << 8) | bytes[i];
            if (++n_in_group == 3)
              write_group();
          }
      }

      void finish()
      {
        if (n_in_group == 0)
          return;
        const int missing = 3 - n_in_group;
        group <<= 8 * missing;
        n_in_group = 3;
        write_group();
        for (int i = 0; i < missing; ++i)
          text[text.size() - 1 - i] = '=';
      }

    private:
      void write_group()
      {
        static constexpr char digits[] =
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (int shift = 18; shift >= 0; shift -= 6)
          text += digits[(group >> shift) & 63];
        group      = 0;
        n_in_group = 0;
      }

      std::string  &text;
      std::uint32_t group      = 0;
      int           n_in_group = 0;
    };


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


    template <typename Number>
    void append_array(std::string               &xml,
                      const std::string         &name,
                      const int                  components,
                      const std::vector<Number> &values)
    {
      xml += "        <DataArray type=\"" + std::string(vtk_type<Number>) + "\" Name=\"" +
             escaped(name) + "\" NumberOfComponents=\"" + std::to_string(components) +
             "\" format=\"binary\">";
      const std::uint64_t n_bytes = values.size() * sizeof(Number);
      xml.reserve(xml.size() + 4 * (n_bytes + 16) / 3);
      Base64 encoder(xml);
      encoder.add(&n_bytes, sizeof(n_bytes));
      encoder.add(values.data(), n_bytes);
      encoder.finish();
      xml += "</DataArray>\n";
    }
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



  void VtuWriter::add_point_field(const std::string  &name,
                                  const int           components,
                                  std::vector<double> values)
  {
    point_fields.push_back({name, components, std::move(values)});
  }



  void VtuWriter::add_cell_field(const std::string  &name,
                                 const int           components,
                                 std::vector<double> values)
  {
    cell_fields.push_back({name, components, std::move(values)});
  }



  void VtuWriter::append_fields(std::string              &xml,
                                const std::vector<Field> &fields,
                                const std::size_t         n_entities)
  {
    for (const Field &field : fields)
      {
        const std::size_t n = field.components;
        if (field.values.size() != n * n_entities)
          throw std::logic_error("VTU field '" + field.name + "' has " +
                                 std::to_string(field.values.size()) + " values, expected " +
                                 std::to_string(n * n_entities) + ".");
        const std::size_t  n_written = n == 2 ? 3 : n;
        std::vector<float> values(n_written * n_entities, 0.f);
        for (std::size_t i = 0; i < n_entities; ++i)
          for (std::size_t c = 0; c < n; ++c)
            values[i * n_written + c] = static_cast<float>(field.values[i * n + c]);
        append_array(xml, field.name, static_cast<int>(n_written), values);
      }
  }



  void VtuWriter::append_mesh(std::string &xml) const
  {
    xml += "      <Points>\n";
    append_array(xml, "Points", 3, points);
    xml += "      </Points>\n      <Cells>\n";
    append_array(xml, "connectivity", 1, connectivity);
    append_array(xml, "offsets", 1, offsets);
    append_array(xml, "types", 1, shapes);
    xml += "      </Cells>\n";
  }



  void VtuWriter::write(const std::string &file_name) const
  {
    std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" +
      std::to_string(n_points()) + "\" NumberOfCells=\"" + std::to_string(n_cells()) + "\">\n";
    append_mesh(xml);
    xml += "      <PointData>\n";
    append_fields(xml, point_fields, n_points());
    xml += "      </PointData>\n      <CellData>\n";
    append_fields(xml, cell_fields, n_cells());
    xml += "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
    write_atomically(file_name, xml);
  }
} // namespace hybrid::output
