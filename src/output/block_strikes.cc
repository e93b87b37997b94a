// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/block_strikes.h>

namespace hybrid::output
{
  bool blocks_strike(const int n_loose, const EnergyLedger &ledger)
  {
    constexpr int    least_blocks = 2;
    constexpr double least_part   = 0.03; ///< of the kinetic energy [-]
    return n_loose >= least_blocks && ledger.value("blocks_integration_loss") >
                                        least_part * ledger.largest_kinetic_of_blocks();
  }
} // namespace hybrid::output
