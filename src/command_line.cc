// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/command_line.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/nearest_name.h>
#include <hybrid/subcommand.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

namespace hybrid
{
  namespace
  {
    constexpr const char *about =
      "hybrid: landslides in earthquakes, finite elements coupled with discontinuous deformation "
      "analysis";

    constexpr const char *examples =
      "Examples:\n"
      "  hybrid --check my.prm\n"
      "  hybrid my.prm -s \"Time/End time=10\" -s \"Output/Directory=output/long\"\n"
      "  hybrid --resume output/long -s \"Time/End time=30\"\n"
      "  hybrid plot output/long\n"
      "\n"
      "Ctrl-C ends a run after the present step with a checkpoint (in the static stage, which has "
      "none,\n"
      "after the present iteration). Exit code 0: done; 1: the run stopped early; 2: a mistake in "
      "the\n"
      "input; 3: another failure; 130: interrupted.\n"
      "Not finished yet: compare, study.\n";

    /// Names of subcommands to come.
    constexpr const char *planned[] = {"compare", "study"};

    /// Flags that say what is done. One command line does one thing.
    struct ActionFlag
    {
      const char *name;
      Action      action;
      const char *help;
    };

    constexpr ActionFlag action_flags[] = {
      {"--check",
       Action::check,
       "read and mesh the scene, print its card and what looks wrong, run nothing"},
      {"--resume",
       Action::resume,
       "go on with a run that was stopped or killed, from its last checkpoint"},
      {"--print-parameters",
       Action::print_parameters,
       "every parameter with default, range, unit and help"},
      {"--version", Action::version, "version, commit, and the libraries it was built with"}};



    std::vector<std::string> option_names(const CLI::App &app)
    {
      std::vector<std::string> names;
      for (const CLI::Option *option : app.get_options())
        for (const std::string &name : option->get_lnames())
          names.push_back("--" + name);
      return names;
    }



    /// "hybrid" or "hybrid plot".
    std::string name_of(const CLI::App &app)
    {
      return app.get_parent() == nullptr ? app.get_name()
                                         : name_of(*app.get_parent()) + " " + app.get_name();
    }



    void refuse_unknown_options(const CLI::App &app, const std::vector<std::string> &words)
    {
      const std::string of = app.get_parent() == nullptr ? "" : " of " + name_of(app);
      for (const std::string &word : words)
        if (!word.empty() && word[0] == '-')
          throw InputError("unknown option '" + word + "'" + of +
                           scene::suggestion(word, option_names(app)) + "; " + name_of(app) +
                           " --help lists the options");
    }



    /// @throws InputError for a word that is an option without its dashes, or meant as an action.
    void refuse_bare_option(const CLI::App &app, const std::string &word)
    {
      if (word.find_first_of("./") != std::string::npos || std::filesystem::exists(word))
        return;
      std::vector<std::string> names;
      for (const Subcommand &subcommand : subcommands())
        names.push_back(subcommand.name);
      for (const std::string &option : option_names(app))
        names.push_back(option.substr(2));
      const std::string meant = scene::nearest_name(word, names);
      if (meant.empty())
        return;
      const bool is_option = app.get_option_no_throw("--" + meant) != nullptr;
      throw InputError("'" + word + "' is no action; did you mean '" + (is_option ? "--" : "") +
                       meant + "'?");
    }



    /// An option without its value, or a flag with one.
    InputError mismatch(const CLI::App &app, const std::vector<std::string> &words)
    {
      for (const std::string &word : words)
        {
          const std::string  name   = word.substr(0, word.find('='));
          const CLI::Option *option = app.get_option_no_throw(name);
          if (option != nullptr && name != word && option->get_items_expected_max() == 0)
            return InputError("'" + name + "' takes no value, but got '" + word + "'");
        }
      const CLI::Option *option = app.get_option_no_throw(words.back());
      return InputError(words.back() + " needs " +
                        (option != nullptr ? option->get_type_name() : "a value") + " after it");
    }



    void declare_options(CLI::App &app, CommandLine &result)
    {
      app.set_help_flag("-h,--help", "this text; after a subcommand: that of the subcommand");
      app.add_option("PARAMS.prm",
                     result.target,
                     "scene to run; with --resume the run's directory");
      app.add_option("-s", result.overrides, "override one parameter (repeatable)")
        ->type_name("\"Section/Name=value\"")
        ->allow_extra_args(false);
      app.add_flag("--force",
                   result.force,
                   "replace the results of an earlier run in the output directory");
      for (const ActionFlag &flag : action_flags)
        app.add_flag(flag.name, flag.help);
      for (CLI::Option *option : app.get_options())
        if (option->get_items_expected_max() == 0)
          option->disable_flag_override();
    }



