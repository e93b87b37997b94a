// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/energy_ledger.h>

#include <string>

namespace hybrid::output
{
  /**
   * Says when the energy of a run goes wrong: a warning once the residual of the audit, or what the
   * scheme has given, passes the one limit, the end of the run at the other. (What the scheme takes
   * depends on the step, but harms no run; what it gives grows.) A warning, too, where it gives
   * much after it had taken more, as in bodies that hit the ground.
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

    /// True if the run has to stop: the last audit is above the limit, or the scheme gave more.
    bool is_over(const EnergyLedger &ledger) const
    {
      return passes(ledger, limit);
    }

    /// What the scheme took, where that is more than the warning's part; said once, at the end. Not
    /// where the energy in play is no more than @p settling, the work of weights that act at once
    /// over the elastic settlement [J/m]: then nothing has moved, and the scheme takes the ringing.
    std::string of_scheme(const EnergyLedger &ledger, double settling = 0.) const;

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    static bool passes(const EnergyLedger &ledger, double fraction);

    const double warning, limit;
    bool         has_warned = false, has_told_gain = false;
  };
} // namespace hybrid::output
