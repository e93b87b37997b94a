// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace hybrid::scene
{
  /// Names of materials by region of the mesh.
  class RegionMaterials
  {
  public:
    /// None.
    RegionMaterials() = default;

    /// One for all regions; empty: none.
    RegionMaterials(const std::string &name);
    RegionMaterials(const char *name);

    /// "rock" for all regions, or "region: material; region: material; ...", where the region "*"
    /// is every one without its own. @throws InputError where a pair has another form, or a region
    /// stands twice.
    static RegionMaterials parse(const std::string &text);

    bool empty() const
    {
      return by_region.empty();
    }

    /// Empty if the region has none.
    const std::string &of(const std::string &region) const;

    /// The region's own, to be set.
    std::string &operator[](const std::string &region)
    {
      return by_region[region];
    }

    /// Each name once, by name.
    std::vector<std::string> names() const;

    /// Regions that have one of their own, by name; without "*".
    std::vector<std::string> regions() const;

    /// "rock", or "debris, rock".
    std::string in_words() const;

  private:
    std::map<std::string, std::string> by_region;
  };
} // namespace hybrid::scene
