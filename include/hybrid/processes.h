// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/first_process_failed.h>

#include <mpi.h>

#include <functional>

namespace hybrid
{
  /**
   * The processes that mpirun has started, or this one alone. All read the scene; the first one
   * writes, and speaks.
   */
  class Processes
  {
  public:
    Processes() = default;
    ~Processes();
    Processes(const Processes &)            = delete;
    Processes &operator=(const Processes &) = delete;

    /// Start MPI, unless the caller of main() has.
    void start(int &argc, char **&argv);

    /// Also before start().
    bool is_first() const;

    int count() const
    {
      return size;
    }

    /// Those of them that run on this one's machine; all call it.
    int on_this_machine() const;

    /// Let the first one do @p work alone. Where it throws, the others throw FirstProcessFailed.
    void on_first(const std::function<void()> &work) const;

    /// The first one's @p value on all.
    double from_first(double value) const;

    /// The others sleep until the first one calls release(). @return the exit code it gives.
    int wait_for_first() const;

    /// Let the others end; nothing if they do not wait.
    void release(int exit_code);

    /// From now on only the first one computes, and the others wait.
    void compute_alone()
    {
      others_wait = size > 1;
    }

    bool is_alone() const
    {
      return others_wait;
    }

    /// All run together: what stops one has to stop all.
    void set_together(const bool now)
    {
      together = now && are_there_others();
    }

    bool are_together() const
    {
      return together;
    }

    /// This one has failed: end all if they run together.
    void end_all(int exit_code) const;

  private:
    /// Others that take part in what this one does now.
    bool are_there_others() const
    {
      return size > 1 && !others_wait;
    }

    bool is_owner    = false;
    bool others_wait = false;
    bool together    = false;
    int  size        = 1;
  };
} // namespace hybrid
