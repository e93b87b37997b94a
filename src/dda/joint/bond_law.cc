// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/belt_bond.h>
#include <hybrid/dda/joint/bond_law.h>
#include <hybrid/dda/joint/rate_belt.h>
#include <hybrid/dda/joint/rock_bond.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/option_registry.h>

namespace hybrid::dda
{
  const std::vector<BondLaw> &bond_laws()
  {
    static const std::vector<BondLaw> laws{rock_bond(), belt_bond(), rate_belt()};
    return laws;
  }



  BondLaws
  choose_bonds(const std::string &body, const std::string &belt, const std::vector<BondLaw> &laws)
  {
    const auto find = [&](const std::string &name) {
      const BondLaw *law = scene::find_option(name, laws);
      if (law == nullptr)
        throw InputError("there is no law of joints '" + name + "': it must be " +
                         scene::names_in_words(laws, [](const BondLaw &) { return true; }));
      return *law;
    };
    return {find(body), find(belt)};
  }
} // namespace hybrid::dda
