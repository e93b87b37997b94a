// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <algorithm>

namespace hybrid::scene
{
  double EnvironmentParameters::water_at(const double x) const
  {
    return water_tables.line.empty() ? water_level : std::max(water_level, water_tables.line(x));
  }



  bool SceneParameters::has_wet_planes() const
  {
    return bedding.slips && !bedding.names.empty() && environment.has_water() &&
           environment.water_method != WaterMethod::paper &&
           (blocks.enabled ? environment.static_stage != StaticStage::none : has_bedrock_blocks());
  }



  const Material &SceneParameters::bedrock_material(const std::string &region) const
  {
    const std::string &name = continuum.region_material.of(region);
    if (name.empty())
      throw InputError("Continuum/Materials: the region '" + region +
                       "' of the mesh has no material");
    return material(name, "Continuum/Materials");
  }



  const Material &SceneParameters::mass_material(const std::string &region,
                                                 const bool         saturated) const
  {
    const std::string &wet = blocks.saturated_material.of(region);
    if (saturated && !wet.empty())
      return material(wet, "Blocks/Saturated material");
    const std::string &dry = blocks.material.of(region);
    if (dry.empty())
      throw InputError("Blocks/Material: the region '" + region + "' of the mesh has no material");
    return material(dry, "Blocks/Material");
  }



  std::vector<std::string> SceneParameters::mass_materials() const
  {
    std::vector<std::string> names = blocks.material.names();
    if (environment.has_water())
      for (const std::string &name : blocks.saturated_material.names())
        if (std::count(names.begin(), names.end(), name) == 0)
          names.push_back(name);
    return names;
  }



  const Material &SceneParameters::belt_material(const bool saturated) const
  {
    const bool is_wet = saturated && !blocks.saturated_belt_material.empty();
    return material(is_wet ? blocks.saturated_belt_material : blocks.belt_material,
                    is_wet ? "Blocks/Saturated belt material" : "Blocks/Belt material");
  }



  const Material *SceneParameters::joint_material(const std::string &line,
                                                  const bool         saturated) const
  {
    const std::string &wet = blocks.saturated_joint_materials.of(line);
    if (saturated && !wet.empty())
      return &material(wet, "Blocks/Saturated joint materials");
    const std::string &dry = blocks.joint_materials.of(line);
    return dry.empty() ? nullptr : &material(dry, "Blocks/Joint materials");
  }



  std::vector<std::string> SceneParameters::bond_materials() const
  {
    std::vector<std::string> names;
    const auto               add = [&names](const std::string &name) {
      if (!name.empty() && std::count(names.begin(), names.end(), name) == 0)
        names.push_back(name);
    };
    add(blocks.belt_material);
    add(blocks.saturated_belt_material);
    for (const RegionMaterials *of_joints :
         {&blocks.joint_materials, &blocks.saturated_joint_materials})
      for (const std::string &name : of_joints->names())
        add(name);
    return names;
  }



  const Material &SceneParameters::material(const std::string &name, const std::string &where) const
  {
    const auto found = materials.find(name);
    if (found != materials.end())
      return found->second;

    std::vector<std::string> names;
    std::string              list;
    for (const auto &entry : materials)
      {
        names.push_back(entry.first);
        list += (list.empty() ? "" : ", ") + entry.first;
      }
    throw InputError(where + " = '" + name + "': no such material" + suggestion(name, names) +
                     "; Materials/Names lists " + (list.empty() ? "nothing" : list));
  }
} // namespace hybrid::scene
