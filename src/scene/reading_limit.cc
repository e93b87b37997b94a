// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/reading_limit.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#ifdef __SANITIZE_ADDRESS__
#  include <dlfcn.h>
#  include <new>
#endif

namespace hybrid::scene
{
  namespace
  {
    const char *const advice =
      "look for a list or loop over too many values such as {1:1e9}, for a macro that calls itself "
      "and for far too small mesh sizes";

    std::string      sentence; ///< made beforehand: a signal handler may not allocate
    struct sigaction earlier_action;
    rlimit           earlier_memory;

    void say_and_end(int)
    {
      const auto written = write(STDERR_FILENO, sentence.data(), sentence.size());
      _exit(written < 0 ? 3 : 2);
    }


    void start_timer(const double seconds)
    {
      itimerval timer        = {};
      timer.it_value.tv_sec  = static_cast<time_t>(seconds);
      timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
      setitimer(ITIMER_PROF, &timer, nullptr);
    }


    /// Address space of the process now [bytes], or 0 where the system does not tell.
    rlim_t address_space()
    {
      rlim_t pages = 0;
      std::ifstream("/proc/self/statm") >> pages;
      return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
    }


#ifdef __SANITIZE_ADDRESS__
    /// True if an allocation would fail for want of address space.
    bool exceeds_limit(const std::size_t size)
    {
      constexpr std::size_t book_keeping = 1000000; // of the allocator, at most [bytes]
      rlimit                limit;
      return size > book_keeping && getrlimit(RLIMIT_AS, &limit) == 0 &&
             limit.rlim_cur != RLIM_INFINITY &&
             address_space() + size + book_keeping > limit.rlim_cur;
    }
#endif


    std::string short_number(const double number)
    {
      std::ostringstream text;
      text << number;
      return text.str();
    }
  } // namespace



  ReadingLimit::ReadingLimit(const std::string &file, const double seconds)
  {
    sentence = "error: " + file + ": gmsh has not come to an end of this file after " +
               short_number(seconds) + " s of computing: " + advice + ".\n";
    struct sigaction action = {};
    action.sa_handler       = say_and_end;
    sigaction(SIGPROF, &action, &earlier_action);
    start_timer(seconds);

    getrlimit(RLIMIT_AS, &earlier_memory);
    const rlim_t now = address_space();
    if (now == 0)
      return;
    rlimit limit   = earlier_memory;
    limit.rlim_cur = std::min(limit.rlim_cur, now + static_cast<rlim_t>(memory * 1e9));
    setrlimit(RLIMIT_AS, &limit);
  }



  ReadingLimit::~ReadingLimit()
  {
    setrlimit(RLIMIT_AS, &earlier_memory);
    start_timer(0.); // stops it
    sigaction(SIGPROF, &earlier_action, nullptr);
  }



  std::string ReadingLimit::memory_sentence()
  {
    return "gmsh needs more than " + short_number(memory) +
           " GB of memory before it has meshed anything: " + advice + ".";
  }

} // namespace hybrid::scene


#ifdef __SANITIZE_ADDRESS__
/// The sanitizer ends the program where an allocation fails; beyond the limit this one throws, as
/// without sanitizer.
void *
operator new(const std::size_t size)
{
  using Allocation                  = void *(*)(std::size_t);
  static const Allocation sanitized = reinterpret_cast<Allocation>(dlsym(RTLD_NEXT, "_Znwm"));
  if (hybrid::scene::exceeds_limit(size))
    throw std::bad_alloc();
  return sanitized(size);
}
#endif
