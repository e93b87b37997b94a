// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/unit_check.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    // The longest landslides on land (Saidmarreh, Heart Mountain) are 15 to 50 km, their slopes
    // less than 10 km; shaking-table models are 1 m and larger.
    constexpr double largest_section  = 30e3; // [m]
    constexpr double large_section    = 5e3;  // [m]
    constexpr double small_section    = 5.;   // [m]
    constexpr double smallest_section = 0.5;  // [m]
    constexpr double large_block      = 100.; // [m]


    struct Box
    {
      Vec2 low, high; ///< [m]

      double extent() const ///< the larger side [m]
      {
        return (high - low).maxCoeff();
      }
    };


    Box box_of(const SectionMesh &mesh)
    {
      Box box{mesh.nodes[0], mesh.nodes[0]};
      for (const Vec2 &x : mesh.nodes)
        {
          box.low  = box.low.cwiseMin(x);
          box.high = box.high.cwiseMax(x);
        }
      return box;
    }


    /// "350 km", "0.3 m".
    std::string length(const double metres)
    {
      std::ostringstream text;
      text.precision(4);
      if (metres >= 1000.)
        text << metres / 1000. << " km";
      else
        text << metres << " m";
      return text.str();
    }


    std::string corners(const Box &box)
    {
      const double smallest = 1e-9 * box.extent(); // less is rounding
      const auto   rounded = [smallest](const double x) { return std::abs(x) < smallest ? 0. : x; };
      std::ostringstream text;
      text << "from (" << rounded(box.low.x()) << ", " << rounded(box.low.y()) << ") to ("
           << rounded(box.high.x()) << ", " << rounded(box.high.y()) << ") m";
      return text.str();
    }


    std::string in_unit(const double extent, const char *const unit, const double metres)
    {
      return std::string("if they are ") + unit + ", multiply them by " +
             (metres < 1. ? "0.001" : "1000") + " (" + length(extent * metres) + ")";
    }


    bool has_waves(const SceneParameters &scene)
    {
      return scene.bedrock.has_cells();
    }


    double area(const SectionMesh &mesh, const std::vector<int> &block)
    {
      double sum = 0.;
      for (std::size_t i = 1; i + 1 < block.size(); ++i)
        sum += 0.5 * cross(mesh.nodes[block[i]] - mesh.nodes[block[0]],
                           mesh.nodes[block[i + 1]] - mesh.nodes[block[0]]);
      return sum;
    }


    /// Of the blocks of the mass: the largest, if it is doubtful.
    void warn_of_blocks(const SectionMesh &mesh, std::vector<std::string> &warnings)
    {
      double                  largest = 0.;
      const std::vector<int> *found   = nullptr;
      for (const auto &block : mesh.blocks)
        if (area(mesh, block) > largest)
          {
            largest = area(mesh, block);
            found   = &block;
          }
      if (!(std::sqrt(largest) > large_block))
        return;
      const Vec2        &x = mesh.nodes[(*found)[0]];
      std::ostringstream text;
      text << "the block at (" << x.x() << ", " << x.y() << ") m is " << length(std::sqrt(largest))
           << " large, more than " << length(large_block) << "; coordinates are read as metres: "
           << in_unit(std::sqrt(largest), "millimetres", 0.001);
      warnings.push_back(text.str());
    }
    /// Half of the blocks are smaller [m].
    double typical_block(const SectionMesh &mesh)
    {
      std::vector<double> sizes;
      for (const auto &block : mesh.blocks)
        sizes.push_back(std::sqrt(std::max(area(mesh, block), 0.)));
      if (sizes.empty())
        return 0.;
      std::nth_element(sizes.begin(), sizes.begin() + sizes.size() / 2, sizes.end());
      return sizes[sizes.size() / 2];
    }


    /// Strengths of 50 to 999 Pa are nothing for blocks of a metre and more: kPa were meant.
    /// Smaller ones are doubted in every scene.
    void warn_of_strengths(const SectionMesh        &mesh,
                           const SceneParameters    &scene,
                           std::vector<std::string> &warnings)
    {
      constexpr double               lowest = 50., highest = 1000.; // [Pa]
      const double                   size = typical_block(mesh);
      std::vector<std::string>       names;
      std::vector<std::string>       all      = scene.mass_materials();
      const std::vector<std::string> of_bonds = scene.bond_materials();
      all.insert(all.end(), of_bonds.begin(), of_bonds.end());
      for (const std::string &name : all)
        if (scene.materials.count(name) > 0 && std::count(names.begin(), names.end(), name) == 0)
          names.push_back(name);
      if (!scene.blocks.enabled || size < 1. || names.empty())
        return;
      const double density = scene.materials.at(names.front()).density;
      for (const std::string &name : names)
        {
          const Material &m    = scene.materials.at(name);
          const auto      warn = [&](const char *what, const double value) {
            if (value < lowest || value >= highest)
              return;
            std::ostringstream text;
            text.precision(3);
            text << "Materials/" << name << "/" << what << " = " << value
                 << " Pa is doubtful with blocks of " << size << " m: it carries the weight of "
                 << 1000. * value / (density * 9.81) << " mm of them; if it was meant in kPa, give "
                 << std::setprecision(6) << 1000. * value;
            warnings.push_back(text.str());
          };
          warn("Cohesion", m.cohesion);
          warn("Tensile strength", m.tensile_strength);
        }
    }
  } // namespace


  void check_extent(const Vec2 &low, const Vec2 &high)
  {
    const Box    box{low, high};
    const double extent = box.extent();
    if (!(extent <= largest_section))
      throw InputError("The section " + corners(box) + " is " + length(extent) +
                       " large; at most " + length(largest_section) +
                       " are allowed; coordinates are read as metres: " +
                       in_unit(extent, "millimetres", 0.001) + ".");
  }


  void check_unit(const SectionMesh &mesh, const SceneParameters &scene)
  {
    if (mesh.nodes.empty())
      return;
    const Box    box    = box_of(mesh);
    const double extent = box.extent();
    check_extent(box.low, box.high);
    const bool is_shaken = scene.motion.type != "none";
    if ((has_waves(scene) || is_shaken) && extent < smallest_section)
      throw InputError("The section " + corners(box) + " is " + length(extent) +
                       " large; at least " + length(smallest_section) +
                       " are needed where the ground shakes; coordinates are read as metres: " +
                       in_unit(extent, "kilometres", 1000.) + ".");
  }


  std::vector<std::string> unit_warnings(const SectionMesh &mesh, const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    if (mesh.nodes.empty())
      return warnings;
    const Box    box    = box_of(mesh);
    const double extent = box.extent();
    if (extent > large_section)
      warnings.push_back(
        "the section " + corners(box) + " is " + length(extent) + " large, more than " +
        length(large_section) +
        "; coordinates are read as metres: " + in_unit(extent, "millimetres", 0.001));
    const double small = has_waves(scene) ? small_section : smallest_section;
    if (extent < small)
      warnings.push_back(
        "the section " + corners(box) + " is " + length(extent) + " large, less than " +
        length(small) +
        "; coordinates are read as metres: " + in_unit(extent, "kilometres", 1000.));
    warn_of_blocks(mesh, warnings);
    warn_of_strengths(mesh, scene, warnings);
    return warnings;
  }
} // namespace hybrid::scene
