// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/output/history_file.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

/**
 * @file
 * Tables of run.h5 that say what went into a run, each only if the scene has the effect; see
 * run_file.md.
 */
namespace hybrid::output
{
  /// spectrum/*: target and fit of a spectrum-compatible motion.
  void write_spectrum(HistoryFile &file, const scene::SpectrumFit &fit, bool outcrop);

  /// heterogeneity/*: factors of blocks and joints.
  void write_heterogeneity(HistoryFile                          &file,
                           const scene::HeterogeneityParameters &heterogeneity,
                           const dda::Model                     &model);

  /// interface/water_force: load of the water on the bedrock.
  void write_water(HistoryFile &file, const dda::Model &model);

  /// section/water_line and section/water_levels, where the scene has them.
  void write_water_tables(HistoryFile &file, const scene::WaterTables &tables);

  /// Initial place of one end of a joint [m].
  Vec2 joint_point(const dda::Geometry     &initial,
                   const dda::Joint        &joint,
                   const dda::Joint::Point &point);
} // namespace hybrid::output