    /// @p words and @p app must live as long as the parsing.
    void
    declare_subcommands(CLI::App &app, CommandLine &result, const std::vector<std::string> &words)
    {
      for (const Subcommand &subcommand : subcommands())
        {
          CLI::App *of = app.add_subcommand(subcommand.name, subcommand.help);
          of->footer("Examples:\n" + subcommand.examples);
          const auto work = subcommand.declare(*of);
          of->preparse_callback([&, work](std::size_t) {
            if (!app.parse_order().empty())
              throw InputError("'" + subcommand.name + "' stands first: hybrid " + subcommand.name +
                               " ..., not after '" + words[0] + "'");
            result.action     = Action::subcommand;
            result.subcommand = work;
          });
        }
    }



    /// @return the subcommand that was named, or @p app itself.
    const CLI::App &chosen_in(const CLI::App &app)
    {
      return app.get_subcommands().empty() ? app : *app.get_subcommands().front();
    }



    /// @return whether help is asked for. @throws InputError for what CLI11 refuses.
    bool parse(CLI::App &app, const std::vector<std::string> &words)
    {
      try
        {
          app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        }
      catch (const CLI::CallForHelp &)
        {
          return true;
        }
      catch (const CLI::ArgumentMismatch &)
        {
          throw mismatch(chosen_in(app), words);
        }
      catch (const CLI::ParseError &error)
        {
          refuse_unknown_options(chosen_in(app), chosen_in(app).remaining());
          const std::string name = name_of(chosen_in(app));
          throw InputError(name + ": " + error.what() + "; see " + name + " --help");
        }
      refuse_unknown_options(app, app.remaining());
      refuse_unknown_options(chosen_in(app), chosen_in(app).remaining());
      return false;
    }



    /// The words of hybrid without a subcommand.
    void check_words(const CLI::App &app, CommandLine &result)
    {
      refuse_unknown_options(app, {result.target});
      for (const CLI::Option *option : app.parse_order())
        for (const ActionFlag &flag : action_flags)
          if (option->check_name(flag.name))
            {
              if (result.action != Action::run && result.action != flag.action)
                throw InputError(std::string("'") + flag.name +
                                 "' cannot be combined with another action; give one of "
                                 "--check, --resume, --print-parameters and --version");
              result.action = flag.action;
            }
      if (result.action == Action::print_parameters || result.action == Action::version)
        return;
      for (const std::string &text : result.overrides)
        if (text.find('=') == std::string::npos || text[0] == '=')
          throw InputError("-s needs \"Section/Name=value\" after it, not '" + text + "'");
      const std::vector<std::string> more = app.remaining();
      refuse_bare_option(app, result.target);
      if (!more.empty())
        throw InputError("one parameter file or directory is expected, but '" + more[0] +
                         "' was given too");
      if (result.target.empty())
        throw InputError("no parameter file or directory is named; see hybrid --help");
    }
  } // namespace



  CommandLine parse_command_line(const int argc, const char *const *argv)
  {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty())
      words = {"--help"};
    if (words[0] == "help") // hybrid help plot: hybrid plot --help
      {
        std::rotate(words.begin(), words.begin() + 1, words.end());
        words.back() = "--help";
      }
    if (words.size() == 1 && words[0] == "version")
      words[0] = "--version";
    for (const std::string name : planned)
      if (words[0] == name)
        throw InputError("'" + name + "' is not finished in this version");

    CommandLine result;
    CLI::App    app(about, "hybrid");
    app.allow_extras()->require_subcommand(0, 1);
    app.get_formatter()->column_width(34);
    app.get_formatter()->label("TEXT", "");
    app.get_formatter()->label("REQUIRED", "");
    app.footer(examples);
    declare_options(app, result);
    declare_subcommands(app, result, words);
    if (parse(app, words))
      {
        result.action = Action::help;
        result.help   = app.help();
        return result;
      }
    if (result.action != Action::subcommand)
      check_words(app, result);
    else if (const auto more = chosen_in(app).remaining(); !more.empty())
      throw InputError("'" + more[0] + "' is one word too many; see " + name_of(chosen_in(app)) +
                       " --help");
    return result;
  }
} // namespace hybrid
