// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/pvd_series.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <filesystem>

namespace hybrid::output
{
  PvdSeries::PvdSeries(std::string output_directory, std::string part)
    : directory(std::move(output_directory))
    , name(std::move(part))
  {
    std::error_code error;
    std::filesystem::create_directories(directory + "/vtu", error);
    if (error)
      throw InputError("cannot make the directory '" + directory + "/vtu': " + error.message() +
                       ".");
  }



  std::string PvdSeries::file_of(const std::size_t number) const
  {
    return formatted("vtu/%s_%05zu.vtu", name.c_str(), number);
  }



  void PvdSeries::add(const double time, const VtuWriter &picture)
  {
    add(time, [&picture](const std::string &file_name) { picture.write(file_name); });
  }



  void PvdSeries::add(const double time, const std::function<void(const std::string &)> &write)
  {
    write(directory + "/" + file_of(times.size()));
    times.push_back(time);
    write_pvd();
  }



  void PvdSeries::write_pvd() const
  {
    std::string xml = "<?xml version=\"1.0\"?>\n"
                      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                      "  <Collection>\n";
    for (std::size_t k = 0; k < times.size(); ++k)
      {
        if (missing.count(k) > 0)
          continue;
        xml += formatted("    <DataSet timestep=\"%.17g\" part=\"0\" file=\"%s\"/>\n",
                         times[k],
                         file_of(k).c_str());
      }
    xml += "  </Collection>\n</VTKFile>\n";
    write_atomically(directory + "/" + name + ".pvd", xml);
  }



  void PvdSeries::serialize(restart::Archive &archive)
  {
    archive(times);
    if (!archive.is_reading())
      return;
    missing.clear();
    for (std::size_t k = 0; k < times.size(); ++k)
      if (!std::filesystem::exists(directory + "/" + file_of(k)))
        missing.insert(k);
    write_pvd();
  }



  std::vector<std::string> PvdSeries::missing_files() const
  {
    std::vector<std::string> files;
    for (const std::size_t k : missing)
      files.push_back(file_of(k));
    return files;
  }
} // namespace hybrid::output
