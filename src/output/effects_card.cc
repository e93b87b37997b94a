// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/card_line.h>
#include <hybrid/output/effects_card.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/resolution.h>
#include <hybrid/scene/maxwell_body.h>
#include <hybrid/scene/motion/motion_measures.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hybrid::output
{
  namespace
  {
    std::string shape_in_words(const double shape)
    {
      return shape > 0. ? formatted("%g", shape) : "none";
    }



    std::string state(const bool on)
    {
      return on ? "on " : "off";
    }



    std::string
    describe_maxwell(const char *what, const double ratio, const scene::MaxwellParameters &given)
    {
      const FrequencyBand band{given.lowest, given.highest};
      const double error = ratio_error(maxwell_body(ratio, band, given.branches), ratio, band);
      return card_line(
        "  %-18s on   ratio %g (Q %.3g) from %g to %g Hz, within %.2g %%; speeds hold at %.3g Hz",
        what,
        ratio,
        0.5 / ratio,
        given.lowest,
        given.highest,
        100. * error,
        std::sqrt(given.lowest * given.highest));
    }



    void describe_ground(const scene::SceneParameters &scene, std::string &text)
    {
      const bool  continuum = scene.has_continuum();
      const char *base      = scene.continuum.base.name.c_str();
      if (scene.continuum.base.is_compliant && !scene.has_compliant_base())
        base = "rigid"; // layers let no wave out: the lowest moves as prescribed
      text += card_line("  continuum          %s%s%s",
                        state(continuum).c_str(),
                        continuum ? "  base " : "",
                        continuum ? base : "");
      if (scene.has_bedrock_blocks())
        text +=
          card_line("  bedrock blocks     on   %s, base %s", scene.bedrock.name.c_str(), base);
      const bool has_sides = scene.bedrock.has_cells();
      if (has_sides)
        text += card_line("  sides              on   %s", scene.continuum.sides.words.c_str());
      if (continuum)
        text += card_line("  boundary springs   %s  alpha_n %g, alpha_t %g",
                          state(scene.continuum.boundary_springs).c_str(),
                          scene.continuum.normal_spring,
                          scene.continuum.tangential_spring);
      const std::size_t planes = has_sides ? scene.bedding.names.size() : 0;
      if (scene.bedrock.has_cells() && scene.maxwell.bedrock_ratio > 0.)
        text += describe_maxwell("bedrock damping", scene.maxwell.bedrock_ratio, scene.maxwell);
      text += card_line("  bedding planes     %s  %zu %s joints",
                        state(planes > 0).c_str(),
                        planes,
                        scene.bedding.slips ? "Mohr-Coulomb" : "elastic");
    }



    /// "phi 8 deg, c 0 Pa" that a belt has after slip.
    std::string residual(const Material &belt)
    {
      const double phi = belt.residual_friction_angle, c = belt.residual_cohesion;
      return formatted("phi %g deg, c %g Pa",
                       phi < 0. ? belt.friction_angle : phi,
                       c < 0. ? belt.cohesion : c);
    }



    /// Strengths of the belts, and whether slip lowers them.
    void describe_belt(const scene::SceneParameters &scene, std::string &text)
    {
      const scene::BlockParameters &blocks = scene.blocks;
      for (const std::string &name : {blocks.belt_material, blocks.saturated_belt_material})
        {
          if (name.empty())
            continue;
          const Material &belt = scene.material(name, "Blocks/Belt material");
          const bool as_peak   = belt.residual_cohesion < 0. && belt.residual_friction_angle < 0.;
          text += card_line("  belt               on   %s: phi %g deg, c %g Pa, residual %s",
                            name.c_str(),
                            belt.friction_angle,
                            belt.cohesion,
                            as_peak ? "= peak" : residual(belt).c_str());
          if (belt.has_rate_effect())
            text += card_line("    at the rate v         friction times 1 %+g ln(1 + v / %g m/s)%s",
                              belt.rate_coefficient,
                              belt.reference_rate,
                              belt.rate_coefficient < 0. ? " to first order" : "");
        }
    }



    /// Which region of the mass is of what, and the strength at which blocks yield.
    void describe_mass_materials(const scene::SceneParameters &scene, std::string &text)
    {
      std::vector<std::string> regions = scene.blocks.material.regions();
      const std::string        others  = "*";
      if (!regions.empty() && !scene.blocks.material.of(others).empty())
        regions.push_back(others);
      for (const std::string &region : regions)
        {
          const std::string &dry         = scene.blocks.material.of(region);
          const std::string &wet         = scene.mass_material(region, true).name;
          const bool         is_also_wet = scene.environment.has_water() && wet != dry;
          text += card_line("  material           on   %s: %s%s",
                            region == others ? "all other regions" : region.c_str(),
                            dry.c_str(),
                            is_also_wet ? (", below the water " + wet).c_str() : "");
        }
      if (!scene.blocks.yielding)
        return;
      for (const std::string &name : scene.mass_materials())
        {
          const Material &inside = scene.material(name, "Blocks/Material");
          text += card_line("  yielding blocks    on   %s: phi %g deg, c %g Pa, dilation %g deg",
                            name.c_str(),
                            inside.friction_angle,
                            inside.cohesion,
                            inside.dilation_angle);
        }
    }



    void describe_mass(const scene::SceneParameters &scene, std::string &text)
    {
      text += card_line("  blocks             %s", state(scene.blocks.enabled).c_str());
      if (!scene.blocks.enabled)
        return;
      text += card_line("  fracture           %s", state(scene.blocks.bonded).c_str());
      describe_belt(scene, text);
      describe_mass_materials(scene, text);
      text += card_line("  block damping      %s  ratio %g at %g Hz",
                        state(scene.blocks.damping_ratio > 0.).c_str(),
                        scene.blocks.damping_ratio,
                        scene.blocks.damping_frequency);
      if (scene.maxwell.block_ratio > 0.)
        text += describe_maxwell("  of blocks", scene.maxwell.block_ratio, scene.maxwell);
      text += card_line("  loose blocks       %s  damping %g of critical",
                        state(scene.blocks.loose_damping > 0.).c_str(),
                        scene.blocks.loose_damping);
      const scene::HeterogeneityParameters &h = scene.heterogeneity;
      if (h.modulus_shape > 0. || h.strength_shape > 0.)
        text +=
          card_line("  heterogeneity      on   Weibull shapes: modulus %s, strength %s; seed %d",
                    shape_in_words(h.modulus_shape).c_str(),
                    shape_in_words(h.strength_shape).c_str(),
                    h.seed);
    }



    void describe_water(const scene::EnvironmentParameters &around, std::string &text)
    {
      const char               *methods[] = {"paper", "submerged", "pressures"};
      const char               *method    = methods[static_cast<int>(around.water_method)];
      const scene::WaterTables &tables    = around.water_tables;
      if (!around.has_water())
        text += card_line("  water              off");
      else if (around.has_level())
        text += card_line("  water              on   level %g m, %s", around.water_level, method);
      else
        text += card_line("  water              on   %s", method);
      if (!tables.level.empty())
        text += card_line("  level of the water on   from %g to %g m, until %g s",
                          tables.level.lowest(),
                          tables.level.highest(),
                          tables.level.points.back().x());
      if (!tables.line.empty())
        text += card_line("  phreatic line      on   %zu points, from %g to %g m",
                          tables.line.points.size(),
                          tables.line.lowest(),
                          tables.line.highest());
    }



    void describe_environment(const scene::SceneParameters &scene, std::string &text)
    {
      text += card_line("  gravity            %s  %g m/s2",
                        state(scene.environment.gravity > 0.).c_str(),
                        scene.environment.gravity);
      if (scene.environment.has_initial_stress())
        text += card_line("  initial stress     on   horizontal over vertical: %s",
                          scene.environment.initial_stress.c_str());
      if (scene.environment.is_staged())
        text += card_line("  initial stress     on   of a mass placed in %d lifts",
                          scene.environment.lifts);
      if (scene.environment.horizontal != 0.)
        text += card_line("  pseudo-static      on   %g times weight along +x",
                          scene.environment.horizontal);
      if (scene.strength_reduction != 1.)
        text += card_line("  strengths          divided by %g", scene.strength_reduction);
      describe_water(scene.environment, text);
    }



    void describe_motion(const scene::SceneParameters &scene,
                         const scene::Motion          &motion,
                         std::string                  &text)
    {
      if (motion.empty())
        {
          text += card_line("  motion             off");
          return;
        }
      const double                g = 9.80665;
      const scene::MotionMeasures found =
        scene::measure(scene.motion.outcrop ? motion : motion.scaled(0.5));
      text += card_line(
        "  motion             on   %s, %s peak %.4g m/s2 (%.3g g), %.4g s, 95 %% of its energy below %.3g Hz",
        scene.motion.type.c_str(),
        scene.motion.outcrop ? "outcrop" : "incident",
        found.peak_acceleration,
        found.peak_acceleration / g,
        motion.duration(),
        highest_frequency(motion));
      if (!scene.motion.outcrop)
        text += card_line(
          "                          as an outcrop, and of a rigid base, twice that: peak "
          "%.4g m/s2",
          2. * found.peak_acceleration);
      if (scene.motion.repetitions > 1)
        text += card_line("                          %d times, every %g s",
                          scene.motion.repetitions,
                          scene.motion.repetition_interval);
      if (found.peak_acceleration > 0.)
        text += card_line(
          "                          peak velocity %.3g m/s (%.3g cm/s per g), 5 to 95 %% of the Arias intensity in %.3g s, largest spectral acceleration %.3g m/s2 at %.2g s (5 %%)",
          found.peak_velocity,
          100. * g * found.velocity_over_acceleration(),
          found.significant_duration,
          found.spectral_peak,
          found.spectral_period);
    }



    void describe_loads(const scene::SceneParameters &scene,
                        const scene::Motion          &motion,
                        std::string                  &text)
    {
      const bool        continuum = scene.has_continuum();
      const bool        loads     = continuum && !scene.point_loads.loads.empty();
      const std::size_t n_loads   = scene.point_loads.loads.size();
      text += loads ? card_line("  point loads        on   %zu force%s, Ricker %g Hz",
                                n_loads,
                                n_loads == 1 ? "" : "s",
                                scene.point_loads.frequency)
                    : card_line("  point loads        off");
      const scene::InitialWaveParameters &wave    = scene.initial_wave;
      const char                         *waves[] = {"", "P", "SV"};
      if (continuum && wave.type != scene::WaveType::none)
        text +=
          card_line("  initial wave       on   %s from (%g, %g) m towards %g deg, %g Hz, %g m",
                    waves[static_cast<int>(wave.type)],
                    wave.centre.x(),
                    wave.centre.y(),
                    wave.direction,
                    wave.frequency,
                    wave.amplitude);
      if (!scene.blocks.initial_velocities.empty())
        text +=
          card_line("  initial velocities on   %zu bodies", scene.blocks.initial_velocities.size());
      const scene::EdgeLoadParameters &edges = scene.edge_loads;
      text += edges.tractions.empty()
                ? card_line("  edge loads         off")
                : card_line("  edge loads         on   %zu tractions, rising from %g to %g s",
                            edges.tractions.size(),
                            edges.start,
                            edges.start + edges.rise_time);
      describe_motion(scene, motion, text);
    }
  } // namespace



  std::string describe_effects(const scene::SceneParameters &scene, const scene::Motion &motion)
  {
    std::string text = "Effects\n";
    describe_ground(scene, text);
    describe_mass(scene, text);
    describe_environment(scene, text);
    describe_loads(scene, motion, text);
    return text;
  }
} // namespace hybrid::output
