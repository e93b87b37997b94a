// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/energy_ledger.h>

#include <string>

namespace hybrid::output
{
  /**
   * Says when the energy audit of a run does not close: a warning once the residual passes the one
   * limit, the end of the run at the other.
   */
  class EnergyWatch
  {
  public:
    /// @param warning_fraction, limit_fraction residuals [-]; 0: never.
    EnergyWatch(const double warning_fraction, const double limit_fraction)
      : warning(warning_fraction)
      , limit(limit_fraction)
    {}

    /// Look at the audit of @p time [s]. @return what is to be said now; empty: nothing.
    std::string look(const EnergyLedger &ledger, double time);

    /// True if the run has to stop: the last audit is above the limit.
    bool is_over(const EnergyLedger &ledger) const
    {
      return passes(ledger, limit);
    }

    /// What the scheme took, where that is more than the warning's part; said once, at the end.
    std::string of_scheme(const EnergyLedger &ledger) const;

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    static bool passes(const EnergyLedger &ledger, double fraction);

    const double warning, limit;
    bool         has_warned = false;
  };
} // namespace hybrid::output
