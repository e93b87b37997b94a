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
   * as if it had acted half a step earlier. With the impulse J on a block, the velocity v_p of the
   * place and that of the block's centre, v, at the start of the step, the couple
   *
   *     -dt/2 (v_p - v) x J
   *
   * of each of its contacts and torn ends of joints brings the arm to the middle of the step.
   * Whatever v_p is, both bodies of a contact together then keep their angular momentum. It is that
   * of the corner, of joints the mean of both blocks, and on the ground that of the block itself.
   *
   * @param trial of the step's solution, evaluated last by @p springs
   * @param velocity of each block at the start of the step (u, v, r, ex, ey, gxy) [m/s, 1/s]
   */
  double contact_couple(const Springs           &springs,
                        const Trial             &trial,
                        const std::vector<Vec6> &velocity,
                        int                      block);
} // namespace hybrid::dda
