// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  namespace
  {
    const char *const strength_names[] = {"Friction angle", "Cohesion", "Tensile strength"};
  }

  void declare(ParameterTable &table, Material &material)
  {
    ParameterSection section(table, {"Materials", material.name});
    section.number("Density",
                   material.density,
                   "kg/m3",
                   {1e-3, 1e10, true, true},
                   "Mass per volume that has inertia.");
    section.number_or(
      "Weight density",
      {"same", material.weight_density},
      "kg/m3",
      ParameterRange::closed(0., 1e10),
      "Mass per volume that gravity acts on (buoyant below water); same: as Density.");
    section.number(
      "Young modulus", material.young_modulus, "Pa", {1., 1e15, true, true}, "Modulus E.");
    section.number("Poisson ratio",
                   material.poisson_ratio,
                   "",
                   ParameterRange::open(-1., 0.5),
                   "Ratio nu (plane strain).");
    section.number_or(
      strength_names[0],
      {"automatic", material.given_friction_angle},
      "deg",
      {0., 90., true, false},
      "Peak friction angle phi of joints; automatic: 30, and of bedrock that of what touches it.");
    section.number(strength_names[1],
                   material.cohesion,
                   "Pa",
                   ParameterRange::at_least(0.),
                   "Peak cohesion c of bonded joints.");
    section.number(strength_names[2],
                   material.tensile_strength,
                   "Pa",
                   ParameterRange::at_least(0.),
                   "Tensile strength F_t of bonded joints.");
    section.number(
      "Dilation angle",
      material.dilation_angle,
      "deg",
      {0., 90., true, false},
      "Angle psi at which blocks that yield (Blocks/Yielding) grow as they shear; joints "
      "do not dilate.");
    section.number_or(
      "Residual friction angle",
      {"same", material.residual_friction_angle},
      "deg",
      {0., 90., true, false},
      "Friction angle of a joint that has failed, and of contacts; same: as Friction angle.");
    section.number_or(
      "Residual cohesion",
      {"automatic", material.residual_cohesion},
      "Pa",
      ParameterRange::at_least(0.),
      "Cohesion of a joint that has failed in shear; automatic: none between blocks, and as Cohesion "
      "on a belt, which is an old sliding surface.");
    section.number(
      "Friction rate coefficient",
      material.rate_coefficient,
      "",
      ParameterRange::closed(-1., 1.),
      "a of a belt's friction mu (1 + a ln(1 + v/v0)) at the rate v of slip; negative: "
      "it weakens, mu / (1 - a ln(1 + v/v0)); 0: friction "
      "does not depend on the rate.");
    section.number("Friction reference rate",
                   material.reference_rate,
                   "m/s",
                   ParameterRange::above(0.),
                   "v0 of the friction rate coefficient: rate at which friction begins to change.");
  }

  void check(const Material &material, const ParameterTable &table)
  {
    const std::string path = "Materials/" + material.name + "/";
    if (material.residual_cohesion > material.cohesion)
      throw table.error(path + "Residual cohesion",
                        "must not exceed Cohesion = " + number_text(material.cohesion) + " [Pa]");
    if (material.residual_friction_angle > material.friction_angle)
      throw table.error(path + "Residual friction angle",
                        "must not exceed Friction angle = " + number_text(material.friction_angle) +
                          " [deg]");

    if (material.dilation_angle > material.friction_angle)
      throw table.error(path + "Dilation angle",
                        "must not exceed Friction angle = " + number_text(material.friction_angle) +
                          " [deg]");

    bool any_is_set = table.is_set(path + "Density") || table.is_set(path + "Young modulus");
    for (const char *name : strength_names)
      any_is_set = any_is_set || table.is_set(path + name);
    if (!any_is_set)
      throw table.error("Materials/Names",
                        "'" + material.name + "' has no values: set them in subsection " +
                          material.name + " of subsection Materials");
  }

  void check_material_name(const SceneParameters &scene,
                           const std::string     &name,
                           const std::string     &path,
                           const ParameterTable  &table)
  {
    try
      {
        scene.material(name, path);
      }
    catch (const InputError &reason)
      {
        const std::string text = reason.what();
        throw table.error(path, text.substr(text.find(": ") + 2));
      }
  }
} // namespace hybrid::scene
