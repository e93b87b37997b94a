// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/water_check.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    /// From left to right, and what lies highest and lowest [m].
    struct Extent
    {
      double      from = 0., to = 0.;
      const Vec2 *top = nullptr, *bottom = nullptr;
    };


    Extent extent_of(const SectionMesh &mesh)
    {
      Extent found{mesh.nodes[0].x(), mesh.nodes[0].x(), &mesh.nodes[0], &mesh.nodes[0]};
      for (const Vec2 &x : mesh.nodes)
        {
          found.from   = std::min(found.from, x.x());
          found.to     = std::max(found.to, x.x());
          found.top    = x.y() > found.top->y() ? &x : found.top;
          found.bottom = x.y() < found.bottom->y() ? &x : found.bottom;
        }
      return found;
    }


    /// The water at any time.
    class Highest
    {
    public:
      explicit Highest(const EnvironmentParameters &around)
        : line(around.water_tables.line)
        , level(around.water_tables.level.empty() ? around.water_level
                                                  : around.water_tables.level.highest())
      {}

      double at(const double x) const
      {
        return line.empty() ? level : std::max(level, line(x));
      }

      double between(const double from, const double to) const
      {
        return line.empty() ? level : std::max(level, line.highest_between(from, to));
      }

      /// Where the straight edge from a to b lies deepest below it, or least above it: the
      /// difference is linear between its ends and the points of the line.
      std::pair<Vec2, double> nearest(const Vec2 &a, const Vec2 &b) const
      {
        std::pair<Vec2, double> found{a, a.y() - at(a.x())};
        for (const Vec2 &point : line.points)
          if (const double t = (point.x() - a.x()) / (b.x() - a.x()); t > 0. && t < 1.)
            {
              const Vec2 x = a + t * (b - a);
              if (x.y() - at(x.x()) < found.second)
                found = {x, x.y() - at(x.x())};
            }
        return found;
      }

    private:
      const LinearTable &line;
      double             level; ///< [m]
    };


    /// Where a block is deepest below the water, or least above it, and its height over it [m].
    std::pair<Vec2, double> nearest_of_blocks(const SectionMesh &mesh, const Highest &water)
    {
      std::pair<Vec2, double> found{Vec2::Zero(), std::numeric_limits<double>::infinity()};
      for (const auto &block : mesh.blocks)
        for (std::size_t i = 0; i < block.size(); ++i)
          {
            const auto of_edge =
              water.nearest(mesh.nodes[block[i]], mesh.nodes[block[(i + 1) % block.size()]]);
            if (of_edge.second < found.second)
              found = of_edge;
          }
      return found;
    }


    std::ostringstream words()
    {
      std::ostringstream text;
      text.precision(8);
      return text;
    }


    /// @return whether the water does nothing.
    bool look_at_effect(const SectionMesh        &mesh,
                        const SceneParameters    &scene,
                        std::vector<std::string> &warnings)
    {
      const EnvironmentParameters &around   = scene.environment;
      const bool                   is_paper = around.water_method == WaterMethod::paper;
      const Highest                water(around);
      const Extent                 section = extent_of(mesh);
      std::ostringstream           text    = words();
      text << (around.water_tables.empty() ? "Water/Level = " : "the water (section Water), up to ")
           << water.between(section.from, section.to) << " m"
           << (around.water_tables.empty() ? "" : ",") << " has no effect, ";
      const auto nearest = nearest_of_blocks(mesh, water);
      if ((!scene.blocks.enabled && scene.has_continuum()) || mesh.blocks.empty())
        text << "as water acts on blocks and there are none";
      else if (nearest.second > 0. && !scene.has_wet_planes())
        text << (is_paper ? "as" : "until blocks sink below it:") << " the nearest block begins "
             << nearest.second << " m above it at (" << nearest.first.x() << ", "
             << nearest.first.y() << ") m";
      else if (is_paper && scene.blocks.saturated_material.empty() &&
               scene.blocks.saturated_belt_material.empty() &&
               scene.blocks.saturated_joint_materials.empty())
        text << "as with Water/Method = paper it only chooses materials: set Blocks/Saturated "
                "material, or the method to submerged or pressures";
      else
        return false;
      warnings.push_back(text.str());
      return true;
    }


    /// A phreatic line of another origin: over the section it is constant.
    void look_at_origin(const SectionMesh        &mesh,
                        const SceneParameters    &scene,
                        std::vector<std::string> &warnings)
    {
      const LinearTable &line = scene.environment.water_tables.line;
      if (line.empty() || line.lowest() == line.highest())
        return;
      const Extent section = extent_of(mesh);
      const double from = line.points.front().x(), to = line.points.back().x();
      if (from < section.to && to > section.from)
        return;
      std::ostringstream text = words();
      text << "Water/Line file: its points, x = " << from << " to " << to
           << " m, lie beside the section, x = " << section.from << " to " << section.to
           << " m, where the line stays at " << line(section.from)
           << " m; line and section need the same origin";
      warnings.push_back(text.str());
    }


    /// Water as deep above the section as the section is high, and deep: perhaps of another datum.
    void look_at_depth(const SectionMesh        &mesh,
                       const SceneParameters    &scene,
                       std::vector<std::string> &warnings)
    {
      constexpr double deep = 100.; // [m]
      const Highest    water(scene.environment);
      const Extent     section    = extent_of(mesh);
      const double     level      = water.between(section.from, section.to);
      const bool       has_tables = !scene.environment.water_tables.empty();
      const double     top        = section.top->y();
      if (!scene.blocks.enabled || !(level - top > std::max(deep, top - section.bottom->y())))
        return;
      const bool covers_all = std::all_of(mesh.nodes.begin(), mesh.nodes.end(), [&](const Vec2 &x) {
        return x.y() < water.at(x.x());
      });
      std::ostringstream text = words();
      text << (has_tables ? "the water, up to " : "Water/Level = ") << level
           << (has_tables ? " m, is " : " m is ") << level - top
           << " m above the highest point of the section at (" << section.top->x() << ", " << top
           << ") m: " << (covers_all ? "everything" : "a part of it") << " is under water";
      warnings.push_back(text.str());
    }


    Vec2 middle_of(const SectionMesh &mesh, const std::vector<int> &block)
    {
      Vec2 sum = Vec2::Zero();
      for (const int node : block)
        sum += mesh.nodes[node];
      return sum / block.size();
    }


    /// Whether pore pressure would take strength from blocks of this material, or from the belt.
    bool has_friction(const SceneParameters &scene, const Material &wet)
    {
      const bool has_belt = !scene.blocks.belt_material.empty();
      return wet.friction_angle > 0. || (has_belt && scene.belt_material(true).friction_angle > 0.);
    }


    /**
     * Weights that no buoyancy is in, where none acts. Below the water rock gains what fills its
     * pores and loses what it displaces: its buoyant weight is that above less (1 - n) rho_w, and
     * pores n are at most 0.6 of the volume. Strength without friction takes no notice of pore
     * pressure. Who sets Method = paper may mean the same weight above and below; one that is
     * larger below is total.
     */
    void look_at_weights(const SectionMesh        &mesh,
                         const SceneParameters    &scene,
                         std::vector<std::string> &warnings)
    {
      constexpr double             largest_porosity = 0.6; // [-]
      const EnvironmentParameters &around           = scene.environment;
      if (around.water_method != WaterMethod::paper || around.gravity == 0.)
        return;
      std::set<std::string> seen;
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        {
          const Vec2 middle = middle_of(mesh, mesh.blocks[b]);
          if (middle.y() >= around.water_at(middle.x()))
            continue;
          const std::string &region = mesh.block_region_names[mesh.block_region[b]];
          const Material    &dry    = scene.mass_material(region, false),
                         &wet       = scene.mass_material(region, true);
          const double above = dry.weighing_density(), below = wet.weighing_density();
          const double buoyant  = above - (1. - largest_porosity) * around.water_density;
          const bool   is_total = around.water_method_is_set ? below > above : below > buoyant;
          if (!is_total || !has_friction(scene, wet) || !seen.insert(wet.name).second)
            continue;
          std::ostringstream text = words();
          text << "Water/Method = paper lets no pore pressure act, and below the water '"
               << wet.name << "' weighs " << below
               << " kg/m3, in which no buoyancy is (a buoyant weight of '" << dry.name
               << "', which has " << above << " kg/m3 above it, is at most " << buoyant
               << "): the mass is as strong as if it were dry; set Water/Method = submerged or "
                  "pressures, which take total densities, or give the buoyant Weight density";
          warnings.push_back(text.str());
        }
    }


    /// Events of one motion that have not the same level.
    void look_at_events(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      const std::vector<Vec2> &level = scene.environment.water_tables.level.points;
      if (scene.motion.type == "none" || scene.motion.repetitions < 2)
        return;
      for (std::size_t k = 0; k + 1 < level.size(); ++k)
        if (level[k + 1].x() > scene.motion.start && level[k + 1].y() != level[k].y())
          {
            std::ostringstream text = words();
            text << "Motion/Repetitions = " << scene.motion.repetitions
                 << ": Water/Level file changes the level after Motion/Start = "
                 << scene.motion.start
                 << " s, so that events have different water: what each adds is not that of the "
                    "motion alone";
            warnings.push_back(text.str());
            return;
          }
    }
  } // namespace


  std::vector<std::string> water_warnings(const SectionMesh &mesh, const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    if (!scene.environment.has_water() || mesh.nodes.empty())
      return warnings;
    if (!look_at_effect(mesh, scene, warnings))
      look_at_weights(mesh, scene, warnings);
    look_at_origin(mesh, scene, warnings);
    look_at_depth(mesh, scene, warnings);
    look_at_events(scene, warnings);
    return warnings;
  }
} // namespace hybrid::scene
