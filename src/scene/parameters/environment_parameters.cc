// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>
#include <hybrid/scene/parameters/parameter_values.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    const char *const jaky                  = "1 - sin phi";
    const char *const initial_stress_values = "elastic, a number >= 0 and <= 10, 1 - sin phi, "
                                              "'material: one of these; ...', or staged";
    const char *const initial_stress_path   = "Gravity/Initial stress";
    constexpr double  largest_ratio         = 10.;



    /// Sets Material::initial_ratio by what the user says of it. @return false for nonsense
    bool set_ratio(Material &material, const std::string &value)
    {
      const std::optional<double> number = parse_number(value);
      if (number)
        material.initial_ratio = *number;
      else if (value == jaky && material.friction_is_given())
        material.initial_ratio = 1. - std::sin(material.friction_angle * M_PI / 180.);
      return number ? *number >= 0. && *number <= largest_ratio
                    : value == jaky || value == "elastic";
    }



    /// Lifts are carried by joints, and have weight.
    void check_staged(const SceneParameters &scene, const ParameterTable &table)
    {
      const auto needs = [&](const char *what) {
        return table.error(initial_stress_path, std::string("needs ") + what);
      };
      if (!scene.blocks.enabled || !scene.blocks.bonded)
        throw needs("a bonded mass that is placed in lifts: Model/Blocks = bonded");
      if (scene.blocks.belt_material.empty())
        throw needs("Blocks/Belt material: joints have to hold the lifts to the ground");
      if (scene.environment.gravity == 0.)
        throw needs("gravity; Gravity/Acceleration is 0");
    }
  } // namespace



  void declare(ParameterTable &table, EnvironmentParameters &environment)
  {
    ParameterSection gravity(table, {"Gravity"});
    gravity.number("Acceleration",
                   environment.gravity,
                   "m/s2",
                   ParameterRange::closed(0., 1e4),
                   "Downward acceleration; 0 switches gravity off.");
    gravity.number("Horizontal coefficient",
                   environment.horizontal,
                   "",
                   ParameterRange::closed(-100., 100.),
                   "Pseudo-static coefficient k: a lasting force k times mass times Acceleration "
                   "along +x on all that has mass, in the static stage and after it.");
    gravity.choice<StaticStage>(
      "Static stage",
      environment.static_stage,
      {{"equilibrium", StaticStage::equilibrium},
       {"equilibrium or move", StaticStage::move},
       {"held", StaticStage::held},
       {"none", StaticStage::none}},
      "Before the dynamic stage: equilibrium lets the blocks settle with their strengths active, and "
      "the run ends if they cannot stand or fall elsewhere; equilibrium or move goes on where they are then; held has "
      "unlimited friction and bonds (for masses that cannot stand), none starts "
      "unloaded. This is of blocks: bedding planes of finite elements that slip bear the weight of "
      "the rock from the start.");
    gravity.toggle("Reset softening",
                   environment.reset_softening,
                   "Strengths are those of today's slope: slip while it settles takes nothing of "
                   "them, and slip and softening count from the state at rest; what has opened "
                   "then stays failed.");
    gravity.text(
      "Initial stress",
      environment.initial_stress,
      initial_stress_values,
      "Horizontal over vertical effective stress before the static stage, which then finds "
      "equilibrium with strengths active. elastic: that of gravity switched on, nu/(1 - nu) "
      "on level ground; a number: K0 of the overburden's stress, in blocks and bedrock; "
      "1 - sin phi: K0 by each material's Friction angle, elastic if it has none; by "
      "material: those that are not named are elastic; staged: the mass is placed in Lifts, "
      "each without stress on those below, bonds intact, and the bedrock is elastic.");
    gravity.integer(
      "Lifts",
      environment.lifts,
      {1, 1000},
      "Horizontal lifts, equally high, in which the mass is placed from below; a block "
      "belongs to that of its centroid. Without Initial stress = staged it has no "
      "effect.");
    ParameterSection water(table, {"Water"});
    water.number_or(
      "Level",
      {"none", environment.water_level},
      "m",
      ParameterRange::closed(-1e5, 1e5),
      "Elevation of the water; blocks and belt that start below it have their saturated "
      "materials.");
    water.file(
      "Level file",
      environment.water_tables.level_file,
      "a CSV file time [s],level [m]",
      "The level in time instead of Level, linear between its rows and constant beyond them: "
      "weights and pressures of submerged and pressures follow in the dynamic stage. The "
      "static stage and the saturated materials have the level at 0 s.");
    water.file(
      "Line file",
      environment.water_tables.line_file,
      "a CSV file x,y [m]",
      "Phreatic line h(x), linear between its points and constant beyond them: pore pressure "
      "rho_w g (h - y) below it. With a level as well, the higher of the two counts.");
    water.choice<WaterMethod>(
      "Method",
      environment.water_method,
      {{"paper", WaterMethod::paper},
       {"submerged", WaterMethod::submerged},
       {"pressures", WaterMethod::pressures}},
      "What water does to weights: paper: nothing, the saturated material's densities are mass and "
      "weight as given; submerged: Density is total, the submerged part of each block has its "
      "buoyancy; pressures: Density is total, hydrostatic pressure acts on all faces, in joints, "
      "cracks and contacts and on the bedrock. The last two give the same effective forces.");
    water.choice<WaterPlace>(
      "Static place",
      environment.static_water,
      {{"moved", WaterPlace::moved}, {"drawn", WaterPlace::drawn}},
      "Where blocks have the water's load in the static stage (submerged and pressures): moved: "
      "where they have settled; drawn: where they were drawn, so that a mass that cannot stand does "
      "not slide out of the water's thrust and rest. hybrid fos asks with drawn.");
    water.number("Density",
                 environment.water_density,
                 "kg/m3",
                 ParameterRange::above(0.),
                 "Density of the water (submerged and pressures).");
  }

  void resolve_initial_stress(SceneParameters &scene, const ParameterTable &table)
  {
    const EnvironmentParameters &around = scene.environment;
    const char *const            path   = initial_stress_path;
    if (!around.has_initial_stress() && !around.is_staged())
      return;
    if (around.static_stage == StaticStage::none)
      throw table.error(path, "needs a static stage; Gravity/Static stage is none");
    if (around.is_staged())
      {
        check_staged(scene, table);
        return;
      }
    const auto refuse = [&] {
      return table.error(path, std::string("must be ") + initial_stress_values);
    };
    if (around.initial_stress.find(':') == std::string::npos)
      {
        for (auto &[name, material] : scene.materials)
          if (!set_ratio(material, around.initial_stress))
            throw refuse();
        return;
      }
    std::vector<std::pair<std::string, std::string>> values;
    try
      {
        values = parse_pairs(around.initial_stress, ':');
      }
    catch (const InputError &reason)
      {
        throw table.error(path, reason.what());
      }
    for (const auto &[name, value] : values)
      {
        check_material_name(scene, name, path, table);
        if (!set_ratio(scene.materials.at(name), value))
          throw refuse();
      }
  }



  void read_water(SceneParameters &scene, const ParameterTable &table)
  {
    constexpr double       farthest = 1e9, highest = 1e5; // [m, s], [m]
    EnvironmentParameters &around = scene.environment;
    WaterTables           &tables = around.water_tables;
    around.water_method_is_set    = table.is_set("Water/Method");
    if (!tables.line_file.empty())
      tables.line = read_linear_table(tables.line_file, {"x [m]", farthest}, {"y [m]", highest});
    if (tables.level_file.empty())
      return;
    if (around.has_level())
      throw table.error("Water/Level file",
                        "gives the level in time, and Water/Level = " +
                          number_text(around.water_level) +
                          " [m] another; one of the two is allowed");
    tables.level =
      read_linear_table(tables.level_file, {"time [s]", farthest}, {"level [m]", highest});
    around.water_level = tables.level(0.);
  }



  void check_water(const SceneParameters &scene, const ParameterTable &table)
  {
    const EnvironmentParameters &around = scene.environment;
    const bool                   moves  = !around.water_tables.level.empty();
    if (moves && around.water_method == WaterMethod::paper)
      throw table.error("Water/Level file",
                        "has no effect with Water/Method = paper, which only chooses materials at "
                        "the start; set submerged or pressures");
    if (moves && around.water_method == WaterMethod::pressures && scene.has_bedrock_blocks())
      throw table.error(
        "Water/Level file",
        "with Water/Method = pressures needs Model/Bedrock = continuum or rigid: "
        "the load of the water on a bedrock of blocks cannot change; set submerged");
    if (around.water_method == WaterMethod::paper)
      return;
    if (!table.is_set("Water/Level") && !around.has_water())
      throw table.error("Water/Method",
                        "needs the elevation of the water in Water/Level, Water/Level file or "
                        "Water/Line file");
    for (const std::string &name : scene.mass_materials())
      if (scene.blocks.enabled && scene.material(name, "Blocks/Material").weight_density >= 0.)
        throw table.error("Materials/" + name + "/Weight density",
                          "is for Water/Method = paper; submerged and pressures take the weight "
                          "from Density and the water");
  }


  void declare(ParameterTable &table, HeterogeneityParameters &heterogeneity)
  {
    ParameterSection section(table, {"Heterogeneity"});
    section.number_or("Modulus shape",
                      {"none", heterogeneity.modulus_shape},
                      "",
                      ParameterRange::above(0.),
                      "Shape m of Weibull's distribution of the blocks' Young modulus, mean as the "
                      "material says; 2 scatters much, 20 little, none is uniform.");
    section.number_or("Strength shape",
                      {"none", heterogeneity.strength_shape},
                      "",
                      ParameterRange::above(0.),
                      "The same of cohesion and tensile strength of joints, both times one factor "
                      "per joint.");
    section.integer("Seed",
                    heterogeneity.seed,
                    {0, 2147483647},
                    "Another seed is another sample; a block has its factor by its place.");
  }
} // namespace hybrid::scene
