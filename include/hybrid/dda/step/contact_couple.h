// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Angular impulse per width on a block that keeps the angular momentum of blocks that touch
   * [N s], anticlockwise.
   *
   * A contact acts with arms to where its place is at the end of the step, while the centres move
   * as if it had acted half a step earlier. The impulse J on the block A from the block B changes
   * their angular momentum by -dt/2 (v_A - v_B) x J, v: velocities of the centres at the start of
   * the step. So each has the couple
   *
   *     dt/2 (v_A - v_B) x J    times its part of both moments of inertia
   *
   * of each contact and torn end of a joint between the two: they turn by the same, so that what a
   * light block bears of a heavy one does not turn it. What bears on the ground has none.
   *
   * @param trial of the step's solution, evaluated last by @p springs
   * @param velocity of each block at the start of the step (u, v, r, ex, ey, gxy) [m/s, 1/s]
   * @param mass of each block in this step
   */
  double contact_couple(const Springs                &springs,
                        const Trial                  &trial,
                        const std::vector<Vec6>      &velocity,
                        const std::vector<BlockMass> &mass,
                        int                           block);
} // namespace hybrid::dda
