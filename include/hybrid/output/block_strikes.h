// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/energy_ledger.h>

namespace hybrid::output
{
  /**
   * Whether the blocks of a run struck each other so much that runs in other steps may go another
   * way.
   *
   * In a strike velocities jump, and the time integration takes of their energy what a step does
   * not resolve (blocks_integration_loss): in blocks that slide or stand nothing, however much they
   * rub. The sign is that it took more than 3 % of the largest kinetic energy that the blocks had,
   * and that there are two loose blocks or more: one alone has nothing to strike but the ground,
   * and goes one way. What it was found from: doc/accuracy.md, Loose blocks.
   *
   * @param n_loose blocks that no joint held at the start
   */
  bool blocks_strike(int n_loose, const EnergyLedger &ledger);
} // namespace hybrid::output
