// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/output/resolution.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>

namespace hybrid::output
{
  /// Two significant digits, not above @p value: what is recommended must do.
  double rounded_down(double value);

  /// The part resolves less than @p wanted [Hz], with the size that would do; "" if it resolves
  /// enough.
  std::string mesh_warning(const Resolution &resolution, double wanted);

  /// Fewer than 20 steps per period of the motion's @p highest_frequency [Hz]; "" if there are
  /// more.
  std::string step_warning(double time_step, double highest_frequency);

  /// Explicit steps of so many stable parts that implicit steps cost less, or "".
  std::string parts_warning(int parts);

  /// The initial wave is on the boundary already at t = 0, with @p part of its amplitude [-] at @p
  /// where; "" if that is less than 1 %.
  std::string wave_warning(double fraction, const Vec2 &where);

  /// A block that @p model sets in motion goes farther in a step than Time/Maximum displacement
  /// ratio allows; "" if none does.
  std::string speed_warning(const dda::Model &model, double time_step);

  /**
   * Penalty ratio alpha outside alpha_0 to 200 alpha_0, alpha_0 = 5 max(1, 2 (lambda + G)/E); "" if
   * within.
   *
   * Joints of stiffness alpha E/h on the edges of blocks of size h add about 2/(alpha E) to the
   * mass's compliance 1/(lambda + G) in plane compression: below alpha_0 more than a fifth of it.
   * Far above, contacts take more iterations and smaller steps (doc/hard-cases.md) and gain
   * nothing.
   */
  std::string penalty_warning(const scene::SceneParameters &scene);

  /**
   * Blocks larger than E G_f / F_t^2 of a material whose joints can break: what a block stores when
   * its joint breaks, F_t^2 h / (2 E), is more than half of the fracture energy, so that it breaks
   * as if brittle; "" if the fracture is resolved, brittle by intent (no fracture energy) or out of
   * reach (F_t above E / 20).
   */
  std::string fracture_warning(const scene::SceneParameters &scene, const dda::Model &model);

  /// A belt that bonds no block to the ground; "" if it bonds one or there is none.
  std::string belt_warning(const scene::SceneParameters &scene, const dda::Model &model);

  /// The dynamic coefficient k01 brakes blocks against a frame at rest while their ground moves; ""
  /// if it is 1 or nothing moves.
  std::string drag_warning(const scene::SceneParameters &scene);

  /// More threads than processors, or "".
  std::string threads_warning(int threads, int processors);

  /// Processes of one machine whose threads are more than its processors, or "".
  std::string processes_warning(int processes, int threads, int processors);

  /// So many files for ParaView that nobody can want them, or "".
  std::string pictures_warning(const scene::OutputParameters &output,
                               const scene::TimeParameters   &time);
} // namespace hybrid::output
