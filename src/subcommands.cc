// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/plot_command.h>
#include <hybrid/subcommand.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace hybrid
{
  namespace
  {
    std::function<int()> plot(CLI::App &app)
    {
      const auto directory = std::make_shared<std::string>();
      app.add_option("DIRECTORY", *directory, "output directory of a run")->required();
      return [directory] { return output::plot(*directory); };
    }
  } // namespace



  const std::vector<Subcommand> &subcommands()
  {
    static const std::vector<Subcommand> all = {
      {"plot",
       "all pictures of a run, in DIRECTORY/figures",
       "  hybrid plot output/badong\n",
       plot},
    };
    return all;
  }
} // namespace hybrid
