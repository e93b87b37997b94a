// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/command_line.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/nearest_name.h>

namespace hybrid
{
  std::string usage()
  {
    return "hybrid: landslides in earthquakes, finite elements coupled with discontinuous deformation analysis\n"
           "\n"
           "  hybrid PARAMS.prm              run a scene\n"
           "  hybrid --check PARAMS.prm      read and mesh it, print its card and what looks wrong, run nothing\n"
           "  hybrid --print-parameters      every parameter with default, range, unit and help\n"
           "  hybrid --resume DIRECTORY      go on with a run that was stopped or killed, from its last checkpoint\n"
           "  hybrid plot DIRECTORY          all pictures of a run, in DIRECTORY/figures\n"
           "  hybrid --version               version, commit, and the libraries it was built with\n"
           "  hybrid --help                  this text; also hybrid help\n"
           "  -s \"Section/Name=value\"        override one parameter (repeatable)\n"
           "  --force                        replace the results of an earlier run in the output directory\n"
           "\n"
           "Ctrl-C ends a run after the present step with a checkpoint (in the static stage, which has none,\n"
           "after the present iteration). Exit code 0: done; 1: the run stopped early; 2: a mistake in the\n"
           "input; 3: another failure; 130: interrupted.\n"
           "Not finished yet: compare, study.\n";
  }



  namespace
  {
    /// One command line does one thing.
    void choose(const Action action, const std::string &word, Action &chosen)
    {
      if (chosen != Action::run && chosen != action)
        throw InputError("'" + word +
                         "' cannot be combined with another action; give one of "
                         "--check, --resume, --print-parameters, --version and plot");
      chosen = action;
    }



    const std::vector<std::string> options =
      {"--check", "--resume", "--force", "--help", "--print-parameters", "--version"};



    InputError unknown_option(const std::string &word)
    {
      return InputError("unknown option '" + word + "'" + scene::suggestion(word, options) +
                        "; hybrid --help lists the options");
    }



    /// @throws InputError for a word that is an option without its dashes, or meant as an action.
    void refuse_bare_option(const std::string &word)
    {
      std::vector<std::string> names{"plot"};
      for (const std::string &option : options)
        names.push_back(option.substr(2));
      const bool        is_file = word.find_first_of("./") != std::string::npos;
      const std::string meant   = is_file ? "" : scene::nearest_name(word, names);
      if (!meant.empty())
        throw InputError("'" + word + "' is no action; did you mean '" +
                         (meant == "plot" ? "" : "--") + meant + "'?");
    }
  } // namespace



  CommandLine parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine              result;
    std::vector<std::string> words(argv + 1, argv + argc), targets;
    result.action = Action::run;
    for (std::size_t i = 0; i < words.size(); ++i)
      {
        const std::string &word = words[i];
        if (word == "-h" || word == "--help")
          return {};
        if (words.size() == 1 && word == "help")
          return {};
        if (word == "-s")
          {
            if (++i == words.size() || words[i].find('=') == std::string::npos)
              throw InputError("-s needs \"Section/Name=value\" after it" +
                               (i < words.size() ? ", not '" + words[i] + "'" : std::string()));
            result.overrides.push_back(words[i]);
          }
        else if (word == "--check")
          choose(Action::check, word, result.action);
        else if (word == "--resume")
          choose(Action::resume, word, result.action);
        else if (word == "--force")
          result.force = true;
        else if (word == "--print-parameters")
          choose(Action::print_parameters, word, result.action);
        else if (word == "--version" || (words.size() == 1 && word == "version"))
          choose(Action::version, word, result.action);
        else if (word == "plot" && targets.empty() && result.action == Action::run)
          result.action = Action::plot;
        else if (word == "compare" || word == "study")
          throw InputError("'" + word + "' is not finished in this version");
        else if (!word.empty() && word[0] == '-')
          throw unknown_option(word);
        else
          targets.push_back(word);
      }
    if (words.empty())
      return {};
    if (result.action == Action::print_parameters || result.action == Action::version)
      return result;
    if (targets.size() > 1)
      refuse_bare_option(targets[0]);
    if (targets.size() != 1)
      throw InputError(targets.empty()
                         ? "no parameter file or directory is named; see hybrid --help"
                         : "one parameter file or directory is expected, but '" + targets[1] +
                             "' was given too");
    result.target = targets[0];
    return result;
  }
} // namespace hybrid
