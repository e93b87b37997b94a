// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/corner_levels.h>
#include <hybrid/scene/parameters/parameter_declarations.h>

#include <algorithm>

namespace hybrid::scene
{
  namespace
  {
    std::vector<std::pair<std::string, double>> parse_mesh_numbers(const std::string &text)
    {
      std::vector<std::pair<std::string, double>> numbers;
      for (const auto &pair : parse_pairs(text, '='))
        {
          const std::optional<double> number = parse_number(pair.second);
          if (!number)
            throw InputError("'" + pair.second + "' of '" + pair.first + "' must be a number");
          numbers.emplace_back(pair.first, *number);
        }
      return numbers;
    }

    bool ends_with(const std::string &text, const std::string &ending)
    {
      return text.size() >= ending.size() &&
             text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
    }
  } // namespace

  void declare(ParameterTable &table, MeshParameters &mesh)
  {
    ParameterSection section(table, {"Mesh"});
    section.file("File",
                 mesh.file,
                 "a .geo or .msh file of gmsh",
                 "The meshed section. Physical groups carry the meaning: bedrock, sliding_mass, "
                 "sliding_surface, bedding_<n>, base, left, right, ground.");
    section.value(
      "Numbers",
      "'name = number; name = number; ...'",
      [&mesh](const std::string &text) { mesh.numbers = parse_mesh_numbers(text); },
      "Numbers of the .geo file (DefineConstant) to change before meshing, e.g. Resolution/h = 4 [m].");
    section.choice(
      "Error estimate",
      mesh.coarser_runs,
      {{"automatic", true}, {"one run", false}},
      "Where the mesh is of a .geo file with numbers Resolution/..., automatic computes the scene that has "
      "ended once more with all of them twice and four times as large, up to the first failed joint, and tells the "
      "error of the mesh from the differences: a quarter to a half as much time again, and as much once more where "
      "cells at inward corners do not get larger (Corner levels). With one run, or a Time/Error target, it does not.");
    section.integer(
      "Corner levels",
      mesh.corner_levels,
      {0, most_corner_levels},
      "How often cells at inward corners of the bedrock (more than 10 degrees, where no block is) are halved towards "
      "the corner, two more cells for each there: what a corner leaves of errors falls with them. 3 to 5 are enough.");
    section.file(
      "Polygons file",
      mesh.polygons_file,
      "a CSV file block,x,y [m]",
      "Blocks as polygons, vertices counter-clockwise, instead of those of the mesh; a fourth column "
      "is the region (sliding_mass, sliding_mass_<suffix>), by which Blocks/Material may differ.");
    section.file(
      "Surface file",
      mesh.surface_file,
      "a CSV file x,y [m]",
      "Polyline of a rigid base instead of the surface of the mesh; for Model/Bedrock = rigid.");
  }

  std::vector<std::string> left_out_numbers(const std::vector<ParameterLine> &lines)
  {
    const ParameterLine *of_file = nullptr, *given = nullptr;
    for (const ParameterLine &line : lines)
      if (line.path() == "Mesh/Numbers")
        (line.is_override ? given : of_file) = &line;
    std::vector<std::string> result;
    if (of_file == nullptr || given == nullptr)
      return result;
    try
      {
        const auto kept = parse_pairs(given->value, '=');
        for (const auto &[name, number] : parse_pairs(of_file->value, '='))
          if (std::none_of(kept.begin(), kept.end(), [&name = name](const auto &pair) {
                return pair.first == name;
              }))
            result.push_back(name + " = " + number);
      }
    catch (const InputError &) // what is replaced need not be right
      {}
    return result;
  }



  void check_mesh(const SceneParameters &scene, const ParameterTable &table)
  {
    const MeshParameters &mesh = scene.mesh;
    if (!mesh.file.empty() && !ends_with(mesh.file, ".geo") && !ends_with(mesh.file, ".msh"))
      throw table.error("Mesh/File", "must be a .geo or .msh file");
    if (!mesh.numbers.empty() && !ends_with(mesh.file, ".geo"))
      throw table.error("Mesh/Numbers", "only a .geo file in Mesh/File has numbers to set");
    if (mesh.file.empty() && scene.has_continuum())
      throw table.error("Mesh/File",
                        "Model/Bedrock = continuum needs a mesh: name a .geo or .msh file");
    if (mesh.corner_levels > 0 && !scene.has_continuum())
      throw table.error("Mesh/Corner levels",
                        "must be 0: only Model/Bedrock = continuum has cells to halve");
    if (mesh.file.empty() && scene.has_bedrock_blocks())
      throw table.error("Mesh/File", "a bedrock of blocks needs a mesh: name a .geo or .msh file");
    if (mesh.file.empty() && mesh.polygons_file.empty())
      throw table.error("Mesh/File",
                        "name a .geo or .msh file here, or blocks in Mesh/Polygons file");
    if (!mesh.surface_file.empty() && scene.has_continuum())
      throw table.error("Mesh/Surface file",
                        "with Model/Bedrock = continuum the surface is that of the mesh; "
                        "remove this file or set Model/Bedrock = rigid");
    if (!mesh.surface_file.empty() && scene.has_bedrock_blocks())
      throw table.error("Mesh/Surface file",
                        "only a rigid base (Model/Bedrock = rigid) can have one");
  }
} // namespace hybrid::scene
