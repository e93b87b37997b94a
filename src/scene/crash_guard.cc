// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/crash_guard.h>
#include <hybrid/scene/reading_limit.h>

#include <csignal>
#include <exception>
#include <new>
#include <unistd.h>
#include <utility>

namespace hybrid::scene
{
  namespace
  {
    constexpr int crashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE};

    // Made beforehand: a signal handler may not allocate.
    std::string sentence;
    std::string memory_sentence; ///< where memory was the reason

    std::string words_of_complete_run; ///< empty: a crash is an error

    std::vector<std::string> to_delete;

    struct sigaction earlier[4]; ///< handlers to be put back

    std::terminate_handler earlier_end = nullptr;

    void say_and_end(const std::string &text)
    {
      for (const std::string &path : to_delete)
        if (unlink(path.c_str()) != 0)
          rmdir(path.c_str());
      const auto written = write(STDERR_FILENO, text.data(), text.size());
      if (written < 0)
        _exit(3);
      _exit(words_of_complete_run.empty() ? 2 : 0);
    }


    void end_crash(int)
    {
      say_and_end(sentence);
    }


    /// An exception that nobody can catch.
    void end_exception()
    {
      try
        {
          if (std::current_exception() != nullptr)
            std::rethrow_exception(std::current_exception());
        }
      catch (const std::bad_alloc &)
        {
          say_and_end(memory_sentence);
        }
      catch (...)
        {}
      say_and_end(sentence);
    }
  } // namespace



  CrashGuard::CrashGuard(const std::string &file_name)
    : file(file_name)
  {
    suspect("look for curve loops that do not close, for curves that cross or lie within a "
            "recombined surface (divide the surface along them) and for malformed lines");
    memory_sentence         = words_of_complete_run.empty()
                                ? "error: " + file + ": " + ReadingLimit::memory_sentence() + "\n"
                                : sentence;
    struct sigaction action = {};
    action.sa_handler       = end_crash;
    for (int i = 0; i < 4; ++i)
      sigaction(crashes[i], &action, &earlier[i]);
    earlier_end = std::set_terminate(end_exception);
  }



  void CrashGuard::delete_at_crash(std::vector<std::string> paths)
  {
    to_delete = std::move(paths);
  }



  void CrashGuard::spoils_nothing(std::string words)
  {
    words_of_complete_run = std::move(words);
  }



  void CrashGuard::suspect(const std::string &what)
  {
    sentence = words_of_complete_run.empty()
                 ? "error: " + file + ": gmsh crashes on this file: " + what + ".\n"
                 : words_of_complete_run + file + "\n";
  }



  CrashGuard::~CrashGuard()
  {
    for (int i = 0; i < 4; ++i)
      sigaction(crashes[i], &earlier[i], nullptr);
    std::set_terminate(earlier_end);
  }
} // namespace hybrid::scene
