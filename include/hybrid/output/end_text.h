// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/summary.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>

namespace hybrid::output
{
  /// What a run says at its end: how far it got, what it cost, what it found.
  struct EndText
  {
    std::string on_screen; ///< with times and places, which differ between equal runs
    std::string in_file;   ///< without
  };

  EndText end_text(const Summary &summary, const scene::SceneParameters &scene);
} // namespace hybrid::output
