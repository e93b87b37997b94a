// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/output/resolution.h>
#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// What a scene is, in a few lines for its user, and what looks wrong with it.
  struct SceneCard
  {
    std::string              text;
    std::vector<std::string> warnings; ///< one sentence each
  };


  /// Parts that a scene does not have are nullptr. @param motion the outcrop motion.
  SceneCard make_scene_card(const scene::SceneParameters &scene,
                            const scene::Motion          &motion,
                            const dda::Model             *blocks,
                            const continuum::Continuum   *continuum);

} // namespace hybrid::output
