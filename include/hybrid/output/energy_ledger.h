// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <hybrid/coupling/coupled_state.h>

#include <cmath>
#include <string>
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
    bool yielding         = false; ///< blocks yield
    bool level_changes    = false; ///< of the water
  };


  /// A term of the audit and its value [J/m].
  struct EnergyTerm
  {
    std::string name;
    double      value;
  };


  /**
   * The energy audit of the whole model.
   *
   * All terms relative to the start of the dynamic stage: energy held (blocks,
   * springs, bedrock), energy lost, less the work put in. Their sum is zero if
   * nothing is created or forgotten. It is compared with the energy in play, the
   * largest total of absolute terms so far, kinetic energy at the start included,
   * of physics alone: not what the time integration or the replacing of
   * contacts takes, which is judged beside it. The work against static stress
   * and that against gravity are one term there, because mass and rock that are
   * lifted together leave nothing of either.
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

    /// A term now [J/m]; 0 if there is none of that name.
    double value(const std::string &name) const;

    /// After every step: the kinetic energy of the blocks [J/m].
    void note_kinetic_of_blocks(const double kinetic)
    {
      largest_kinetic = std::max(largest_kinetic, kinetic);
    }

    /// The largest so far [J/m].
    double largest_kinetic_of_blocks() const
    {
      return largest_kinetic;
    }

    /// Sum of the terms now over the energy in play so far [-].
    double residual() const
    {
      return std::abs(imbalance) / in_play;
    }

    /// What the scheme has taken or given, over the energy in play [-]: time integration of blocks
    /// and bedrock together, and replaced springs, each in absolute value.
    double scheme_fraction() const
    {
      return scheme_total / in_play;
    }

    /// What the scheme has given in all, over the energy in play [-]; 0 if it took.
    double given_by_scheme() const
    {
      return std::max(0., -scheme_sum) / in_play;
    }

    /// What the scheme has given since it had taken most, over the energy in play [-].
    double given_back() const
    {
      return (most_taken - scheme_sum) / in_play;
    }

    /// Sum of the terms now [J/m]; positive: created.
    double sum() const
    {
      return imbalance;
    }

    /// Energy in play so far [J/m].
    double exchanged() const
    {
      return in_play;
    }

    /// What changed most since the audit before, largest first, at most @p n [J/m].
    std::vector<EnergyTerm> largest_changes(int n) const;

    /// Terms of the scheme [J/m].
    std::vector<EnergyTerm> scheme_terms() const;

    /// What the terms are relative to [J/m]; empty before the first call of update().
    const std::vector<double> &at_start() const
    {
      return start;
    }

    /// Largest sum so far over the energy in play so far [-].
    double largest_residual() const
    {
      return largest / in_play;
    }

    /// For the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    bool                has_continuum;
    EffectTerms         effects;
    std::vector<double> start, terms, before;
    double              in_play   = 1e-300; ///< see exchanged() [J/m]
    double              imbalance = 0., scheme_total = 0., scheme_sum = 0., largest = 0.; ///< [J/m]
    double              most_taken      = 0.; ///< by the scheme, of all terms [J/m]
    double              largest_kinetic = 0.; ///< of the blocks [J/m]
  };
} // namespace hybrid::output
