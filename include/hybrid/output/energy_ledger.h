// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/coupled_state.h>

#include <string>
#include <utility>
#include <vector>

namespace hybrid::output
{
  /// Terms that only scenes with these effects have.
  struct EffectTerms
  {
    bool boundary_springs = false;
    bool blocks           = false; ///< the bedrock is blocks
    bool bedding_slip     = false;
    bool edge_loads       = false;
  };


  /**
   * The energy audit of the whole model.
   *
   * All terms relative to the start of the dynamic stage: energy held (blocks,
   * springs, bedrock), energy lost, less the work put in. Their sum is zero if
   * nothing is created or forgotten; the residual is |sum| over the largest
   * total of absolute terms so far (floor 1e-9 J/m).
   */
  class EnergyLedger
  {
  public:
    explicit EnergyLedger(bool with_continuum, const EffectTerms &terms_of_effects = {})
      : has_continuum(with_continuum)
      , effects(terms_of_effects)
    {}

    /// Names of the terms, in the order of values().
    std::vector<std::string> names() const;

    /// Terms now [J/m], those of the bedrock as audited; the first call sets the start.
    const std::vector<double> &update(const coupling::CoupledState     &state,
                                      const continuum::ContinuumEnergy &bedrock);

    /// The same with the bedrock's energy of the state.
    const std::vector<double> &update(const coupling::CoupledState &state)
    {
      return update(state, state.continuum.energy);
    }

    const std::vector<double> &values() const
    {
      return terms;
    }

    /// Relative residual now [-].
    double residual() const
    {
      return imbalance;
    }

    /// What the terms are relative to [J/m]; empty before the first call of update().
    const std::vector<double> &at_start() const
    {
      return start;
    }

    /// Largest relative residual so far [-].
    double largest_residual() const
    {
      return largest;
    }

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    bool                has_continuum;
    EffectTerms         effects;
    std::vector<double> start, terms;
    double              exchanged = 1e-9, imbalance = 0., largest = 0.;
  };
} // namespace hybrid::output
