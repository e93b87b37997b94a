// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/tool.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <spawn.h>
#include <sys/wait.h>

extern char **environ;

namespace hybrid
{
  namespace
  {
    namespace fs = std::filesystem;

    fs::path this_program()
    {
      std::error_code error;
      return fs::read_symlink("/proc/self/exe", error);
    }



    std::string find_script()
    {
      std::error_code error;
      const fs::path installed = this_program().parent_path() / ".." / "share/hybrid/tools/tool.py";
      if (fs::exists(installed, error))
        return installed.lexically_normal().string();
      const fs::path built_from = fs::path(HYBRID_TOOLS) / "tool.py";
      if (fs::exists(built_from, error))
        return built_from.string();
      throw InputError("the script tool.py was found neither beside the program "
                       "(share/hybrid/tools) nor in '" HYBRID_TOOLS "'");
    }



    /// The surroundings of this process, but for what makes it one of those that mpirun started:
    /// a run that a tool starts is alone.
    std::vector<char *> environment_of_tools()
    {
      const bool by_mpirun = std::getenv("OMPI_COMM_WORLD_RANK") != nullptr ||
                             std::getenv("PMIX_RANK") != nullptr ||
                             std::getenv("PMI_RANK") != nullptr;
      std::vector<char *> result;
      for (char **variable = environ; *variable != nullptr; ++variable)
        {
          const std::string text    = *variable;
          const auto        is_like = [&](const char *start) { return text.rfind(start, 0) == 0; };
          if (!by_mpirun || is_like("OMPI_ALLOW_RUN_AS_ROOT") ||
              !(is_like("OMPI_") || is_like("PMIX_") || is_like("PMI_")))
            result.push_back(*variable);
        }
      result.push_back(nullptr);
      return result;
    }



    volatile pid_t tool_process = 0;

    extern "C" void end_tool(const int signal)
    {
      kill(tool_process, signal);
    }



    /// Run a program without a shell. @return its exit code.
    int run(std::vector<std::string> words)
    {
      std::vector<char *> arguments;
      for (std::string &word : words)
        arguments.push_back(word.data());
      arguments.push_back(nullptr);
      pid_t               process     = 0;
      std::vector<char *> environment = environment_of_tools();
      if (posix_spawn(
            &process, arguments[0], nullptr, nullptr, arguments.data(), environment.data()) != 0)
        throw InputError("cannot start '" + words[0] +
                         "', the Python that the program was built with");
      std::signal(SIGINT, SIG_IGN); // Ctrl-C reaches the tool too, which ends in its own way
      tool_process = process;
      std::signal(SIGTERM, end_tool); // these do not
      std::signal(SIGHUP, end_tool);
      int status = 0;
      while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
          throw InputError("lost sight of '" + words[0] + "' while it was at work");
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
  } // namespace



  const std::vector<Tool> &tools()
  {
    static const std::vector<Tool> all = {
      {"plot", "pictures of runs as png, pdf or svg, in DIRECTORY/figures"},
      {"compare", "runs side by side: table, verdict, figures"},
      {"animate", "a film of a run (mp4 or gif): blocks where they move, joints that fail"},
      {"report", "a page (HTML) that says what happened in a run, or in several"},
      {"accuracy", "how far a run is off, by coarser ones: errors of its mesh and of its step"},
      {"study", "what accuracy costs in time: a scene with varied parameters"},
      {"amplification",
       "how much lines of a run (bedding planes, the ground) shake over an outcrop"},
      {"new", "a slope that runs, from polylines of ground, slip and planes"},
      {"section", "a picture of a scene's section, before it is run"},
      {"fos",
       "factor of safety by strength reduction, yield acceleration, Newmark's displacements"},
      {"condition", "what a motion leaves at first, and after it has come until little is added"},
      {"benchmark",
       "how fast the program is: scenes that are known to be hard, timed and compared"},
    };
    return all;
  }



  int run_tool(const std::string &name, const std::vector<std::string> &words)
  {
    setenv("HYBRID_PROGRAM", this_program().c_str(), 1); // tools that run scenes ask for it
    std::vector<std::string> all = {HYBRID_PYTHON, find_script(), name};
    all.insert(all.end(), words.begin(), words.end());
    return run(all);
  }
} // namespace hybrid
