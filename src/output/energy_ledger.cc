// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/energy_ledger.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    using Terms = std::vector<EnergyTerm>;

    /// Energies below which nothing is said of their balance: what forces that balance to 1e-8 do
    /// on ways of micrometres, and the round-off of what is held at the start.
    constexpr double min_in_play      = 1e-3; ///< [J/m]
    constexpr double fraction_of_held = 1e-6; ///< [-]



    /// What the time integration takes from blocks and bedrock. Only the sum is physical: what the
    /// forces between both do in the scheme stands in each part, with opposite signs.
    bool is_integration(const std::string &name)
    {
      return name == "blocks_integration_loss" || name == "bedrock_integration_loss";
    }



    /// Numbers of the time integration and the contact search, not of physics.
    bool is_of_scheme(const std::string &name)
    {
      return name == "spring_replacement_loss" || is_integration(name);
    }



    /// Work that moving mass and rock together does on each other's account, water between them
    /// included.
    bool is_of_weight(const std::string &name)
    {
      return name == "blocks_gravity" || name == "water_work" || name == "bedrock_static_stress";
    }



    bool is_kinetic(const std::string &name)
    {
      return name == "blocks_kinetic" || name == "bedrock_kinetic";
    }


    /// All terms with the sign they have in the sum.
    Terms collect(const coupling::CoupledState     &state,
                  const continuum::ContinuumEnergy &c,
                  const bool                        has_continuum,
                  const EffectTerms                &effects)
    {
      const dda::BlockEnergy &b     = state.blocks.energy;
      Terms                   terms = {{"blocks_kinetic", b.kinetic},
                                       {"blocks_strain", b.strain},
                                       {"blocks_gravity", b.gravity},
                                       {"joints_and_contacts", b.springs},
                                       {"friction_loss", b.friction_loss},
                                       {"fracture_loss", b.fracture_loss},
                                       {"blocks_damping_loss", b.damping_loss},
                                       {"blocks_integration_loss", b.integration_loss},
                                       {"spring_replacement_loss", b.spring_replacement_loss}};
      if (effects.yielding)
        terms.push_back({"yield_loss", b.yield_loss});
      if (effects.edge_loads)
        terms.push_back({"edge_load_work", -b.edge_load_work});
      if (effects.level_changes)
        terms.push_back({"water_work", -b.water_work});
      if (!has_continuum)
        {
          terms.push_back({"base_work", -b.foundation_work});
          if (effects.blocks)
            terms.insert(terms.end(),
                         {{"bedrock_static_stress", b.static_work},
                          {"boundary_loss", b.boundary_loss},
                          {"input_work", -b.input_work}});
          if (effects.bedding_slip)
            terms.push_back({"bedding_loss", b.bedding_loss});
          return terms;
        }
      const double prestress =
        state.blocks.static_force.size() == state.blocks.foundation_displacement.size()
          ? state.blocks.static_force.dot(state.blocks.foundation_displacement)
          : 0.;
      terms.insert(terms.end(),
                   {{"bedrock_kinetic", c.kinetic},
                    {"bedrock_strain", c.strain},
                    {"bedrock_static_stress", prestress},
                    {"boundary_loss", c.boundary_loss},
                    {"bedrock_damping_loss", c.damping_loss},
                    {"bedrock_integration_loss", c.integration_loss},
                    {"input_work", -c.input_work}});
      if (effects.boundary_springs)
        terms.push_back({"boundary_springs", c.boundary_springs});
      if (effects.bedding_slip)
        terms.insert(terms.end(),
                     {{"bedding_loss", c.bedding_loss},
                      {"bedding_static_stress", c.bedding_static_stress}});
      return terms;
    }
  } // namespace



  std::vector<std::string> EnergyLedger::names() const
  {
    std::vector<std::string> result;
    for (const EnergyTerm &term : collect({}, {}, has_continuum, effects))
      result.push_back(term.name);
    return result;
  }



  const std::vector<double> &EnergyLedger::update(const coupling::CoupledState     &state,
                                                  const continuum::ContinuumEnergy &bedrock)
  {
    const Terms now = collect(state, bedrock, has_continuum, effects);
    if (start.empty())
      {
        double held = 0., moving = 0.;
        for (const EnergyTerm &term : now)
          {
            start.push_back(term.value);
            held += std::abs(term.value);
            if (is_kinetic(term.name))
              moving += term.value; // what moves at the start is in play from then on
          }
        in_play = std::max({min_in_play, fraction_of_held * held, moving});
        terms.assign(now.size(), 0.);
      }
    before        = terms;
    double weight = 0., physical = 0., integration = 0.;
    imbalance = scheme_total = scheme_sum = 0.;
    for (std::size_t i = 0; i < now.size(); ++i)
      {
        terms[i] = now[i].value - start[i];
        imbalance += terms[i];
        if (is_integration(now[i].name))
          integration += terms[i];
        else if (is_of_scheme(now[i].name))
          {
            scheme_total += std::abs(terms[i]);
            scheme_sum += terms[i];
          }
        else if (is_of_weight(now[i].name))
          weight += terms[i];
        else
          physical += std::abs(terms[i]);
      }
    scheme_total += std::abs(integration);
    scheme_sum += integration;
    most_taken = std::max(most_taken, scheme_sum);
    in_play    = std::max(in_play, physical + std::abs(weight));
    largest    = std::max(largest, std::abs(imbalance));
    return terms;
  }



  double EnergyLedger::value(const std::string &name) const
  {
    const std::vector<std::string> all   = names();
    const auto                     found = std::find(all.begin(), all.end(), name);
    return found == all.end() || terms.empty() ? 0. : terms[found - all.begin()];
  }



  std::vector<EnergyTerm> EnergyLedger::largest_changes(const int n) const
  {
    const std::vector<std::string> all = names();
    std::vector<EnergyTerm>        changes;
    for (std::size_t i = 0; i < before.size(); ++i)
      changes.push_back({all[i], terms[i] - before[i]});
    std::stable_sort(changes.begin(), changes.end(), [](const EnergyTerm &a, const EnergyTerm &b) {
      return std::abs(a.value) > std::abs(b.value);
    });
    changes.resize(std::min<std::size_t>(changes.size(), n));
    return changes;
  }



  std::vector<EnergyTerm> EnergyLedger::scheme_terms() const
  {
    const std::vector<std::string> all = names();
    std::vector<EnergyTerm>        result;
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (is_of_scheme(all[i]))
        result.push_back({all[i], terms[i]});
    return result;
  }



  void EnergyLedger::serialize(restart::Archive &archive)
  {
    archive(start, terms, before, in_play, imbalance, scheme_total, scheme_sum, largest);
    archive(most_taken, largest_kinetic);
  }
} // namespace hybrid::output
