// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/crash_guard.h>

#include <csignal>
#include <exception>
#include <unistd.h>

namespace hybrid::scene
{
  namespace
  {
    constexpr int crashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE};

    std::string      sentence;   ///< made beforehand: a signal handler may not allocate
    struct sigaction earlier[4]; ///< handlers to be put back

    std::terminate_handler earlier_end = nullptr;

    void say_and_end(int)
    {
      const auto written = write(STDERR_FILENO, sentence.data(), sentence.size());
      _exit(written < 0 ? 3 : 2);
    }
  } // namespace



  CrashGuard::CrashGuard(const std::string &file)
  {
    sentence = "error: " + file +
               ": gmsh crashes on this file: look for curve loops that do not close and for "
               "malformed lines.\n";
    struct sigaction action = {};
    action.sa_handler       = say_and_end;
    for (int i = 0; i < 4; ++i)
      sigaction(crashes[i], &action, &earlier[i]);
    earlier_end = std::set_terminate([]() { say_and_end(0); });
  }



  CrashGuard::~CrashGuard()
  {
    for (int i = 0; i < 4; ++i)
      sigaction(crashes[i], &earlier[i], nullptr);
    std::set_terminate(earlier_end);
  }
} // namespace hybrid::scene
