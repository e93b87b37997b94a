// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/interruption.h>

#include <csignal>

namespace hybrid
{
  namespace
  {
    volatile std::sig_atomic_t requested = 0;

    constexpr int caught[] = {SIGINT, SIGTERM, SIGHUP};

    extern "C" void note_signal(const int number)
    {
      requested = 1;
      std::signal(number, SIG_DFL);
    }
  } // namespace



  Interruption::Interruption()
  {
    requested = 0;
    for (const int number : caught)
      if (std::signal(number, note_signal) == SIG_IGN)
        std::signal(number, SIG_IGN);
  }



  Interruption::~Interruption()
  {
    for (const int number : caught)
      if (std::signal(number, SIG_DFL) == SIG_IGN)
        std::signal(number, SIG_IGN);
  }



  bool Interruption::is_requested() const
  {
    return requested != 0;
  }
} // namespace hybrid
