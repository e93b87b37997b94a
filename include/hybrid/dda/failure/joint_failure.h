// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::dda
{
  /**
   * Bond of a joint after a step: failure is complete when both ends are broken,
   * and counts as tensile if one of them is torn. An end that is torn and has opened by
   * a tenth of the length ends the whole joint: its edges have turned apart by 0.1,
   * and the mean of their directions, in which springs act, means nothing in the
   * end (at 180 degrees it turns round). A failed joint that has slid or
   * opened by a tenth of its length is released: vertex contacts take over. From the
   * failure on it has yielded: its blocks look at all their neighbours. So has a
   * joint of the body that has slid or opened by 1/400 of its length before; in the static stage of
   * blocks that yield by a tenth, as corners that catch make them stronger. A joint that slides
   * into an edge that rises beyond its end (Joint::valley) knows nothing of that edge: 1/400 of its
   * length deep in it a belt has yielded, and a joint of the body, which only blocks that are not
   * convex have there, has failed and is released. Bedding planes are not counted.
   *
   * @param time at the end of the step [s]; negative: in the static stage
   */
  void
  update_failure(const Joint &joint, double time, JointState &state, bool blocks_yield = false);
} // namespace hybrid::dda
