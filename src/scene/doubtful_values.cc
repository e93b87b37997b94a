// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/doubtful_values.h>

#include <cmath>
#include <limits>
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
      const std::string unit = quantity.unit;
      std::string       text = section + "/" + quantity.name + " = " + number(value) + " " + unit +
                         " is doubtful: expected is " +
                         (std::isinf(quantity.highest)
                            ? "at least " + number(quantity.lowest)
                            : number(quantity.lowest) + " to " + number(quantity.highest)) +
                         " " + unit;
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

    const Quantity gravity = {"Acceleration", "m/s2", 1.5, 2000., {{"g", standard_gravity}}};
  } // namespace



  std::vector<std::string> doubtful_values(const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    for (const auto &[name, material] : scene.materials)
      {
        const std::string section = "Materials/" + name;
        look_at(section, density, material.density, warnings);
        look_at(section, young_modulus, material.young_modulus, warnings);
        look_at(section, friction_angle, material.friction_angle, warnings);
        look_at(section, cohesion, material.cohesion, warnings);
        look_at(section, tensile_strength, material.tensile_strength, warnings);
      }
    look_at("Water", water_density, scene.environment.water_density, warnings);
    look_at("Continuum", rayleigh_mass, scene.continuum.rayleigh_mass, warnings);
    look_at("Continuum", rayleigh_stiffness, scene.continuum.rayleigh_stiffness, warnings);
    look_at("Gravity", gravity, scene.environment.gravity, warnings);
    return warnings;
  }
} // namespace hybrid::scene
