// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/advice.h>
#include <hybrid/output/scene_card.h>
#include <hybrid/scene/maxwell_body.h>
#include <hybrid/scene/motion/motion_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <thread>

namespace hybrid::output
{
  namespace
  {
    /// printf into a string.
    std::string line(const char *format, ...)
    {
      char    buffer[512];
      va_list arguments;
      va_start(arguments, format);
      std::vsnprintf(buffer, sizeof(buffer), format, arguments);
      va_end(arguments);
      return std::string(buffer) + "\n";
    }



    std::string shape_in_words(const double shape)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%g", shape);
      return shape > 0. ? text : "none";
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
      return line(
        "  %-18s on   ratio %g (Q %.3g) from %g to %g Hz, within %.2g %%; speeds hold at %.3g Hz",
        what,
        ratio,
        0.5 / ratio,
        given.lowest,
        given.highest,
        100. * error,
        std::sqrt(given.lowest * given.highest));
    }



    std::string stiffness_of_surface(const continuum::Continuum &bedrock)
    {
      if (!bedrock.resolution().surface_is_banded)
        return "";
      return bedrock.is_iterated()
               ? " (stiffness banded; finding it takes as long as a hundred steps or more)"
               : " (stiffness banded)";
    }



    void describe_ground(const scene::SceneParameters &scene, std::string &text)
    {
      const bool  continuum = scene.has_continuum();
      const char *base      = scene.continuum.base.name.c_str();
      if (scene.continuum.base.is_compliant && !scene.has_compliant_base())
        base = "rigid"; // layers let no wave out: the lowest moves as prescribed
      text += line("  continuum          %s%s%s",
                   state(continuum).c_str(),
                   continuum ? "  base " : "",
                   continuum ? base : "");
      if (scene.has_bedrock_blocks())
        text += line("  bedrock blocks     on   %s, base %s", scene.bedrock.name.c_str(), base);
      const bool has_sides = scene.bedrock.has_cells();
      if (has_sides)
        text += line("  sides              on   %s", scene.continuum.sides.words.c_str());
      if (continuum)
        text += line("  boundary springs   %s  alpha_n %g, alpha_t %g",
                     state(scene.continuum.boundary_springs).c_str(),
                     scene.continuum.normal_spring,
                     scene.continuum.tangential_spring);
      const std::size_t planes = has_sides ? scene.bedding.names.size() : 0;
      if (scene.bedrock.has_cells() && scene.maxwell.bedrock_ratio > 0.)
        text += describe_maxwell("bedrock damping", scene.maxwell.bedrock_ratio, scene.maxwell);
      text += line("  bedding planes     %s  %zu %s joints",
                   state(planes > 0).c_str(),
                   planes,
                   scene.bedding.slips ? "Mohr-Coulomb" : "elastic");
    }



