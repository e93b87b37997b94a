// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/plot_command.h>
#include <hybrid/scene/input_error.h>

#include <cerrno>
#include <filesystem>

#include <spawn.h>
#include <sys/wait.h>

extern char **environ;

namespace hybrid::output
{
  namespace
  {
    /// plot_run.py beside an installed binary, else the one of the source tree.
    std::string find_script()
    {
      namespace fs = std::filesystem;
      std::error_code error;
      const fs::path  binary = fs::read_symlink("/proc/self/exe", error);
      if (!error)
        {
          const fs::path installed = binary.parent_path() / ".." / "share/hybrid/plot/plot_run.py";
          if (fs::exists(installed, error))
            return installed.lexically_normal().string();
        }
      if (fs::exists(HYBRID_PLOT_SCRIPT, error))
        return HYBRID_PLOT_SCRIPT;
      throw InputError(
        "the script plot_run.py was found neither beside the program (share/hybrid/plot) "
        "nor at '" HYBRID_PLOT_SCRIPT "'.");
    }


    /// Run a program without a shell. @return its exit code.
    int run(std::string program, std::string script, std::string argument)
    {
      char *arguments[] = {program.data(), script.data(), argument.data(), nullptr};
      pid_t process     = 0;
      if (posix_spawn(&process, program.c_str(), nullptr, nullptr, arguments, environ) != 0)
        throw InputError("cannot start '" + program +
                         "', the Python that the program was built with.");
      int status = 0;
      while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
          throw InputError("lost sight of '" + program + "' while it was drawing.");
      return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    }
  } // namespace



  int plot(const std::string &directory)
  {
    if (!std::filesystem::is_directory(directory))
      throw InputError("'" + directory +
                       "' is not a directory; give the output directory of a run.");
    if (!std::filesystem::exists(std::filesystem::path(directory) / "run.h5"))
      throw InputError("'" + directory + "' holds no run.h5; give the output directory of a run.");
    return run(HYBRID_PYTHON, find_script(), directory);
  }
} // namespace hybrid::output
