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



  double EnvironmentParameters::highest_water() const
  {
    double highest = water_level;
    for (const LinearTable *table : {&water_tables.line, &water_tables.level})
      if (!table->empty())
        highest = std::max(highest, table->highest());
    return highest;
  }



  bool SceneParameters::has_wet_planes() const
  {
    return bedding.slips && !bedding.names.empty() && environment.has_water() &&
           environment.water_method != WaterMethod::paper &&
           (blocks.enabled ? environment.static_stage != StaticStage::none : has_bedrock_blocks());
  }



  const Material &SceneParameters::bedrock_material(const std::string &region) const
  {
    auto found = continuum.region_material.find(region);
    if (found == continuum.region_material.end())
      found = continuum.region_material.find("*");
    if (found == continuum.region_material.end())
      throw InputError("Continuum/Materials: the region '" + region +
                       "' of the mesh has no material");
    return material(found->second, "Continuum/Materials");
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
