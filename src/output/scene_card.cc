// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/advice.h>
#include <hybrid/output/card_line.h>
#include <hybrid/output/effects_card.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/scene_card.h>

#include <cmath>
#include <set>
#include <thread>

namespace hybrid::output
{
  namespace
  {
    std::string stiffness_of_surface(const continuum::Continuum &bedrock)
    {
      if (!bedrock.resolution().surface_is_banded)
        return "";
      return bedrock.is_iterated()
               ? " (stiffness banded; finding it takes as long as a hundred steps or more)"
               : " (stiffness banded)";
    }



    void warn(const std::string &warning, SceneCard &card)
    {
      if (!warning.empty())
        card.warnings.push_back(warning + "\n");
    }



    /// What a part of blocks is cut into, and what it resolves.
    std::string in_words(const Resolution &r)
    {
      return formatted("size %.3g to %.3g m; slowest S wave %.4g m/s: resolves %.3g Hz",
                       r.smallest,
                       r.largest,
                       r.slowest_s_wave,
                       r.resolved);
    }



    std::string counted(const std::size_t number, const char *what)
    {
      return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
    }



    /// Joints between blocks of the mass, and those of the belt: one per edge of a block on it, or
    /// more where the bedrock has nodes between the ends of that edge.
    std::string joints_of_mass(const dda::Model &model)
    {
      std::size_t                   between = 0, of_belt = 0;
      std::set<std::pair<int, int>> edges; // block, first vertex
      for (const dda::Joint &joint : model.joints)
        if (joint.kind == dda::JointKind::belt)
          {
            ++of_belt;
            edges.insert({joint.block, joint.edge});
          }
        else if (!joint.within_bedrock())
          ++between;
      std::string text = counted(between, "joint") + " between them";
      if (of_belt > 0)
        text += ", a belt of " + counted(edges.size(), "edge");
      if (of_belt > edges.size())
        text += " in " + counted(of_belt, "joint") + " (parted at the nodes of the bedrock)";
      return text;
    }



    void describe(const Resolution             &r,
                  const scene::SceneParameters &scene,
                  const dda::Model             *blocks,
                  const continuum::Continuum   *continuum,
                  std::string                  &text)
    {
      switch (r.part)
        {
          case ModelPart::continuum:
            text += card_line(
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
            text += card_line("Bedrock    %d %s, %s",
                              blocks->n_bedrock,
                              scene.bedrock.words.c_str(),
                              in_words(r).c_str());
            break;
          case ModelPart::mass:
            text += card_line("Blocks     %s, %s, %s",
                              counted(blocks->n_mass(), "block").c_str(),
                              joints_of_mass(*blocks).c_str(),
                              in_words(r).c_str());
        }
    }



    void describe_velocities(const scene::SceneParameters &scene,
                             const dda::Model             &blocks,
                             std::string                  &text)
    {
      auto given = scene.blocks.initial_velocities.begin();
      for (const dda::MovingBlocks &moving : blocks.moving_blocks)
        text += card_line("Velocity   %s: %zu of %d blocks with %g, %g m/s, %g rad/s",
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
      text += card_line("Bedrock    %d %s, size %.3g to %.3g m",
                        blocks->n_bedrock,
                        scene.bedrock.words.c_str(),
                        smallest,
                        largest);
    }


    std::string describe_explicit_time(const scene::SceneParameters &scene,
                                       const continuum::Continuum   &continuum)
    {
      const int parts = continuum.parts_of_step(scene.time.time_step);
      return card_line("Time       %g s in steps of %g s, explicit: %d stable part%s of %.4g s",
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
    card.text += describe_effects(scene, motion);
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
        card_line("Time       %g s in steps of %g s, scheme %s: Newmark beta %g, gamma %g%s%s%s",
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
      card.warnings.push_back(card_line(
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
