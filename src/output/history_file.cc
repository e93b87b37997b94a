// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/hdf5_handle.h>
#include <hybrid/output/history_file.h>
#include <hybrid/restart/archive.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/scene/input_error.h>

#include <hdf5.h>

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace hybrid::output
{
  static_assert(sizeof(hid_t) == sizeof(std::int64_t),
                "the header stores HDF5 identifiers as int64_t");

  namespace
  {
    /// Size of a chunk and of a buffer [B]: 512 rows of two columns.
    constexpr std::size_t chunk_bytes = 8192;

    /// By this much the file grows in memory at once [B].
    constexpr std::size_t memory_increment = 1u << 22;

    using Handle = Hdf5Handle;


    void check(const herr_t status, const std::string &what)
    {
      if (status < 0)
        throw std::runtime_error("HDF5 failed to " + what);
    }


    hid_t make_dataspace(const std::size_t rows, const std::size_t columns, const bool extendible)
    {
      const hsize_t size[]    = {rows, columns};
      const hsize_t maximum[] = {extendible ? H5S_UNLIMITED : rows, columns};
      return H5Screate_simple(columns == 1 ? 1 : 2, size, maximum);
    }


    /// Link creation properties that make missing groups on the way.
    hid_t make_link_properties()
    {
      const hid_t properties = H5Pcreate(H5P_LINK_CREATE);
      H5Pset_create_intermediate_group(properties, 1);
      return properties;
    }


    /// Write an attribute, replacing one of the same name.
    void write_attribute(const hid_t        object,
                         const std::string &name,
                         const hid_t        type,
                         const hid_t        space,
                         const void        *data)
    {
      if (H5Aexists(object, name.c_str()) > 0)
        check(H5Adelete(object, name.c_str()), "replace attribute " + name);
      const Handle attribute(
        H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        "create attribute " + name);
      check(H5Awrite(attribute, type, data), "write attribute " + name);
    }


    /// A string of variable length in UTF-8, which every reader takes for text.
    void write_text(const hid_t object, const std::string &name, const std::string &text)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "copy a type");
      H5Tset_size(type, H5T_VARIABLE);
      H5Tset_cset(type, H5T_CSET_UTF8);
      const Handle      space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
      const char *const characters = text.c_str();
      write_attribute(object, name, type, space, &characters);
    }


    bool can_write(const std::string &file_name)
    {
      const bool good = std::ofstream(file_name).is_open();
      std::remove(file_name.c_str());
      return good;
    }


    hid_t open_file(const std::string &file_name, const HistoryFile::Mode mode)
    {
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // failures are exceptions
      const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file properties");
      // Old format: the newest one marks a file as open for writing.
      H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
      H5Pset_fapl_core(access, memory_increment, false); // in memory, nothing is written by HDF5
      const bool create = mode == HistoryFile::Mode::create;
      hid_t      file   = -1;
      if (!create)
        file = H5Fopen(file_name.c_str(), H5F_ACC_RDWR, access);
      else if (can_write(restart::temporary_name(file_name)))
        file = H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
      if (file < 0)
        throw InputError(
          create
            ? "cannot create '" + file_name + "': the directory must exist and be writable."
            : "cannot open '" + file_name +
                "' to continue it: it must be the run.h5 of an earlier run, which no other program has open.");
      return file;
    }
  } // namespace



  HistoryFile::HistoryFile(const std::string &name, const Mode mode)
    : file_name(name)
    , file(open_file(name, mode))
  {}



  HistoryFile::~HistoryFile()
  {
    if (file < 0)
      return;
    try
      {
        flush();
      }
    catch (const std::exception &)
      {
        // the file is that of the last flush; nothing may leave a destructor
      }
    close();
  }



  void HistoryFile::close()
  {
    for (const Series &series : all_series)
      H5Dclose(series.dataset);
    all_series.clear();
    H5Fclose(file);
    file = -1;
  }



  bool HistoryFile::exists(const std::string &path) const
  {
    for (std::size_t end = path.find('/', 1); end != std::string::npos;
         end             = path.find('/', end + 1))
      if (H5Lexists(file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        return false;
    return path == "/" || H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
  }



  int HistoryFile::add_series(const std::string &path,
                              const std::string &unit,
                              const std::size_t  columns,
                              const std::string &description,
                              const Precision    precision)
  {
    assert(columns > 0);
    Series series;
    series.path     = path;
    series.columns  = columns;
    series.capacity = std::max<std::size_t>(chunk_bytes / (sizeof(double) * columns), 1);
    series.buffer.resize(series.capacity * columns);
    if (exists(path))
      open_series(series);
    else
      series.dataset = create_series(series, unit, description, precision);
    all_series.push_back(std::move(series));
    return static_cast<int>(all_series.size()) - 1;
  }



  std::int64_t HistoryFile::create_series(const Series      &series,
                                          const std::string &unit,
                                          const std::string &description,
                                          const Precision    precision)
  {
    const Handle  space(make_dataspace(0, series.columns, true), H5Sclose, "make a data space");
    const Handle  links(make_link_properties(), H5Pclose, "make link properties");
    const Handle  creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make data set properties");
    const hsize_t chunk[] = {series.capacity, series.columns};
    H5Pset_chunk(creation, series.columns == 1 ? 1 : 2, chunk);
    H5Pset_obj_track_times(creation, false); // equal runs give equal bytes
    const hid_t type = precision == Precision::single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
    const hid_t dataset =
      H5Dcreate2(file, series.path.c_str(), type, space, links, creation, H5P_DEFAULT);
    check(dataset < 0 ? -1 : 0, "create data set " + series.path + " in " + file_name);
    write_text(dataset, "unit", unit);
    write_text(dataset, "description", description);
    return dataset;
  }



  void HistoryFile::open_series(Series &series)
  {
    series.dataset = H5Dopen2(file, series.path.c_str(), H5P_DEFAULT);
    check(series.dataset < 0 ? -1 : 0, "open data set " + series.path + " in " + file_name);
    const Handle space(H5Dget_space(series.dataset), H5Sclose, "read a data space");
    hsize_t      size[] = {0, 1};
    const int    rank   = H5Sget_simple_extent_ndims(space);
    if (rank == 1 || rank == 2)
      H5Sget_simple_extent_dims(space, size, nullptr);
    if (rank != (series.columns == 1 ? 1 : 2) || size[1] != series.columns)
      {
        H5Dclose(series.dataset);
        throw InputError("data set '" + series.path + "' of '" + file_name +
                         "' has another shape than this scene: it belongs to another scene.");
      }
    series.written = size[0];
  }



  void HistoryFile::append(const int index, const double *values)
  {
    Series &series = all_series[index];
    std::copy_n(values, series.columns, series.buffer.begin() + series.buffered * series.columns);
    if (++series.buffered == series.capacity)
      write_buffer(series);
  }



  void HistoryFile::write_buffer(Series &series)
  {
    if (series.buffered == 0)
      return;
    errno                  = 0;
    const hsize_t size[]   = {series.written + series.buffered, series.columns};
    const hsize_t offset[] = {series.written, 0};
    const hsize_t count[]  = {series.buffered, series.columns};
    check(H5Dset_extent(series.dataset, size), "extend " + series.path + " in " + file_name);
    const Handle space(H5Dget_space(series.dataset), H5Sclose, "read a data space");
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, offset, nullptr, count, nullptr),
          "select rows");
    const Handle memory(make_dataspace(series.buffered, series.columns, false),
                        H5Sclose,
                        "make a data space");
    check(
      H5Dwrite(series.dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, series.buffer.data()),
      "write " + series.path + " in " + file_name);
    series.written += series.buffered;
    series.buffered = 0;
  }



  std::size_t HistoryFile::rows(const int index) const
  {
    return all_series[index].written + all_series[index].buffered;
  }



  void HistoryFile::truncate(const int index, const std::size_t rows)
  {
    Series &series = all_series[index];
    write_buffer(series);
    if (rows >= series.written)
      return;
    const hsize_t size[] = {rows, series.columns};
    check(H5Dset_extent(series.dataset, size), "cut " + series.path + " in " + file_name);
    series.written = rows;
  }



  void HistoryFile::write_table(const std::string &path,
                                const std::string &unit,
                                const double      *values,
                                const std::size_t  rows,
                                const std::size_t  columns,
                                const std::string &description)
  {
    write_static({path, unit, description, rows, columns},
                 H5T_IEEE_F64LE,
                 H5T_NATIVE_DOUBLE,
                 values);
  }



  void HistoryFile::declare_table(const std::string &path,
                                  const std::string &unit,
                                  const std::size_t  rows,
                                  const std::size_t  columns,
                                  const std::string &description)
  {
    write_static({path, unit, description, rows, columns},
                 H5T_IEEE_F64LE,
                 H5T_NATIVE_DOUBLE,
                 nullptr);
  }



  void HistoryFile::write_integers(const std::string      &path,
                                   const std::vector<int> &values,
                                   const std::string      &description)
  {
    write_static({path, "1", description, values.size(), 1},
                 H5T_STD_I32LE,
                 H5T_NATIVE_INT,
                 values.data());
  }



  void HistoryFile::write_static(const StaticArray &array,
                                 const std::int64_t in_file,
                                 const std::int64_t in_memory,
                                 const void        *values)
  {
    const auto &[path, unit, description, rows, columns] = array;
    remove(path);
    const Handle space(make_dataspace(rows, columns, false), H5Sclose, "make a data space");
    const Handle links(make_link_properties(), H5Pclose, "make link properties");
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make data set properties");
    H5Pset_obj_track_times(creation, false);
    const Handle dataset(
      H5Dcreate2(file, path.c_str(), in_file, space, links, creation, H5P_DEFAULT),
      H5Dclose,
      "create data set " + path + " in " + file_name);
    if (values != nullptr && rows * columns > 0)
      check(H5Dwrite(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
            "write " + path + " in " + file_name);
    write_text(dataset, "unit", unit);
    write_text(dataset, "description", description);
  }



  void HistoryFile::remove(const std::string &path)
  {
    if (exists(path))
      check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), "remove " + path + " from " + file_name);
  }



  namespace
  {
    /// Open a data set or group, making the group if nothing is there.
    hid_t open_object(const hid_t file, const std::string &path, const bool is_there)
    {
      if (is_there)
        return H5Oopen(file, path.c_str(), H5P_DEFAULT);
      const Handle links(make_link_properties(), H5Pclose, "make link properties");
      return H5Gcreate2(file, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT);
    }
  } // namespace



  void HistoryFile::set_attribute(const std::string &path,
                                  const std::string &name,
                                  const std::string &text)
  {
    const Handle object(open_object(file, path, exists(path)), H5Oclose, "open " + path);
    write_text(object, name, text);
  }



  void HistoryFile::set_attribute(const std::string         &path,
                                  const std::string         &name,
                                  const std::vector<double> &values)
  {
    const Handle  object(open_object(file, path, exists(path)), H5Oclose, "open " + path);
    const hsize_t size[] = {values.size()};
    const Handle  space(H5Screate_simple(1, size, nullptr), H5Sclose, "make a data space");
    write_attribute(object, name, H5T_NATIVE_DOUBLE, space, values.data());
  }



  void HistoryFile::flush(const bool durable)
  {
    write_image(file_name, durable);
  }



  void HistoryFile::close_into(const std::string &other_file)
  {
    write_image(other_file, false);
    close();
  }



  void HistoryFile::write_image(const std::string &to, const bool durable)
  {
    for (Series &series : all_series)
      write_buffer(series);
    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush " + file_name);
    const ssize_t size = H5Fget_file_image(file, nullptr, 0);
    check(size < 0 ? -1 : 0, "measure " + file_name);
    std::vector<char> image(static_cast<std::size_t>(size));
    check(H5Fget_file_image(file, image.data(), image.size()) != size ? -1 : 0,
          "copy " + file_name);
    restart::replace_file(to, std::string_view(image.data(), image.size()), durable);
  }



  std::vector<double> HistoryFile::read(const int index)
  {
    Series &series = all_series[index];
    write_buffer(series);
    std::vector<double> values(series.written * series.columns);
    if (!values.empty())
      check(
        H5Dread(series.dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "read " + series.path + " in " + file_name);
    return values;
  }



  void HistoryFile::serialize(restart::Archive &archive)
  {
    std::vector<std::uint64_t> lengths;
    for (std::size_t k = 0; k < all_series.size(); ++k)
      lengths.push_back(rows(static_cast<int>(k)));
    archive(lengths);
    for (std::size_t k = 0; archive.is_reading() && k < all_series.size(); ++k)
      {
        if (k >= lengths.size() || rows(static_cast<int>(k)) < lengths[k])
          throw InputError("'" + file_name + "' has fewer rows of " + all_series[k].path +
                           " than the checkpoint: it is not the file of that run");
        truncate(static_cast<int>(k), lengths[k]);
      }
  }
} // namespace hybrid::output
