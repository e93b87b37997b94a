// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/command_line.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/nearest_name.h>
#include <hybrid/tool.h>

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
      "hybrid NAME --help tells what a tool takes.\n";

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
       "every parameter with default, range, unit and help; of a scene, if one is named, its values"},
      {"--version", Action::version, "version, commit, and the libraries it was built with"}};



    std::vector<std::string> option_names(const CLI::App &app)
    {
      std::vector<std::string> names;
      for (const CLI::Option *option : app.get_options())
        for (const std::string &name : option->get_lnames())
          names.push_back("--" + name);
      return names;
    }



    void refuse_unknown_options(const CLI::App &app, const std::vector<std::string> &words)
    {
      for (const std::string &word : words)
        if (!word.empty() && word[0] == '-')
          throw InputError("unknown option '" + word + "'" +
                           scene::suggestion(word, option_names(app)) +
                           "; hybrid --help lists the options");
    }



    /// @throws InputError for a word that is an option without its dashes, or meant as an action.
    void refuse_bare_option(const CLI::App &app, const std::string &word)
    {
      if (word.find_first_of("./") != std::string::npos || std::filesystem::exists(word))
        return;
      std::vector<std::string> names;
      for (const Tool &tool : tools())
        names.push_back(tool.name);
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



    /// For the help alone: a tool reads its words itself.
    void declare_tools(CLI::App &app)
    {
      for (const Tool &tool : tools())
        app.add_subcommand(tool.name, tool.help)->preparse_callback([&](std::size_t) {
          throw InputError("'" + tool.name + "' stands first: hybrid " + tool.name + " ...");
        });
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
          throw mismatch(app, words);
        }
      catch (const CLI::ParseError &error)
        {
          refuse_unknown_options(app, app.remaining());
          throw InputError(std::string("hybrid: ") + error.what() + "; see hybrid --help");
        }
      refuse_unknown_options(app, app.remaining());
      return false;
    }



    /// What CLI11 cannot know.
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
      const bool needs_no_target =
        result.action == Action::version ||
        (result.action == Action::print_parameters && result.target.empty());
      if (needs_no_target)
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

    CommandLine result;
    for (const Tool &tool : tools())
      if (words[0] == tool.name)
        {
          result.action = Action::tool;
          result.tool   = tool.name;
          result.words.assign(words.begin() + 1, words.end());
          return result;
        }
    CLI::App app(about, "hybrid");
    app.allow_extras()->require_subcommand(0, 1);
    app.get_formatter()->column_width(34);
    app.get_formatter()->label("TEXT", "");
    app.get_formatter()->label("REQUIRED", "");
    app.footer(examples);
    declare_options(app, result);
    declare_tools(app);
    if (parse(app, words))
      {
        result.action = Action::help;
        result.help   = app.help();
        return result;
      }
    check_words(app, result);
    return result;
  }
} // namespace hybrid
