// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace hybrid::output
{
  /// Parts of a model in which waves run.
  enum class ModelPart
  {
    continuum, ///< bedrock of finite elements
    bedrock,   ///< bedrock of blocks small enough to carry waves
    mass       ///< blocks of the sliding mass
  };


  /// What one part of the model resolves, at ten points per wave length: f = c_s / (10 h), or that
  /// of the finite elements with their degree.
  struct Resolution
  {
    ModelPart part           = ModelPart::continuum;
    double    resolved       = 0.; ///< highest frequency [Hz]
    double    slowest_s_wave = 0.; ///< [m/s]
    double    smallest       = 0.; ///< size of the blocks [m]; 0: of finite elements, not asked for
    double    largest        = 0.; ///< [m]
    double    points         = 10.; ///< sizes h per wave length: 10, of finite elements 10 / degree
  };


  /// What a model resolves, and what it has to.
  struct Resolutions
  {
    std::vector<Resolution> parts;       ///< in the order of ModelPart
    double                  wanted = 0.; ///< 95 % of the energy of all that shakes lie below [Hz]

    /// Of the part that resolves least [Hz]; NaN if waves run in none.
    double lowest() const;
  };


  /// "the continuum", "the bedrock", "the sliding mass"
  std::string name(ModelPart part);

  /// Parts that a scene does not have are nullptr. @param motion the outcrop motion.
  Resolutions resolve(const scene::SceneParameters &scene,
                      const scene::Motion          &motion,
                      const dda::Model             *blocks,
                      const continuum::Continuum   *continuum);

  /// Smallest and largest size of the blocks from @p begin to before @p end [m].
  std::pair<double, double> block_sizes(const dda::Model &model, int begin, int end);

  /// Frequency below which a motion has the part @p share of its squared acceleration spectrum
  /// [Hz].
  double highest_frequency(const scene::Motion &motion, double share = 0.95);
} // namespace hybrid::output