    /// "phi 8 deg, c 0 Pa" that a belt has after slip.
    std::string residual(const Material &belt)
    {
      char         text[80];
      const double phi = belt.residual_friction_angle, c = belt.residual_cohesion;
      std::snprintf(text,
                    sizeof(text),
                    "phi %g deg, c %g Pa",
                    phi < 0. ? belt.friction_angle : phi,
                    c < 0. ? belt.cohesion : c);
      return text;
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
          text += line("  belt               on   %s: phi %g deg, c %g Pa, residual %s",
                       name.c_str(),
                       belt.friction_angle,
                       belt.cohesion,
                       as_peak ? "= peak" : residual(belt).c_str());
          if (belt.has_rate_effect())
            text += line("    at the rate v         friction times 1 %+g ln(1 + v / %g m/s)%s",
                         belt.rate_coefficient,
                         belt.reference_rate,
                         belt.rate_coefficient < 0. ? " to first order" : "");
        }
    }



    void describe_mass(const scene::SceneParameters &scene, std::string &text)
    {
      text += line("  blocks             %s", state(scene.blocks.enabled).c_str());
      if (!scene.blocks.enabled)
        return;
      text += line("  fracture           %s", state(scene.blocks.bonded).c_str());
      describe_belt(scene, text);
      if (scene.blocks.yielding)
        {
          const Material &inside = scene.material(scene.blocks.material, "Blocks/Material");
          text += line("  yielding blocks    on   %s: phi %g deg, c %g Pa, dilation %g deg",
                       inside.name.c_str(),
                       inside.friction_angle,
                       inside.cohesion,
                       inside.dilation_angle);
        }
      text += line("  block damping      %s  ratio %g at %g Hz",
                   state(scene.blocks.damping_ratio > 0.).c_str(),
                   scene.blocks.damping_ratio,
                   scene.blocks.damping_frequency);
      if (scene.maxwell.block_ratio > 0.)
        text += describe_maxwell("  of blocks", scene.maxwell.block_ratio, scene.maxwell);
      text += line("  loose blocks       %s  damping %g of critical",
                   state(scene.blocks.loose_damping > 0.).c_str(),
                   scene.blocks.loose_damping);
      const scene::HeterogeneityParameters &h = scene.heterogeneity;
      if (h.modulus_shape > 0. || h.strength_shape > 0.)
        text += line("  heterogeneity      on   Weibull shapes: modulus %s, strength %s; seed %d",
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
        text += line("  water              off");
      else if (around.has_level())
        text += line("  water              on   level %g m, %s", around.water_level, method);
      else
        text += line("  water              on   %s", method);
      if (!tables.level.empty())
        text += line("  level of the water on   from %g to %g m, until %g s",
                     tables.level.lowest(),
                     tables.level.highest(),
                     tables.level.points.back().x());
      if (!tables.line.empty())
        text += line("  phreatic line      on   %zu points, from %g to %g m",
                     tables.line.points.size(),
                     tables.line.lowest(),
                     tables.line.highest());
    }



    void describe_environment(const scene::SceneParameters &scene, std::string &text)
    {
      text += line("  gravity            %s  %g m/s2",
                   state(scene.environment.gravity > 0.).c_str(),
                   scene.environment.gravity);
      if (scene.environment.has_initial_stress())
        text += line("  initial stress     on   horizontal over vertical: %s",
                     scene.environment.initial_stress.c_str());
      if (scene.environment.is_staged())
        text +=
          line("  initial stress     on   of a mass placed in %d lifts", scene.environment.lifts);
      if (scene.environment.horizontal != 0.)
        text +=
          line("  pseudo-static      on   %g times weight along +x", scene.environment.horizontal);
      if (scene.strength_reduction != 1.)
        text += line("  strengths          divided by %g", scene.strength_reduction);
      describe_water(scene.environment, text);
    }



    void describe_motion(const scene::SceneParameters &scene,
                         const scene::Motion          &motion,
                         std::string                  &text)
    {
      if (motion.empty())
        {
          text += line("  motion             off");
          return;
        }
      const double                g = 9.80665;
      const scene::MotionMeasures found =
        scene::measure(scene.motion.outcrop ? motion : motion.scaled(0.5));
      text += line(
        "  motion             on   %s, %s peak %.4g m/s2 (%.3g g), %.4g s, 95 %% of its energy below %.3g Hz",
        scene.motion.type.c_str(),
        scene.motion.outcrop ? "outcrop" : "incident",
        found.peak_acceleration,
        found.peak_acceleration / g,
        motion.duration(),
        highest_frequency(motion));
      if (!scene.motion.outcrop)
        text +=
          line("                          as an outcrop, and of a rigid base, twice that: peak "
               "%.4g m/s2",
               2. * found.peak_acceleration);
      if (scene.motion.repetitions > 1)
        text += line("                          %d times, every %g s",
                     scene.motion.repetitions,
                     scene.motion.repetition_interval);
      if (found.peak_acceleration > 0.)
        text += line(
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
      text += loads ? line("  point loads        on   %zu force%s, Ricker %g Hz",
                           n_loads,
                           n_loads == 1 ? "" : "s",
                           scene.point_loads.frequency)
                    : line("  point loads        off");
      const scene::InitialWaveParameters &wave    = scene.initial_wave;
      const char                         *waves[] = {"", "P", "SV"};
      if (continuum && wave.type != scene::WaveType::none)
        text += line("  initial wave       on   %s from (%g, %g) m towards %g deg, %g Hz, %g m",
                     waves[static_cast<int>(wave.type)],
                     wave.centre.x(),
                     wave.centre.y(),
                     wave.direction,
                     wave.frequency,
                     wave.amplitude);
      if (!scene.blocks.initial_velocities.empty())
        text +=
          line("  initial velocities on   %zu bodies", scene.blocks.initial_velocities.size());
      const scene::EdgeLoadParameters &edges = scene.edge_loads;
      text += edges.tractions.empty()
                ? line("  edge loads         off")
                : line("  edge loads         on   %zu tractions, rising from %g to %g s",
                       edges.tractions.size(),
                       edges.start,
                       edges.start + edges.rise_time);
      describe_motion(scene, motion, text);
    }



    void describe_effects(const scene::SceneParameters &scene,
                          const scene::Motion          &motion,
                          std::string                  &text)
    {
      text += "Effects\n";
      describe_ground(scene, text);
      describe_mass(scene, text);
      describe_environment(scene, text);
      describe_loads(scene, motion, text);
    }



    void warn(const std::string &warning, SceneCard &card)
    {
      if (!warning.empty())
        card.warnings.push_back(warning + "\n");
    }



    /// What a part of blocks is cut into, and what it resolves.
    std::string in_words(const Resolution &r)
    {
      char text[120];
      std::snprintf(text,
                    sizeof(text),
                    "size %.3g to %.3g m; slowest S wave %.4g m/s: resolves %.3g Hz",
                    r.smallest,
                    r.largest,
                    r.slowest_s_wave,
                    r.resolved);
      return text;
    }



    std::size_t joints_of_mass(const dda::Model &model)
    {
      return std::count_if(model.joints.begin(), model.joints.end(), [](const dda::Joint &joint) {
        return !joint.within_bedrock();
      });
    }



    void describe(const Resolution             &r,
                  const scene::SceneParameters &scene,
                  const dda::Model             *blocks,
                  const continuum::Continuum   *continuum,
                  std::string                  &text)
    {
      const std::size_t n_joints = blocks == nullptr ? 0 : joints_of_mass(*blocks);
      switch (r.part)
        {
          case ModelPart::continuum:
            text += line(
              "Continuum  %d cells of degree %d, %zu unknowns, %zu on the contact surface%s; slowest S %.4g, fastest P %.4g m/s: resolves %.3g Hz",
              continuum->resolution().cells,
              scene.continuum.degree,
              continuum->n_unknowns(),
              continuum->resolution().surface_unknowns,
              stiffness_of_surface(*continuum).c_str(),
              r.slowest_s_wave,
              continuum->resolution().fastest_p_wave,
              r.resolved);
            break;
          case ModelPart::bedrock:
            text += line("Bedrock    %d %s, %s",
                         blocks->n_bedrock,
                         scene.bedrock.words.c_str(),
                         in_words(r).c_str());
            break;
          case ModelPart::mass:
            text += line("Blocks     %d block%s, %zu joint%s, %s",
                         blocks->n_mass(),
                         blocks->n_mass() == 1 ? "" : "s",
                         n_joints,
                         n_joints == 1 ? "" : "s",
                         in_words(r).c_str());
        }
    }



    void describe_velocities(const scene::SceneParameters &scene,
                             const dda::Model             &blocks,
                             std::string                  &text)
    {
      auto given = scene.blocks.initial_velocities.begin();
      for (const dda::MovingBlocks &moving : blocks.moving_blocks)
        text += line("Velocity   %s: %zu of %d blocks with %g, %g m/s, %g rad/s",
                     (given++)->name.c_str(),
                     moving.blocks.size(),
                     blocks.n_mass(),
                     moving.velocity.x(),
                     moving.velocity.y(),
                     moving.spin);
    }



    /// Bedrock of blocks too large for waves to run in them.
    void describe_layers(const scene::SceneParameters &scene,
                         const dda::Model             *blocks,
                         std::string                  &text)
    {
      if (blocks == nullptr || blocks->n_bedrock == 0 || scene.bedrock.carries_waves)
        return;
      const auto [smallest, largest] = block_sizes(*blocks, blocks->n_mass(), blocks->n_blocks());
      text += line("Bedrock    %d %s, size %.3g to %.3g m",
                   blocks->n_bedrock,
                   scene.bedrock.words.c_str(),
                   smallest,
                   largest);
    }


    std::string describe_explicit_time(const scene::SceneParameters &scene,
                                       const continuum::Continuum   &continuum)
    {
      const int parts = continuum.parts_of_step(scene.time.time_step);
      return line("Time       %g s in steps of %g s, explicit: %d stable part%s of %.4g s",
                  scene.time.end_time,
                  scene.time.time_step,
                  parts,
                  parts == 1 ? "" : "s",
                  scene.time.time_step / parts);
    }
  } // namespace



  SceneCard make_scene_card(const scene::SceneParameters &scene,
                            const scene::Motion          &motion,
                            const dda::Model             *blocks,
                            const continuum::Continuum   *continuum)
  {
    SceneCard card;
    if (!scene.title.empty())
      card.text += scene.title + "\n";
    describe_effects(scene, motion, card.text);
    const Resolutions resolutions = resolve(scene, motion, blocks, continuum);
    describe_layers(scene, blocks, card.text);
    for (const Resolution &part : resolutions.parts)
      {
        describe(part, scene, blocks, continuum, card.text);
        warn(mesh_warning(part, resolutions.wanted), card);
      }
    if (blocks != nullptr)
      describe_velocities(scene, *blocks, card.text);
    if (scene.continuum.is_explicit && continuum != nullptr)
      card.text += describe_explicit_time(scene, *continuum);
    else
      card.text +=
        line("Time       %g s in steps of %g s, scheme %s: Newmark beta %g, gamma %g%s%s%s",
             scene.time.end_time,
             scene.time.time_step,
             scene.time.scheme.c_str(),
             scene.time.newmark.beta,
             scene.time.newmark.gamma,
             scene.time.newmark.filter > 0. ? ", filtered" : "",
             scene.time.newmark.corrected_step > 0. ? ", fourth order" : "",
             continuum != nullptr && continuum->is_iterated() ? ", conjugate gradients" : "");
    warn(step_warning(scene.time.time_step, resolutions.wanted), card);
    if (scene.continuum.is_explicit && continuum != nullptr)
      warn(parts_warning(continuum->parts_of_step(scene.time.time_step)), card);
    if (continuum != nullptr)
      {
        const auto reach = continuum->wave_at_boundary();
        warn(wave_warning(reach.fraction, reach.where), card);
      }
    if (blocks != nullptr)
      {
        warn(speed_warning(*blocks, scene.time.time_step), card);
        warn(fracture_warning(scene, *blocks), card);
        warn(belt_warning(scene, *blocks), card);
      }
    warn(drag_warning(scene), card);
    warn(penalty_warning(scene), card);
    warn(pictures_warning(scene.output, scene.time), card);
    warn(threads_warning(scene.threads, std::thread::hardware_concurrency()), card);
    const double k01 = scene.time.dynamic_coefficient;
    if (k01 < 1.)
      card.warnings.push_back(line(
        "the dynamic coefficient %g brakes every block: damping rate %.4g 1/s, terminal velocity of a "
        "free fall %.4g m/s",
        k01,
        (1. - k01) / scene.time.time_step,
        scene.environment.gravity * scene.time.time_step / (1. - k01)));
    for (std::string &warning : card.warnings)
      warning.pop_back(); // the line's end
    card.text.pop_back();
    return card;
  }
} // namespace hybrid::output
