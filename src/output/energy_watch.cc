// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/energy_watch.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::output
{
  namespace
  {
    /// What the filters of velocity and acceleration may give back of what they have on loan, of
    /// the energy in play [-].
    constexpr double most_on_loan = 0.05;



    std::string number(const double value)
    {
      std::ostringstream text;
      text.precision(3);
      text << value;
      return text.str();
    }



    std::string list(const std::vector<EnergyTerm> &terms)
    {
      std::string text;
      for (const EnergyTerm &term : terms)
        text += (text.empty() ? "" : ", ") + term.name + " " + number(term.value);
      return text + " J/m";
    }



    /// What is wrong, in a few words.
    const char *fault(const EnergyLedger &ledger)
    {
      return ledger.given_by_scheme() > ledger.residual() ? "the time integration gives energy"
                                                          : "the energy audit does not close";
    }



    /// What may help. Springs that give way to others under load give what they held, at any step.
    const char *advice(const EnergyLedger &ledger)
    {
      double given = 0., by_springs = 0.;
      for (const EnergyTerm &term : ledger.scheme_terms())
        {
          given += std::max(-term.value, 0.);
          by_springs += term.name == "spring_replacement_loss" ? std::max(-term.value, 0.) : 0.;
        }
      return ledger.given_by_scheme() > ledger.residual() && by_springs > 0.5 * given
               ? ", contacts give way to others under load where blocks are soft for their weight: "
                 "a stiffer Young modulus helps, a smaller step does not"
               : ", a smaller Time/Time step may do";
    }



    std::string finding(const EnergyLedger &ledger)
    {
      const std::string in_play = " % of the " + number(ledger.exchanged()) + " J/m in play";
      if (ledger.given_by_scheme() > ledger.residual())
        return number(100. * ledger.given_by_scheme()) + in_play + ", " +
               list(ledger.scheme_terms());
      return number(std::abs(ledger.sum())) + " J/m were " +
             (ledger.sum() > 0. ? "created" : "lost") + ", " + number(100. * ledger.residual()) +
             in_play +
             "; largest changes since the audit before: " + list(ledger.largest_changes(3));
    }
  } // namespace



  bool EnergyWatch::passes(const EnergyLedger &ledger, const double fraction)
  {
    return fraction > 0. && std::max(ledger.residual(), ledger.given_by_scheme()) > fraction;
  }



  std::string EnergyWatch::look(const EnergyLedger &ledger, const double time)
  {
    if (is_over(ledger))
      return "stopped at t = " + number(time) + " s, because " + fault(ledger) + ": " +
             finding(ledger) + "; the results are wrong from about here on, allowed are " +
             number(100. * limit) + " % (Output/Energy limit)" + advice(ledger);
    if (!has_told_gain && warning > 0. && ledger.given_back() > most_on_loan)
      {
        has_told_gain = true;
        return "the time integration gives energy until t = " + number(time) +
               " s: " + number(100. * ledger.given_back()) + " % of the " +
               number(ledger.exchanged()) + " J/m in play since it had taken most, " +
               list(ledger.scheme_terms()) +
               "; what moves then is too fast, a smaller Time/Time step may do";
      }
    if (has_warned || !passes(ledger, warning))
      return "";
    has_warned = true;
    return fault(ledger) + (" at t = " + number(time)) + " s: " + finding(ledger) +
           "; warned from " + number(100. * warning) + " % on (Output/Energy warning)" +
           advice(ledger);
  }



  std::string EnergyWatch::of_scheme(const EnergyLedger &ledger, const double settling) const
  {
    if (!(warning > 0.) || ledger.scheme_fraction() <= warning || ledger.exchanged() <= settling)
      return "";
    const bool              gave = ledger.given_by_scheme() > 0.;
    std::vector<EnergyTerm> terms;
    for (const EnergyTerm &term : ledger.scheme_terms())
      if (term.value != 0.)
        terms.push_back(term);
    const bool hits = !gave && std::any_of(terms.begin(), terms.end(), [](const EnergyTerm &term) {
      return term.name == "blocks_integration_loss";
    });
    return std::string("the time integration ") + (gave ? "gave " : "took ") +
           number(100. * ledger.scheme_fraction()) + " % of the " + number(ledger.exchanged()) +
           " J/m in play (" + list(terms) + "): " +
           (hits ? "what blocks lose where they hit each other, if they do, is part of it, the rest"
                 : "this part") +
           " depends on Time/Time step, compare with half the step";
  }



  void EnergyWatch::serialize(restart::Archive &archive)
  {
    archive(has_warned, has_told_gain);
  }
} // namespace hybrid::output
