// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/bedrock/rigid_bedrock.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::scene::test
{
  /// Nothing but a rigid base.
  inline SceneParameters rigid_scene()
  {
    SceneParameters scene;
    scene.bedrock = rigid_bedrock();
    return scene;
  }
} // namespace hybrid::scene::test
