// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/region_materials.h>

#include <set>

namespace hybrid::scene
{
  namespace
  {
    const char *const every_other = "*";
  }



  RegionMaterials::RegionMaterials(const std::string &name)
  {
    if (!name.empty())
      by_region[every_other] = name;
  }



  RegionMaterials::RegionMaterials(const char *const name)
    : RegionMaterials(std::string(name))
  {}



  RegionMaterials RegionMaterials::parse(const std::string &text)
  {
    if (text.find(':') == std::string::npos)
      return text;
    RegionMaterials materials;
    for (const auto &pair : parse_pairs(text, ':'))
      materials.by_region.insert(pair);
    return materials;
  }



  const std::string &RegionMaterials::of(const std::string &region) const
  {
    static const std::string none;
    auto                     found = by_region.find(region);
    if (found == by_region.end())
      found = by_region.find(every_other);
    return found == by_region.end() ? none : found->second;
  }



  std::vector<std::string> RegionMaterials::names() const
  {
    std::set<std::string> names;
    for (const auto &entry : by_region)
      names.insert(entry.second);
    return {names.begin(), names.end()};
  }



  std::vector<std::string> RegionMaterials::regions() const
  {
    std::vector<std::string> regions;
    for (const auto &entry : by_region)
      if (entry.first != every_other)
        regions.push_back(entry.first);
    return regions;
  }



  std::string RegionMaterials::in_words() const
  {
    std::string words;
    for (const std::string &name : names())
      words += (words.empty() ? "" : ", ") + name;
    return words;
  }
} // namespace hybrid::scene
