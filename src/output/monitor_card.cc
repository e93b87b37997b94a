// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/monitor_card.h>

namespace hybrid::output
{
  namespace
  {
    constexpr std::size_t most_names = 12;



    std::string list(const std::vector<std::string> &names)
    {
      std::string text;
      for (std::size_t k = 0; k < names.size() && k < most_names; ++k)
        text += (k > 0 ? ", " : "") + names[k];
      if (names.size() > most_names)
        text += " and " + std::to_string(names.size() - most_names) + " more";
      return text;
    }
  } // namespace



  std::string describe_monitors(const std::vector<scene::Monitor> &monitors,
                                const std::vector<int>            &blocks,
                                const dda::Model                  &model)
  {
    if (model.n_mass() == 0)
      return "";
    std::vector<std::string> mass, ground;
    for (std::size_t m = 0; m < monitors.size(); ++m)
      {
        const bool in_mass = blocks[m] >= 0 && !model.is_bedrock(blocks[m]);
        (in_mass ? mass : ground).push_back(monitors[m].name);
      }
    std::string text;
    if (!mass.empty())
      text = "Monitors   of the mass: " + list(mass);
    if (!ground.empty())
      text += (text.empty() ? "Monitors   " : "; ") + ("of the ground: " + list(ground));
    return text;
  }
} // namespace hybrid::output
