// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid
{
  /// Catches Ctrl-C, SIGTERM and SIGHUP (a closed terminal) while it exists, so that the run can
  /// end after a whole step. A second signal ends the program at once; one that was ignored before
  /// (nohup) stays so.
  class Interruption
  {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption &)            = delete;
    Interruption &operator=(const Interruption &) = delete;

    bool is_requested() const;
  };
} // namespace hybrid
