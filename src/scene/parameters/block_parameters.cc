// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    void declare_materials(ParameterSection &section, BlockParameters &blocks)
    {
      const std::string allowed = "a material's name, or empty";
      const std::string by_region =
        "a material's name, or 'region: material; region: material; ...'";
      section.value(
        "Material",
        by_region,
        [&blocks](const std::string &text) { blocks.material = RegionMaterials::parse(text); },
        "Blocks, and joints between them, above the water level: one name for all regions, or one "
        "per region of the mesh (sliding_mass, sliding_mass_<suffix>). Where two materials meet, "
        "joints and contacts have the smaller of each strength.");
      section.value(
        "Saturated material",
        by_region + ", or empty",
        [&blocks](const std::string &text) {
          blocks.saturated_material = RegionMaterials::parse(text);
        },
        "The same below the water level; where it is empty: as Material.");
      section.text(
        "Belt material",
        blocks.belt_material,
        allowed,
        "Bonded joints on the sliding surface; empty: unbonded frictional contact of Material. Its "
        "residual strength is the peak unless it is set; its cohesion belongs to the area that was "
        "bonded and is gone where that has opened. Elsewhere contacts with the ground have friction "
        "only, the smaller one of Material and the ground's material (if it has a Friction angle).");
      section.text("Saturated belt material",
                   blocks.saturated_belt_material,
                   allowed,
                   "The same below the water level; empty: as Belt material.");
    }

    void declare_joints(ParameterSection &section, BlockParameters &blocks)
    {
      section.value(
        "Joint materials",
        "'line: material; line: material; ...', a material's name, or empty",
        [&blocks](const std::string &text) {
          blocks.joint_materials = RegionMaterials::parse(text);
        },
        "Strength of joints and contacts along lines joint_<suffix> within the mass, weaker or "
        "stronger than its blocks: one name for all such lines, or one per line. Without cohesion "
        "and tensile strength it is a parting that friction holds. On other edges, and on lines "
        "without one, Material's.");
      section.value(
        "Saturated joint materials",
        "'line: material; line: material; ...', a material's name, or empty",
        [&blocks](const std::string &text) {
          blocks.saturated_joint_materials = RegionMaterials::parse(text);
        },
        "The same below the water level; where it is empty: as Joint materials.");
    }

    void declare_velocities(ParameterSection &section, BlockParameters &blocks)
    {
      section.value(
        "Initial velocities",
        "'name: x min, x max, y min, y max, horizontal, vertical, spin; ...' [m, m/s, rad/s]",
        [&blocks](const std::string &text) {
          for (const auto &[name, row] : parse_rows(text, 7))
            blocks.initial_velocities.push_back(
              {name, Vec2(row[0], row[2]), Vec2(row[1], row[3]), Vec2(row[4], row[5]), row[6]});
        },
        "Rigid motions (to the right, up and anticlockwise) with which the dynamic stage begins, each "
        "of all blocks with their centroid in the box about their common centre of mass; other "
        "blocks begin at rest.");
    }

    void check_velocities(const BlockParameters &blocks, const ParameterTable &table)
    {
      const std::string path = "Blocks/Initial velocities";
      if (!blocks.initial_velocities.empty() && !blocks.enabled)
        throw table.error(path, "they are those of blocks, and Model/Blocks = none has none");
      constexpr double largest = 1e3; // [m/s] and [rad/s]: falling rock has less than 100 m/s
      for (const InitialVelocity &given : blocks.initial_velocities)
        {
          if (!(given.lower.x() <= given.upper.x() && given.lower.y() <= given.upper.y()))
            throw table.error(path,
                              "the box of '" + given.name +
                                "' is empty; it must be x min <= x max, y min <= y max");
          if (!(given.velocity.cwiseAbs().maxCoeff() <= largest && std::abs(given.spin) <= largest))
            throw table.error(path,
                              "the velocity and the spin of '" + given.name + "' must be at most " +
                                number_text(largest) + " [m/s] and [rad/s]");
        }
    }

    void declare_iteration(ParameterSection &section, BlockParameters &blocks)
    {
      section.integer("Maximum iterations",
                      blocks.maximum_iterations,
                      {1, 10000},
                      "Open-close iterations before the step is cut.");
      section.number("Tolerance",
                     blocks.tolerance,
                     "",
                     ParameterRange::open(0., 1.),
                     "Relative force residual at which the open-close iteration has converged.");
    }
  } // namespace

  void declare(ParameterTable &table, BlockParameters &blocks)
  {
    ParameterSection section(table, {"Blocks"});
    declare_materials(section, blocks);
    declare_joints(section, blocks);
    section.toggle(
      "Yielding",
      blocks.yielding,
      "Blocks of the mass yield inside at the Mohr-Coulomb strength (Cohesion, Friction "
      "angle, Dilation angle) of their material, so that the mass may shear where it has "
      "no edges; without softening.");
    section.number(
      "Penalty ratio",
      blocks.penalty_ratio,
      "",
      {1., 1e9, false, true},
      "alpha of the normal stiffness alpha E / h of joints and contacts; what it changes: doc/accuracy-vs-time.md.");
    section.number("Shear ratio",
                   blocks.shear_ratio,
                   "",
                   {0., 1., false, true},
                   "Shear stiffness over normal stiffness of joints and contacts.");
    section.number("Fracture energy",
                   blocks.fracture_energy,
                   "N/m",
                   ParameterRange::at_least(0.),
                   "Energy G_f per area that opening a joint takes; 0 is brittle.");
    section.number(
      "Softening slip",
      blocks.softening_slip,
      "m",
      ParameterRange::at_least(0.),
      "Slip over which the shear strength of a joint falls to its residual; clays need 0.1 to "
      "0.5 m (Skempton 1985), rock joints millimetres.");
    section.number(
      "Damping ratio",
      blocks.damping_ratio,
      "",
      {0., 1., true, false},
      "Stiffness-proportional damping of blocks and joints, as a fraction of critical.");
    section.number("Damping frequency",
                   blocks.damping_frequency,
                   "Hz",
                   ParameterRange::above(0.),
                   "Frequency at which the damping ratio holds.");
    section.number(
      "Loose damping",
      blocks.loose_damping,
      "",
      {0., 10., true, true},
      "Damping of the shape of a block that no joint holds, as a fraction of critical "
      "at its own shear vibration; without it such blocks ring and flutter as they "
      "slide. It sets how they bounce, too: 1 leaves 0.2 to 0.3 of the speed of a hit, 0.1 "
      "about 0.65 (doc/limits.md).");
    section.toggle(
      "Stiffness correction",
      blocks.stiffness_correction,
      "Take the compliance of the joints off that of the blocks, so that waves keep their speed.");
    declare_velocities(section, blocks);
    declare_iteration(section, blocks);
  }

  void check_blocks(const SceneParameters &scene, const ParameterTable &table)
  {
    const BlockParameters &blocks = scene.blocks;
    check_velocities(blocks, table);
    if (!blocks.enabled)
      return;
    if (blocks.material.empty())
      throw table.error("Blocks/Material", "blocks need a material, or set Model/Blocks = none");

    const std::pair<const char *, std::vector<std::string>> uses[] = {
      {"Blocks/Material", blocks.material.names()},
      {"Blocks/Saturated material", blocks.saturated_material.names()},
      {"Blocks/Belt material", {blocks.belt_material}},
      {"Blocks/Saturated belt material", {blocks.saturated_belt_material}},
      {"Blocks/Joint materials", blocks.joint_materials.names()},
      {"Blocks/Saturated joint materials", blocks.saturated_joint_materials.names()}};
    for (const auto &[path, names] : uses)
      for (const std::string &name : names)
        if (!name.empty())
          check_material_name(scene, name, path, table);
    if (blocks.belt_material.empty() && !blocks.saturated_belt_material.empty())
      throw table.error("Blocks/Saturated belt material",
                        "needs Blocks/Belt material for the part above water");
    if (blocks.joint_materials.empty() && !blocks.saturated_joint_materials.empty())
      throw table.error("Blocks/Saturated joint materials",
                        "needs Blocks/Joint materials for the part above water");
  }
} // namespace hybrid::scene
