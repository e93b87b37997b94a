// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/advice.h>
#include <hybrid/output/scene_card.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdarg>
#include <cstdio>
#include <numeric>
#include <thread>
#include <utility>

namespace hybrid::output
{
  namespace
  {
    constexpr double points_per_wavelength = 10.;



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
        }
    }



    void describe_mass(const scene::SceneParameters &scene, std::string &text)
    {
      text += line("  blocks             %s", state(scene.blocks.enabled).c_str());
      if (!scene.blocks.enabled)
        return;
      text += line("  fracture           %s", state(scene.blocks.bonded).c_str());
      describe_belt(scene, text);
      text += line("  block damping      %s  ratio %g at %g Hz",
                   state(scene.blocks.damping_ratio > 0.).c_str(),
                   scene.blocks.damping_ratio,
                   scene.blocks.damping_frequency);
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



    void describe_environment(const scene::SceneParameters &scene, std::string &text)
    {
      text += line("  gravity            %s  %g m/s2",
                   state(scene.environment.gravity > 0.).c_str(),
                   scene.environment.gravity);
      const bool  water     = scene.environment.water_level > -1e299;
      const char *methods[] = {"paper", "submerged", "pressures"};
      text += water ? line("  water              on   level %g m, %s",
                           scene.environment.water_level,
                           methods[static_cast<int>(scene.environment.water_method)])
                    : line("  water              off");
    }



    void describe_loads(const scene::SceneParameters &scene,
                        const scene::Motion          &motion,
                        std::string                  &text)
    {
      const bool continuum = scene.has_continuum();
      const bool loads     = continuum && !scene.point_loads.loads.empty();
      text += line("  point loads        %s  %zu forces, Ricker %g Hz",
                   state(loads).c_str(),
                   scene.point_loads.loads.size(),
                   scene.point_loads.frequency);
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
      const double peak = motion.peak_acceleration() / (scene.motion.outcrop ? 1. : 2.);
      text +=
        motion.empty()
          ? line("  motion             off")
          : line(
              "  motion             on   %s, %s peak %.4g m/s2 (%.3g g), %.4g s, 95 %% of its energy below %.3g Hz",
              scene.motion.type.c_str(),
              scene.motion.outcrop ? "outcrop" : "incident",
              peak,
              peak / 9.80665,
              motion.duration(),
              highest_frequency(motion));
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



    /// Means of as many samples as lie within a quarter of a millisecond, or of two where there are
    /// very many: enough up to 50 Hz.
    scene::Motion averaged(const scene::Motion &motion)
    {
      const auto &a = motion.samples();
      if (a.size() < 2)
        return motion;
      const double      spacing = a.size() > 100000 ? 2e-3 : 0.25e-3; // [s]
      const std::size_t group =
        std::clamp(std::floor(spacing / motion.time_step()), 1., double(a.size() / 2));
      if (group < 2)
        return motion;
      std::vector<double> means(a.size() / group);
      for (std::size_t i = 0; i < means.size(); ++i)
        means[i] =
          std::accumulate(a.begin() + i * group, a.begin() + (i + 1) * group, 0.) / double(group);
      return {group * motion.time_step(), means};
    }



    /// Below which 95 % of the energy of point loads and initial wave are [Hz]. The power of a
    /// Ricker wavelet is that of a chi-square distribution of 4 (f / f_0)^2 with five degrees of
    /// freedom; that of a packet, l wave lengths long, is normal with deviation f_0 / (sqrt(8) pi
    /// l).
    double highest_frequency(const scene::SceneParameters &scene)
    {
      double result = 0.;
      if (!scene.has_continuum())
        return result;
      if (!scene.point_loads.loads.empty())
        result = 1.664 * scene.point_loads.frequency;
      const scene::InitialWaveParameters &wave = scene.initial_wave;
      if (wave.type != scene::WaveType::none)
        result =
          std::max(result, wave.frequency * (1. + 1.645 / (std::sqrt(8.) * M_PI * wave.length)));
      return result;
    }



    void warn(const std::string &warning, SceneCard &card)
    {
      if (!warning.empty())
        card.warnings.push_back(warning + "\n");
    }



    /// Smallest and largest size of the blocks from @p begin to before @p end [m].
    std::pair<double, double> sizes(const dda::Model &model, const int begin, const int end)
    {
      double smallest = 1e300, largest = 0.;
      for (int b = begin; b < end; ++b)
        {
          smallest = std::min(smallest, model.blocks[b].size);
          largest  = std::max(largest, model.blocks[b].size);
        }
      return {smallest, largest};
    }



    void describe_bedrock_blocks(const dda::Model             &model,
                                 const scene::SceneParameters &scene,
                                 const double                  wanted,
                                 SceneCard                    &card)
    {
      const int first                = model.n_mass();
      const auto [smallest, largest] = sizes(model, first, model.n_blocks());
      const char *words              = scene.bedrock.words.c_str();
      if (!scene.bedrock.carries_waves)
        {
          card.text += line(
            "Bedrock    %d %s, size %.3g to %.3g m", model.n_bedrock, words, smallest, largest);
          return;
        }
      double slowest = 1e300;
      for (const auto &entry : scene.continuum.region_material)
        slowest =
          std::min(slowest, scene.material(entry.second, "Continuum/Materials").s_wave_speed());
      const double resolved = slowest / (points_per_wavelength * largest);
      card.text +=
        line("Bedrock    %d %s, size %.3g to %.3g m; slowest S wave %.4g m/s: resolves %.3g Hz",
             model.n_bedrock,
             words,
             smallest,
             largest,
             slowest,
             resolved);
      warn(
        mesh_warning(
          {"the bedrock", resolved, wanted, "blocks", slowest / (points_per_wavelength * wanted)}),
        card);
    }



    void describe_blocks(const dda::Model             &model,
                         const scene::SceneParameters &scene,
                         const double                  wanted,
                         SceneCard                    &card)
    {
      if (model.n_bedrock > 0)
        describe_bedrock_blocks(model, scene, wanted, card);
      const int n_mass = model.n_mass();
      if (n_mass == 0)
        return;
      const auto [smallest, largest] = sizes(model, 0, n_mass);
      const Material &m              = scene.material(scene.blocks.material, "Blocks/Material");
      double          slowest        = m.s_wave_speed();
      if (scene.environment.water_level > -1e299 && !scene.blocks.saturated_material.empty())
        slowest =
          std::min(slowest,
                   scene.material(scene.blocks.saturated_material, "Blocks/Saturated material")
                     .s_wave_speed());
      const double resolved = slowest / (points_per_wavelength * largest);
      card.text += line(
        "Blocks     %d blocks, %zu joints, size %.3g to %.3g m; slowest S wave %.4g m/s: resolves %.3g Hz",
        n_mass,
        model.joints.size(),
        smallest,
        largest,
        slowest,
        resolved);
      warn(mesh_warning({"the sliding mass",
                         resolved,
                         wanted,
                         "blocks",
                         slowest / (points_per_wavelength * wanted)}),
           card);
    }
  } // namespace



  double highest_frequency(const scene::Motion &motion, const double share)
  {
    // Plain discrete Fourier sums at 400 frequencies: enough for a figure on a card.
    const scene::Motion coarse = averaged(motion);
    const auto         &a      = coarse.samples();
    if (a.size() < 2)
      return 0.;
    constexpr int       n   = 400;
    const double        top = std::min(50., 0.5 / motion.time_step());
    std::vector<double> power(n);
    double              total = 0.;
    for (int k = 0; k < n; ++k)
      {
        const std::complex<double> turn =
          std::polar(1., -2. * M_PI * top * (k + 1) / n * coarse.time_step());
        std::complex<double> sum = 0., factor = 1.;
        for (const double value : a)
          {
            sum += value * factor;
            factor *= turn;
          }
        total += power[k] = std::norm(sum);
      }
    double below = 0.;
    for (int k = 0; k < n; ++k)
      if ((below += power[k]) >= share * total)
        return top * (k + 1) / n;
    return top;
  }



  SceneCard make_scene_card(const scene::SceneParameters &scene,
                            const scene::Motion          &motion,
                            const dda::Model             *blocks,
                            const continuum::Continuum   *continuum)
  {
    SceneCard card;
    if (!scene.title.empty())
      card.text += scene.title + "\n";
    describe_effects(scene, motion, card.text);
    const double wanted =
      std::max(motion.empty() ? 0. : highest_frequency(motion), highest_frequency(scene));
    if (continuum != nullptr)
      {
        const auto r = continuum->resolution();
        card.text += line(
          "Continuum  %d cells of degree %d, %zu unknowns, %zu on the contact surface; S %.4g, P %.4g m/s: resolves %.3g Hz",
          r.cells,
          scene.continuum.degree,
          continuum->n_unknowns(),
          r.surface_unknowns,
          r.slowest_s_wave,
          r.fastest_p_wave,
          r.highest_frequency);
        warn(mesh_warning(
               {"the continuum",
                r.highest_frequency,
                wanted,
                "cells",
                r.slowest_s_wave * scene.continuum.degree / (points_per_wavelength * wanted)}),
             card);
      }
    if (blocks != nullptr)
      describe_blocks(*blocks, scene, wanted, card);
    card.text += line("Time       %g s in steps of %g s, scheme %s: Newmark beta %g, gamma %g",
                      scene.time.end_time,
                      scene.time.time_step,
                      scene.time.scheme.c_str(),
                      scene.time.newmark.beta,
                      scene.time.newmark.gamma);
    warn(step_warning(scene.time.time_step, wanted), card);
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
