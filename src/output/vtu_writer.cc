// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/vtu_writer.h>

#include <algorithm>
#include <stdexcept>
#include <zlib.h>

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


    /// One zlib block, as fast as it goes: pictures lose half of their size, and little of it more
    /// with other levels.
    std::vector<unsigned char> compressed(const void *data, const std::size_t n_bytes)
    {
      uLongf                     size = compressBound(n_bytes);
      std::vector<unsigned char> result(size);
      if (compress2(result.data(),
                    &size,
                    static_cast<const unsigned char *>(data),
                    n_bytes,
                    Z_BEST_SPEED) != Z_OK)
        throw std::runtime_error("zlib has no memory to compress a picture");
      result.resize(size);
      return result;
    }


    void append_base64(std::string &xml, const void *data, const std::size_t n_bytes)
    {
      Base64 encoder(xml);
      encoder.add(data, n_bytes);
      encoder.finish();
    }


    /// @param components names of the components; empty: one without name.
    template <typename Number>
    void append_array(std::string                    &xml,
                      const std::string              &name,
                      const std::vector<std::string> &components,
                      const std::vector<Number>      &values)
    {
      const std::size_t n = components.empty() ? 1 : components.size();
      xml += "        <DataArray type=\"" + std::string(vtk_type<Number>) + "\" Name=\"" +
             escaped(name) + "\" NumberOfComponents=\"" + std::to_string(n) + "\"";
      for (std::size_t c = 0; c < components.size(); ++c)
        xml += " ComponentName" + std::to_string(c) + "=\"" + escaped(components[c]) + "\"";
      xml += " format=\"binary\">";
      const std::uint64_t n_bytes = values.size() * sizeof(Number);
      const auto          block   = compressed(values.data(), n_bytes);
      // number of blocks, size of each and of a smaller last one, compressed sizes
      const std::uint64_t header[] = {n_bytes > 0 ? 1u : 0u, n_bytes, 0, block.size()};
      append_base64(xml, header, (n_bytes > 0 ? 4 : 3) * sizeof(std::uint64_t));
      if (n_bytes > 0)
        append_base64(xml, block.data(), block.size());
      xml += "</DataArray>\n";
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



  void VtuWriter::append_fields(std::string              &xml,
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
        append_array(xml, field.name, n == 2 ? directions : field.components, values);
      }
  }



  void VtuWriter::append_mesh(std::string &xml) const
  {
    xml += "      <Points>\n";
    append_array(xml, "Points", directions, points);
    xml += "      </Points>\n      <Cells>\n";
    append_array(xml, "connectivity", no_names, connectivity);
    append_array(xml, "offsets", no_names, offsets);
    append_array(xml, "types", no_names, shapes);
    xml += "      </Cells>\n";
  }



  void VtuWriter::write(const std::string &file_name) const
  {
    std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"" +
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
