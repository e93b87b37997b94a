// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/pvd_series.h>
#include <hybrid/scene/input_error.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace hybrid::output
{
  namespace
  {
    constexpr char time_tag[] = "timestep=\"";
    constexpr char file_tag[] = "file=\"";

    /// The value of an attribute in a line, empty if it is not there.
    std::string attribute(const std::string &line, const std::string &tag)
    {
      const std::size_t begin = line.find(tag);
      if (begin == std::string::npos)
        return "";
      const std::size_t end = line.find('"', begin + tag.size());
      return line.substr(begin + tag.size(), end - begin - tag.size());
    }
  } // namespace



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



  void PvdSeries::add(const double time, const VtuWriter &picture)
  {
    char number[24];
    std::snprintf(number, sizeof(number), "_%05zu.vtu", pictures.size());
    const std::string file = "vtu/" + name + number;
    picture.write(directory + "/" + file);
    pictures.emplace_back(time, file);
    write_pvd();
  }



  void PvdSeries::write_pvd() const
  {
    std::string xml = "<?xml version=\"1.0\"?>\n"
                      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                      "  <Collection>\n";
    for (const auto &[time, file] : pictures)
      {
        char number[32];
        std::snprintf(number, sizeof(number), "%.17g", time);
        xml += "    <DataSet " + std::string(time_tag) + number + "\" part=\"0\" " + file_tag +
               file + "\"/>\n";
      }
    xml += "  </Collection>\n</VTKFile>\n";
    write_atomically(directory + "/" + name + ".pvd", xml);
  }



  void PvdSeries::resume(const double last_time)
  {
    pictures.clear();
    std::ifstream file(directory + "/" + name + ".pvd");
    for (std::string line; std::getline(file, line);)
      {
        const std::string time = attribute(line, time_tag), vtu = attribute(line, file_tag);
        if (!time.empty() && !vtu.empty() && std::strtod(time.c_str(), nullptr) <= last_time)
          pictures.emplace_back(std::strtod(time.c_str(), nullptr), vtu);
      }
    write_pvd();
  }
} // namespace hybrid::output
