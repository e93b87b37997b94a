// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * Values that can be computed with, but that no rock, soil or planet has, one sentence each with
   * the unit in which the number would make sense: density outside 300 to 12000 kg/m3 (t/m3,
   * kN/m3, N/m3), Young's modulus outside 50 kPa to 1.1 TPa (kPa, MPa, GPa), a friction angle
   * below pi/2 degrees (radians), a cohesion or tensile strength below 50 Pa (kPa, MPa), water
   * outside 500 to 2500 kg/m3, damping beyond the critical one at 1 Hz, gravity outside 1.5 m/s2
   * (the Moon) to 2000 m/s2 (a centrifuge), bedding planes outside 0.1 MPa/m to 100 TPa/m, a
   * softening slip above 5 m (mm), and a @p motion (as given) that shakes harder than any record.
   */
  std::vector<std::string> doubtful_values(const SceneParameters &scene, const Motion &motion = {});
} // namespace hybrid::scene
