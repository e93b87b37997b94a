// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/scene_reader.h>

#include <string>
#include <vector>

namespace hybrid::scene::test
{
  /// Waves alone in steps of 0.6 ms (parameters/verification/lamb.prm).
  inline SceneParameters lamb_scene(std::vector<std::string> overrides,
                                    const std::string       &integrator)
  {
    overrides.push_back("Continuum/Time integrator=" + integrator);
    return read_scene(HYBRID_SOURCE_DIR "/parameters/verification/lamb.prm", overrides);
  }
} // namespace hybrid::scene::test
