// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/parameter_declarations.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/scene/parameters/strength_reduction.h>
#include <hybrid/scene/parameters/time_integrator.h>
#include <hybrid/scene/path_hint.h>

#include <ostream>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    const int max_threads       = 1024;
    const int max_shared_blocks = 1000000000;

    /// First pass: the names of the materials, which are sections of the second pass.
    void make_material_table(const std::vector<ParameterLine> &lines, SceneParameters &scene)
    {
      for (const ParameterLine &line : lines)
        if (line.path() == "Materials/Names")
          try
            {
              scene.materials.clear();
              for (const std::string &name : parse_names(line.value))
                scene.materials[name].name = name;
            }
          catch (const InputError &reason)
            {
              throw line.error(line.path() + " = '" + line.value + "': " + reason.what());
            }
    }

    void declare_model(ParameterTable &table, SceneParameters &scene)
    {
      ParameterSection model(table, {"Model"});
      model.option(
        "Bedrock",
        scene.bedrock,
        bedrock_models(),
        "The bedrock: elastic finite elements; one block per layer between bedding planes, the lowest "
        "with the prescribed motion; bonded triangular blocks that carry the waves; or a rigid base "
        "with the prescribed motion. All but the first are pure DDA.");
      model.choice(
        "Blocks",
        {"bonded", "loose", "none"},
        "bonded",
        [&scene](const std::string &option) {
          scene.blocks.enabled = option != "none";
          scene.blocks.bonded  = option == "bonded";
        },
        "The sliding mass: blocks bonded by joints that can fail, loose blocks, or none (site response).");
    }

    std::vector<ParameterLine> read_lines(const std::string              &file,
                                          const std::vector<std::string> &overrides)
    {
      std::vector<ParameterLine> lines = scan_parameter_file(file);
      for (const std::string &option : overrides)
        lines.push_back(parse_override(option));
      return lines;
    }

    SceneParameters make_scene(const std::string &file, const std::vector<ParameterLine> &lines)
    {
      SceneParameters scene;
      ParameterTable  table(file);
      make_material_table(lines, scene);
      declare(table, scene);
      for (const ParameterLine &line : lines)
        table.set(line);
      table.assign();
      scene.mesh.left_out           = left_out_numbers(lines);
      scene.motion.file_unit_is_set = table.is_set("Motion/Unit");
      for (auto &[name, material] : scene.materials)
        if (material.friction_is_given())
          material.friction_angle = material.given_friction_angle;
      resolve_sides(scene);
      resolve_scheme(scene, table);
      resolve_time_integrator(scene, table);
      check_linear_solver(scene, table);
      read_water(scene, table);
      check(scene, table);
      resolve_initial_stress(scene, table);
      divide_strengths(scene, scene.strength_reduction);
      std::ostringstream used;
      table.print(used);
      scene.used_prm = used.str();
      return scene;
    }

    /// What print_all_parameters() shows in the place of the user's own materials.
    const char *const example[] = {"Materials/Names=rock, soil",
                                   "Materials/rock/Density=2450",
                                   "Materials/rock/Young modulus=60e9",
                                   "Materials/rock/Poisson ratio=0.2",
                                   "Materials/rock/Friction angle=38",
                                   "Materials/rock/Cohesion=2e6",
                                   "Materials/rock/Tensile strength=2e6",
                                   "Materials/soil/Density=2220",
                                   "Materials/soil/Young modulus=50e6",
                                   "Materials/soil/Friction angle=27",
                                   "Materials/soil/Cohesion=80e3",
                                   "Materials/soil/Tensile strength=60e3",
                                   "Continuum/Materials=rock",
                                   "Blocks/Material=soil"};
  } // namespace

  void declare(ParameterTable &table, SceneParameters &scene)
  {
    ParameterSection(table, {}).text("Title", scene.title, "any text", "One line about the scene.");
    declare(table, scene.time);
    declare(table, scene.mesh);
    declare_model(table, scene);
    ParameterSection(table, {"Materials"})
      .value(
        "Names",
        "names separated by commas",
        [](const std::string &) {}, // taken in the first pass
        "The materials; each has a subsection of its name here.");
    ParameterSection(table, {"Materials"})
      .number(
        "Strength reduction factor",
        scene.strength_reduction,
        "",
        ParameterRange::closed(1e-6, 1e6),
        "Cohesion, tensile strength and tan(friction angle) of all materials and bedding planes "
        "are divided by it; hybrid fos looks for the one at which the slope fails.");
    for (auto &entry : scene.materials)
      declare(table, entry.second);
    declare(table, scene.continuum);
    declare(table, scene.maxwell);
    declare(table, scene.bedding);
    declare(table, scene.blocks);
    declare(table, scene.heterogeneity);
    declare(table, scene.environment);
    declare(table, scene.motion);
    declare(table, scene.point_loads);
    declare(table, scene.edge_loads);
    declare(table, scene.initial_wave);
    declare(table, scene.monitors);
    declare(table, scene.output);
    declare(table, scene.checkpoint);
    ParameterSection parallel(table, {"Parallel"});
    parallel.integer("Threads",
                     scene.threads,
                     {1, max_threads},
                     "Threads of one run; results do not depend on it.");
    parallel.integer("Shared blocks",
                     scene.shared_blocks,
                     {2, max_shared_blocks},
                     "Under mpirun, the number of blocks from which on processes share them out; "
                     "results do not depend on it.");
  }

  void check(const SceneParameters &scene, const ParameterTable &table)
  {
    if (!scene.has_continuum() && !scene.has_blocks())
      throw table.error("Model/Blocks",
                        "together with Model/Bedrock = " + scene.bedrock.name +
                          " there is nothing to simulate");
    check(scene.time, table);
    for (const auto &entry : scene.materials)
      check(entry.second, table);
    check_mesh(scene, table);
    check_continuum(scene, table);
    check_maxwell(scene, table);
    check_bedrock(scene, table);
    check_blocks(scene, table);
    check_water(scene, table);
    check_point_loads(scene, table);
    check_edge_loads(scene, table);
    check_initial_wave(scene, table);
    check(scene.motion, table);
    check(scene.monitors, table);
    if (scene.output.directory.empty())
      throw table.error("Output/Directory", "must name a directory");
    const std::string hint = path_hint(scene.output.directory);
    if (!hint.empty())
      throw table.error("Output/Directory", "is not a path as it stands" + hint);
  }

  SceneParameters read_scene(const std::string &file, const std::vector<std::string> &overrides)
  {
    return make_scene(file, read_lines(file, overrides));
  }

  void print_all_parameters(std::ostream &out)
  {
    std::vector<ParameterLine> lines;
    for (const char *setting : example)
      lines.push_back(parse_override(setting));

    SceneParameters scene;
    ParameterTable  table("example");
    make_material_table(lines, scene);
    declare(table, scene);
    for (const ParameterLine &line : lines)
      table.set(line);
    table.print(out);
  }
} // namespace hybrid::scene
