// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/doubtful_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    constexpr double standard_gravity = 9.81; ///< [m/s2]

    struct Unit
    {
      const char *name;
      double      size; ///< in the unit of the quantity
    };

    /// What a quantity of the real world lies between.
    struct Quantity
    {
      const char       *name; ///< of the parameter
      const char       *unit; ///< that it is read in
      double            lowest;
      double            highest;
      std::vector<Unit> others; ///< that users give by mistake
    };


    std::string number(const double value)
    {
      std::ostringstream text;
      text.precision(value >= 1e4 && value < 1e6 ? 6 : 4); // 12000, not 1.2e+04
      text << value;
      return text.str();
    }


    bool is_within(const Quantity &quantity, const double value)
    {
      return value >= quantity.lowest && value <= quantity.highest;
    }


    /// "no rock has that" and the unit that would do. Zero always means that there is none.
    void look_at(const std::string        &section,
                 const Quantity           &quantity,
                 const double              value,
                 std::vector<std::string> &warnings)
    {
      if (value == 0. || is_within(quantity, value))
        return;
      const std::string unit = *quantity.unit == '\0' ? "" : " " + std::string(quantity.unit);
      std::string       text = section + "/" + quantity.name + " = " + number(value) + unit +
                         " is doubtful: expected is " +
                         (std::isinf(quantity.highest)
                            ? "at least " + number(quantity.lowest)
                            : number(quantity.lowest) + " to " + number(quantity.highest)) +
                         unit;
      for (const Unit &other : quantity.others)
        if (is_within(quantity, value * other.size))
          {
            text += "; if it was meant in " + std::string(other.name) + ", give " +
                    number(value * other.size);
            break;
          }
      warnings.push_back(text);
    }


    const double infinity = std::numeric_limits<double>::infinity();

    const Quantity density = {"Density",
                              "kg/m3",
                              300.,
                              12000.,
                              {{"t/m3", 1000.},
                               {"kN/m3", 1000. / standard_gravity},
                               {"N/m3", 1. / standard_gravity}}};

    const Quantity young_modulus = {"Young modulus",
                                    "Pa",
                                    5e4,
                                    1.1e12,
                                    {{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}}};

    const Quantity friction_angle = {"Friction angle",
                                     "deg",
                                     0.5 * M_PI,
                                     90.,
                                     {{"radians", 180. / M_PI}}};

    const Quantity cohesion = {"Cohesion", "Pa", 50., infinity, {{"kPa", 1e3}, {"MPa", 1e6}}};

    const Quantity tensile_strength = {"Tensile strength",
                                       "Pa",
                                       50.,
                                       infinity,
                                       {{"kPa", 1e3}, {"MPa", 1e6}}};

    const Quantity water_density = {"Density", "kg/m3", 500., 2500., {{"t/m3", 1000.}}};

    // Critical damping at 1 Hz: alpha_M / (2 w) and beta_K w / 2 are one.
    const Quantity rayleigh_mass      = {"Rayleigh mass", "1/s", 0., 4. * M_PI, {}};
    const Quantity rayleigh_stiffness = {"Rayleigh stiffness", "s", 0., 1. / M_PI, {}};

    const Quantity weight_density = {"Weight density",
                                     "kg/m3",
                                     50., // buoyant
                                     12000.,
                                     {{"t/m3", 1000.}, {"kN/m3", 1000. / standard_gravity}}};

    const Quantity poisson_ratio = {"Poisson ratio", "", 0., 0.5, {}};

    // Barton's rock joints have 0.1 to 100 GPa/m, soft seams less.
    const std::vector<Unit> stiffness_units = {{"GPa/m", 1e9}, {"MPa/m", 1e6}, {"kPa/m", 1e3}};
    const Quantity normal_stiffness = {"Normal stiffness", "Pa/m", 1e5, 1e14, stiffness_units};
    const Quantity shear_stiffness  = {"Shear stiffness", "Pa/m", 1e5, 1e14, stiffness_units};

    const Quantity softening_slip  = {"Softening slip", "m", 0., 5., {{"mm", 1e-3}}};
    const Quantity fracture_energy = {"Fracture energy", "N/m", 0., 1e5, {}};
    const Quantity tolerance       = {"Tolerance", "", 1e-12, 1e-4, {}}; // round-off is 1e-14
    const Quantity iterations      = {"Maximum iterations", "", 20., infinity, {}};

    const Quantity displacement_ratio = {"Maximum displacement ratio", "", 0., 0.5, {}};

    // Critical damping at 1 Hz: beta_K w / 2 is one with beta_K = ratio / (pi frequency).
    const Quantity damping_per_frequency = {"Damping ratio / Damping frequency", "s", 0., 1., {}};

    const Quantity weibull_modulus  = {"Modulus shape", "", 1., infinity, {}};
    const Quantity weibull_strength = {"Strength shape", "", 1., infinity, {}};

    // The largest record so far has 40 m/s2 (Iwate-Miyagi 2008).
    const Quantity peak = {"Peak", "m/s2", 0., 50., {{"cm/s2", 0.01}}};

    const Quantity gravity = {"Acceleration", "m/s2", 1.5, 2000., {{"g", standard_gravity}}};
  } // namespace



  namespace
  {
    void look_at_planes(const BeddingParameters &planes, std::vector<std::string> &warnings)
    {
      const std::string section = "Bedding planes";
      if (planes.names.empty())
        return;
      look_at(section, normal_stiffness, planes.normal_stiffness, warnings);
      look_at(section, shear_stiffness, planes.shear_stiffness, warnings);
      if (!planes.slips)
        return;
      look_at(section, friction_angle, planes.friction_angle, warnings);
      look_at(section, cohesion, planes.cohesion, warnings);
      look_at(section, tensile_strength, planes.tensile_strength, warnings);
    }


    void look_at_blocks(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      if (!scene.has_blocks())
        return;
      const BlockParameters &blocks = scene.blocks;
      look_at("Blocks", softening_slip, blocks.softening_slip, warnings);
      look_at("Blocks", fracture_energy, blocks.fracture_energy, warnings);
      look_at("Blocks",
              damping_per_frequency,
              blocks.damping_ratio / blocks.damping_frequency,
              warnings);
      look_at("Blocks", tolerance, blocks.tolerance, warnings);
      look_at("Blocks", iterations, blocks.maximum_iterations, warnings);
      look_at("Heterogeneity", weibull_modulus, scene.heterogeneity.modulus_shape, warnings);
      look_at("Heterogeneity", weibull_strength, scene.heterogeneity.strength_shape, warnings);
      look_at("Time", displacement_ratio, scene.time.maximum_displacement_ratio, warnings);
    }


    /// A saturated body that is lighter than the dry one: its density is buoyant, its inertia too.
    void look_at_saturated_density(const SceneParameters &scene, std::vector<std::string> &warnings)
    {
      if (!scene.blocks.enabled || !scene.environment.has_water())
        return;
      std::set<std::string>    seen;
      std::vector<std::string> regions{"*"};
      for (const RegionMaterials *given :
           {&scene.blocks.material, &scene.blocks.saturated_material})
        for (const std::string &region : given->regions())
          regions.push_back(region);
      for (const std::string &region : regions)
        {
          if (scene.blocks.material.of(region).empty())
            continue;
          const Material &dry         = scene.mass_material(region, false);
          const Material &wet         = scene.mass_material(region, true);
          const double    total       = wet.density + scene.environment.water_density;
          const bool      is_doubtful = // a total that is smaller, too, is something else
            wet.density < 0.9 * dry.density && total >= 0.9 * dry.density;
          if (!is_doubtful || !seen.insert(wet.name).second)
            continue;
          warnings.push_back(
            "Materials/" + wet.name + "/Density = " + number(wet.density) +
            " kg/m3 of the saturated body is below that of " + dry.name + ", " +
            number(dry.density) +
            " kg/m3: as a buoyant density it makes inertia too small and S waves " +
            number(100. * (std::sqrt(total / wet.density) - 1.)) +
            " % too fast; give the total density, " + number(total) +
            ", and set Water/Method = submerged or pressures");
        }
    }


    /// Samples of a record that are far apart, or all zero.
    void look_at_record(const SceneParameters    &scene,
                        const Motion             &motion,
                        std::vector<std::string> &warnings)
    {
      constexpr double coarse = 0.2; // [s]: nothing above 2.5 Hz
      if (scene.motion.type != "text" && scene.motion.type != "at2")
        return;
      if (motion.time_step() > coarse)
        warnings.push_back(scene.motion.file + ": the samples are " + number(motion.time_step()) +
                           " s apart, expected is at most " + number(coarse) +
                           " s; if the times were meant in ms, divide them by 1000");
      if (motion.peak_acceleration() == 0. && scene.motion.peak != 0.)
        warnings.push_back(scene.motion.file + ": all accelerations are zero, nothing shakes");
    }


    /// As g a weak shaking and a very strong one [m/s2].
    bool may_be_in_g(const double acceleration)
    {
      return acceleration >= 0.01 && acceleration < 1.;
    }


    std::string read_as(const double acceleration)
    {
      return "is read as " + number(acceleration) + " m/s2 (" + number(acceleration / 9.80665) +
             " g), a weak shaking";
    }


    /// A given peak below 1 m/s2 without unit: g is what most records are in.
    void look_at_unit(const std::string        &name,
                      const double              given,
                      const bool                has_unit,
                      std::vector<std::string> &warnings)
    {
      const std::string value = number(given);
      if (!has_unit && may_be_in_g(given))
        warnings.push_back("Motion/" + name + " = " + value + " " + read_as(given) +
                           ": if it was meant in g, set " + name + " = " + value + " g, else " +
                           name + " = " + value + " m/s2");
    }


    /// The same of a record's peak as it is.
    void look_at_unit_of_record(const MotionParameters   &motion,
                                const double              found,
                                std::vector<std::string> &warnings)
    {
      const bool is_file = motion.type == "text" || motion.type == "spectrum";
      if (is_file && !motion.file_unit_is_set && may_be_in_g(found))
        warnings.push_back((motion.type == "text" ? motion.file : motion.spectrum_file) +
                           ": its peak " + read_as(found) +
                           ", as Motion/Unit is not set: if the file is in g, set Unit = g, "
                           "else Unit = m/s2");
    }


    /// @param found peak of the motion [m/s2]
    void look_at_units(const MotionParameters   &motion,
                       const double              found,
                       std::vector<std::string> &warnings)
    {
      if (motion.peak >= 0.)
        look_at_unit("Peak", motion.peak, motion.peak_has_unit, warnings);
      else
        look_at_unit_of_record(motion, found, warnings);
      look_at_unit("Vertical peak", motion.vertical_peak, motion.vertical_peak_has_unit, warnings);
    }


    /// The peak as given or as recorded. Centrifuges shake as much harder as they pull.
    void look_at_peak(const SceneParameters    &scene,
                      const Motion             &motion,
                      std::vector<std::string> &warnings)
    {
      Quantity allowed = peak;
      allowed.highest *= std::max(1., scene.environment.gravity / standard_gravity);
      const double found = motion.peak_acceleration();
      if (scene.motion.type != "none")
        look_at_units(scene.motion, found, warnings);
      if (scene.motion.peak >= 0. || scene.motion.file.empty())
        look_at("Motion", allowed, found, warnings);
      else if (!is_within(allowed, found))
        warnings.push_back(scene.motion.file + ": the peak of " + number(found) +
                           " m/s2 is doubtful: expected is 0 to " + number(allowed.highest) +
                           " m/s2; if it was meant in cm/s2, set Motion/Unit = cm/s2");
    }
  } // namespace



  std::vector<std::string> doubtful_values(const SceneParameters &scene, const Motion &motion)
  {
    std::vector<std::string> warnings;
    for (const auto &[name, material] : scene.materials)
      {
        const std::string section = "Materials/" + name;
        look_at(section, density, material.density, warnings);
        if (material.weight_density > 0.)
          look_at(section, weight_density, material.weight_density, warnings);
        look_at(section, young_modulus, material.young_modulus, warnings);
        look_at(section, poisson_ratio, material.poisson_ratio, warnings);
        look_at(section, friction_angle, material.friction_angle, warnings);
        look_at(section, cohesion, material.cohesion, warnings);
        look_at(section, tensile_strength, material.tensile_strength, warnings);
      }
    look_at("Water", water_density, scene.environment.water_density, warnings);
    look_at("Continuum", rayleigh_mass, scene.continuum.rayleigh_mass, warnings);
    look_at("Continuum", rayleigh_stiffness, scene.continuum.rayleigh_stiffness, warnings);
    look_at("Gravity", gravity, scene.environment.gravity, warnings);
    look_at_planes(scene.bedding, warnings);
    look_at_blocks(scene, warnings);
    look_at_saturated_density(scene, warnings);
    look_at_peak(scene, motion, warnings);
    look_at_record(scene, motion, warnings);
    return warnings;
  }
} // namespace hybrid::scene
