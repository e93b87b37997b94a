// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/energy_ledger.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    using Terms = std::vector<std::pair<std::string, double>>;

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
                                       {"blocks_integration_loss", b.integration_loss + b.newmark},
                                       {"contact_switch_loss", b.switch_loss}};
      if (effects.edge_loads)
        terms.push_back({"edge_load_work", -b.edge_load_work});
      if (!has_continuum)
        {
          terms.push_back({"base_work", -b.base_work});
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
        state.blocks.static_force.size() == state.blocks.base_displacement.size()
          ? state.blocks.static_force.dot(state.blocks.base_displacement)
          : 0.;
      terms.insert(terms.end(),
                   {{"bedrock_kinetic", c.kinetic},
                    {"bedrock_strain", c.strain},
                    {"bedrock_static_stress", prestress},
                    {"boundary_loss", c.boundary_loss},
                    {"bedrock_damping_loss", c.damping_loss},
                    {"bedrock_integration_loss", c.integration_loss + c.newmark},
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
    for (const auto &term : collect({}, {}, has_continuum, effects))
      result.push_back(term.first);
    return result;
  }



  const std::vector<double> &EnergyLedger::update(const coupling::CoupledState     &state,
                                                  const continuum::ContinuumEnergy &bedrock)
  {
    const Terms now = collect(state, bedrock, has_continuum, effects);
    if (start.empty())
      for (const auto &term : now)
        {
          start.push_back(term.second);
          if (term.first == "blocks_kinetic" || term.first == "bedrock_kinetic")
            exchanged += term.second; // what moves at the start is in play from then on
        }
    terms.resize(now.size());
    double sum = 0., total = 0.;
    for (std::size_t i = 0; i < now.size(); ++i)
      {
        terms[i] = now[i].second - start[i];
        sum += terms[i];
        total += std::abs(terms[i]);
      }
    exchanged = std::max(exchanged, total);
    imbalance = std::abs(sum) / exchanged;
    largest   = std::max(largest, imbalance);
    return terms;
  }



  void EnergyLedger::serialize(restart::Archive &archive)
  {
    archive(start, terms, exchanged, imbalance, largest);
  }
} // namespace hybrid::output
