// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/settings_without_effect.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/option_registry.h>
#include <hybrid/scene/parameters/parameter_values.h>

#include <algorithm>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    /// A motion that nothing lets in, a record that nothing reads.
    void look_at_motion(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      const MotionParameters &motion   = scene.motion;
      const bool              can_stop = scene.bedrock.has_cells();
      if (motion.type != "none" && can_stop && !scene.continuum.base.takes_motion)
        warnings.push_back("Motion/Type = " + motion.type + " has no effect, as Continuum/Base = " +
                           scene.continuum.base.name + " does not move; set it to " +
                           names_in_words(base_boundaries(), [](const BaseBoundary &base) {
                             return base.takes_motion;
                           }));
      const MotionSource *source = find_motion_source(motion.type, motion_sources());
      if (!motion.file.empty() && motion.type != "none" && source != nullptr &&
          !source->reads_record)
        warnings.push_back("Motion/File = " + motion.file + " is not read, as Motion/Type = " +
                           motion.type + "; set it to text or at2");
      const EarthquakeSource &given = motion.earthquake, usual;
      if (motion.type != "none" && motion.type != "stochastic" &&
          (given.magnitude != usual.magnitude || given.distance != usual.distance))
        warnings.push_back("Motion/Magnitude and Distance have no effect, as Motion/Type = " +
                           motion.type + "; set it to stochastic");
    }


    void look_at_mesh(const MeshParameters &given, std::vector<std::string> &warnings)
    {
      if (given.left_out.empty())
        return;
      std::string names;
      for (const std::string &number : given.left_out)
        names += (names.empty() ? "" : "; ") + number;
      warnings.push_back(
        "Mesh/Numbers of the command line takes the place of the scene's: " + names +
        " of the scene has no effect, the mesh has its own number; name it again to keep it");
    }


    void look_at_planes(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      const EnvironmentParameters &around = scene.environment;
      const bool slips = scene.bedding.slips && !scene.bedding.names.empty() && around.has_water();
      if (slips && !scene.has_wet_planes())
        warnings.push_back(
          "bedding planes are dry, though there is water: their pore pressure is that "
          "of a static stage with blocks and Water/Method = pressures or submerged");
      else if (slips && !around.water_tables.level_file.empty())
        warnings.push_back(
          "Water/Level file does not change the pore pressure in bedding planes: they "
          "keep that of 0 s");
      if (scene.bedding.names.empty() || scene.bedrock.has_cells())
        return;
      warnings.push_back("Bedding planes/Names = " + scene.bedding.names.front() +
                         (scene.bedding.names.size() > 1 ? ", ..." : "") +
                         " has no effect, as the bedrock is rigid (Model/Bedrock)");
    }


    /// A ratio of stresses at rest for a material that neither blocks nor bedrock are made of.
    void look_at_initial_stress(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      const std::string &given = scene.environment.initial_stress;
      if (given.find(':') == std::string::npos)
        return;
      std::vector<std::string>       bodies     = scene.mass_materials();
      const std::vector<std::string> of_bedrock = scene.continuum.region_material.names();
      bodies.insert(bodies.end(), of_bedrock.begin(), of_bedrock.end());
      for (const auto &[name, value] : parse_pairs(given, ':'))
        if (std::count(bodies.begin(), bodies.end(), name) == 0)
          warnings.push_back("Gravity/Initial stress of '" + name +
                             "' has no effect, as neither blocks nor bedrock are made of it");
    }


    /// Strength of bonds, where there are none: contacts have what is left after slip.
    void look_at_loose_blocks(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      if (!scene.blocks.enabled || scene.blocks.bonded)
        return;
      std::vector<std::string> names = scene.mass_materials();
      for (const RegionMaterials *of_joints :
           {&scene.blocks.joint_materials, &scene.blocks.saturated_joint_materials})
        for (const std::string &name : of_joints->names())
          if (std::count(names.begin(), names.end(), name) == 0)
            names.push_back(name);
      std::string        bonds;
      std::ostringstream friction;
      for (const std::string &name : names)
        {
          const auto found = scene.materials.find(name);
          if (found == scene.materials.end())
            continue;
          const Material &m = found->second;
          if (m.cohesion > 0. || m.tensile_strength > 0.)
            bonds += (bonds.empty() ? "'" : ", '") + name + "'";
          if (m.residual_friction_angle >= 0. && m.residual_friction_angle < m.friction_angle)
            friction << (friction.tellp() > 0 ? ", " : "") << m.residual_friction_angle
                     << " degrees of '" << name << "'";
        }
      if (!bonds.empty())
        warnings.push_back("Cohesion and Tensile strength of " + bonds +
                           " do not act between blocks, as Model/Blocks = loose has no bonds");
      if (friction.tellp() > 0)
        warnings.push_back("contacts slide at the Residual friction angle from the start, as "
                           "Model/Blocks = loose has no bonds: " +
                           friction.str());
    }


    void look_at_surface(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      if (scene.continuum.surface_form == SurfaceForm::automatic ||
          (scene.has_continuum() && scene.blocks.enabled))
        return;
      warnings.push_back(std::string("Continuum/Surface stiffness has no effect, as ") +
                         (scene.has_continuum() ? "there are no blocks (Model/Blocks)"
                                                : "the bedrock is no continuum (Model/Bedrock)"));
    }
  } // namespace


  std::vector<std::string> settings_without_effect(const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    look_at_motion(scene, warnings);
    look_at_mesh(scene.mesh, warnings);
    look_at_planes(scene, warnings);
    look_at_surface(scene, warnings);
    look_at_initial_stress(scene, warnings);
    look_at_loose_blocks(scene, warnings);
    return warnings;
  }
} // namespace hybrid::scene
