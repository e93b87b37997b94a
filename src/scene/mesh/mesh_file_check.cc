// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/mesh_file_check.h>

#include <filesystem>
#include <fstream>

namespace hybrid::scene
{
  namespace
  {
    void check_last_line(const std::string &file)
    {
      constexpr std::size_t told = 40; // characters of a line, at most
      std::ifstream         text(file, std::ios::binary);
      std::string           line, last;
      int                   number = 0;
      while (std::getline(text, line))
        {
          ++number;
          last = text.eof() ? line : "";
        }
      if (last.find_first_not_of(" \t\r") == std::string::npos)
        return;
      if (last.size() > told)
        last = last.substr(0, told) + "...";
      throw InputError(file,
                       number,
                       "no line break ends the last line, '" + last +
                         "', and gmsh would leave it out: add one.");
    }
  } // namespace


  void check_mesh_file(const std::string &file)
  {
    std::error_code unknown; // a name that is too long, for instance: there is none, either
    if (!std::filesystem::is_regular_file(file, unknown))
      throw InputError(file, 0, "there is no such mesh file.");
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension != ".geo" && extension != ".msh")
      throw InputError(file, 0, "a mesh file must end in .geo or .msh.");
    if (extension == ".geo")
      check_last_line(file);
  }
} // namespace hybrid::scene
