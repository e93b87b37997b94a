// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/moving_blocks.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/output/advice.h>
#include <hybrid/scene/mesh/stable_step.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace hybrid::output
{
  namespace
  {
    constexpr double steps_per_period   = 20.;
    constexpr double compliance_share   = 0.2;  ///< of the mass that joints may have [-]
    constexpr double round_off          = 1e-9; ///< what is recommended does [-]
    constexpr double range_of_penalties = 200.;


    std::string number(const double value)
    {
      std::ostringstream text;
      text.precision(value >= 1000. && value < 1e6 ? 6 : 3);
      text << value;
      return text.str();
    }


    /// The stiffest plane bulk modulus over Young's modulus of the blocks' materials [-].
    double relative_bulk_modulus(const scene::SceneParameters &scene)
    {
      double largest = 0.;
      for (const std::string &name : scene.mass_materials())
        {
          const double nu = scene.material(name, "Blocks/Material").poisson_ratio;
          largest         = std::max(largest, 0.5 / ((1. + nu) * (1. - 2. * nu)));
        }
      return largest;
    }


    /// True if any joint of the mass or its belt has the tensile strength of @p m.
    bool bonds_with(const dda::Model &model, const Material &m)
    {
      return std::any_of(model.joints.begin(), model.joints.end(), [&m](const dda::Joint &joint) {
        const double strength = joint.law.tensile_strength();
        return !joint.within_bedrock() &&
               std::abs(strength - m.tensile_strength * joint.strength_factor) <=
                 round_off * strength;
      });
    }
  } // namespace


  double rounded_down(const double value)
  {
    if (!(value > 0.) || !std::isfinite(value))
      return value;
    // a power of ten that is exact: dividing by 100 gives 0.01, multiplying by 0.01 does not
    const int    digits = 1 - static_cast<int>(std::floor(std::log10(value)));
    const double power  = std::pow(10., std::abs(digits));
    const double scaled = std::floor(digits >= 0 ? value * power : value / power);
    return digits >= 0 ? scaled / power : scaled * power;
  }


  std::string mesh_warning(const Resolution &r, const double wanted)
  {
    if (!(wanted > (1. + round_off) * r.resolved))
      return "";
    const char  *pieces = r.part == ModelPart::continuum ? "cells" : "blocks";
    const double size   = r.slowest_s_wave / (r.points * wanted);
    return name(r.part) + " resolves " + number(r.resolved) +
           " Hz at ten points per wave length, the motion has energy up to " + number(wanted) +
           " Hz; " + pieces + " of at most " + number(rounded_down(size)) + " m would do";
  }


  std::string parts_warning(const int parts)
  {
    if (parts <= scene::parts_of_an_implicit_step)
      return "";
    return "an explicit step takes " + std::to_string(parts) + " stable parts, more than the " +
           std::to_string(scene::parts_of_an_implicit_step) +
           " that cost as much as an implicit step; set Continuum/Time integrator = automatic, or look "
           "for the smallest cell, and for Continuum/Rayleigh stiffness, which shortens parts";
  }


  std::string step_warning(const double time_step, const double highest_frequency)
  {
    if (!(highest_frequency > 0. &&
          time_step * steps_per_period * highest_frequency > 1. + round_off))
      return "";
    return "the time step " + number(time_step) + " s has fewer than 20 points per period of " +
           number(highest_frequency) + " Hz; " +
           number(rounded_down(1. / (steps_per_period * highest_frequency))) + " s would do";
  }


  std::string wave_warning(const double fraction, const Vec2 &where)
  {
    if (fraction < 0.01)
      return "";
    return "the initial wave is on the boundary at t = 0 already, with " + number(100. * fraction) +
           " % of its amplitude at (" + number(where.x()) + ", " + number(where.y()) +
           ") m: there it does not begin as a wave that arrives; a centre farther away, or a smaller "
           "Length or Width of the packet, would do";
  }


  std::string speed_warning(const dda::Model &model, const double time_step)
  {
    if (model.moving_blocks.empty())
      return "";
    dda::DdaState start = dda::initial_state(model);
    dda::set_in_motion(model, start);
    double fastest = 0.; // [1/s]
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const dda::Vec6 &v = start.blocks[b].velocity;
        fastest = std::max(fastest, v.head<2>().norm() / model.blocks[b].size + std::abs(v[2]));
      }
    const double allowed = model.iteration.maximum_displacement_ratio;
    if (fastest * time_step <= allowed)
      return "";
    return "Blocks/Initial velocities: a block moves by " + number(fastest * time_step) +
           " of its size in a step, allowed is " + number(allowed) +
           " (Time/Maximum displacement ratio): steps are cut; " +
           number(rounded_down(allowed / fastest)) + " s would do";
  }


  std::string penalty_warning(const scene::SceneParameters &scene)
  {
    if (!scene.blocks.enabled)
      return "";
    const double alpha    = scene.blocks.penalty_ratio;
    const double largest  = rounded_down(range_of_penalties / compliance_share *
                                        std::max(1., 2. * relative_bulk_modulus(scene)));
    const double smallest = largest / range_of_penalties;
    if (alpha >= smallest && alpha <= largest)
      return "";
    return "the penalty ratio " + number(alpha) +
           (alpha < smallest
              ? " makes contacts and joints so soft that they take part in every deformation"
              : " makes contacts and joints so stiff that they cost iterations and cut steps") +
           "; " + number(smallest) + " to " + number(largest) + " would do";
  }


  std::string fracture_warning(const scene::SceneParameters &scene, const dda::Model &model)
  {
    const scene::BlockParameters &blocks = scene.blocks;
    if (!blocks.enabled || !blocks.bonded || !(blocks.fracture_energy > 0.))
      return "";
    double largest = 0.; // [m]
    for (int b = 0; b < model.n_mass(); ++b)
      largest = std::max(largest, model.blocks[b].size);
    struct Unresolved
    {
      double      resolved, energy; ///< size [m]; stored where a joint breaks [J/m2]
      std::string name;
    };
    std::vector<Unresolved>        found;
    const std::vector<std::string> of_mass = scene.mass_materials();
    double                         softest = std::numeric_limits<double>::infinity(); // [Pa]
    for (const std::string &name : blocks.material.names())
      softest = std::min(softest, scene.material(name, "Blocks/Material").young_modulus);
    std::vector<std::string> names = of_mass, of_bonds = scene.bond_materials();
    names.insert(names.end(), of_bonds.begin(), of_bonds.end());
    for (const std::string &name : names)
      {
        const auto is_this = [&](const Unresolved &other) { return other.name == name; };
        if (std::any_of(found.begin(), found.end(), is_this) ||
            !bonds_with(model, scene.material(name, "Blocks/Material")))
          continue;
        const bool   is_bond  = std::count(of_mass.begin(), of_mass.end(), name) == 0;
        const double strength = scene.material(name, "Blocks/Material").tensile_strength;
        const double e = is_bond ? softest : scene.material(name, "Blocks/Material").young_modulus;
        const double size = e * blocks.fracture_energy / (strength * strength);
        if (strength > 0. && strength <= 0.05 * e && largest > (1. + round_off) * size)
          found.push_back({size, 0.5 * strength * strength * largest / e, name});
      }
    if (found.empty())
      return "";
    std::stable_sort(found.begin(), found.end(), [](const Unresolved &a, const Unresolved &b) {
      return a.resolved < b.resolved;
    });
    const Unresolved &worst = found.front();
    std::string text = "tensile fracture of '" + worst.name + "' is not resolved: blocks of " +
                       number(largest) + " m store " + number(worst.energy) +
                       " J/m2 when a joint breaks, Blocks/Fracture energy is " +
                       number(blocks.fracture_energy) +
                       " J/m2, so that it is effectively brittle; blocks of at most " +
                       number(rounded_down(worst.resolved)) + " m (E G_f / F_t^2) would resolve it";
    for (std::size_t k = 1; k < found.size(); ++k)
      text += "; nor is that of '" + found[k].name + "' (" + number(found[k].energy) +
              " J/m2, at most " + number(rounded_down(found[k].resolved)) + " m)";
    return text;
  }


  std::string belt_warning(const scene::SceneParameters &scene, const dda::Model &model)
  {
    if (scene.blocks.belt_material.empty() || model.n_mass() == 0 ||
        std::any_of(model.joints.begin(), model.joints.end(), [](const dda::Joint &joint) {
          return joint.kind == dda::JointKind::belt;
        }))
      return "";
    return "Blocks/Belt material = " + scene.blocks.belt_material +
           " bonds nothing, as no block shares an edge with the sliding surface: its cohesion, tensile "
           "strength and friction rate do not act, and blocks touch the ground by friction alone. Blocks of Mesh/Polygons "
           "file have nodes of their own; to bond them, mesh blocks and surface together in Mesh/File";
  }


  std::string drag_warning(const scene::SceneParameters &scene)
  {
    const double k01 = scene.time.dynamic_coefficient;
    if (!(k01 < 1.) || scene.motion.type == "none" || !scene.has_blocks())
      return "";
    return "Time/Dynamic coefficient = " + number(k01) +
           " brakes absolute velocities while the ground moves: a drag of " +
           number((1. - k01) / scene.time.time_step) +
           " 1/s against the frame at rest, which makes peaks and amplifications of the mass wrong; "
           "set it to 1 and use Blocks/Damping ratio";
  }


  std::string threads_warning(const int threads, const int processors)
  {
    if (processors < 1 || threads <= processors)
      return "";
    return "Parallel/Threads = " + std::to_string(threads) + " is more than the " +
           std::to_string(processors) + (processors == 1 ? " processor" : " processors") +
           " of this machine, which makes the run slower";
  }


  std::string processes_warning(const int processes, const int threads, const int processors)
  {
    if (processors < 1 || processes < 2 || processes * threads <= processors)
      return "";
    return std::to_string(processes) + " processes" +
           (threads > 1 ? " of " + std::to_string(threads) + " threads" : "") +
           " on a machine of " + std::to_string(processors) +
           (processors == 1 ? " processor" : " processors") +
           " are slow: one that waits for another takes a whole processor; start fewer";
  }


  std::string pictures_warning(const scene::OutputParameters &output,
                               const scene::TimeParameters   &time)
  {
    constexpr double max_count = 3000.;
    if (!(output.picture_interval > 0.))
      return "";
    const double count = time.end_time / std::max(output.picture_interval, time.time_step);
    if (!(count > max_count))
      return "";
    return "Output/Picture interval = " + number(output.picture_interval) + " s makes " +
           number(std::floor(count)) + " pictures of each part; " +
           number(rounded_down(time.end_time / 500.)) + " s makes about 500";
  }
} // namespace hybrid::output
