// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/log.h>
#include <hybrid/output/progress.h>
#include <hybrid/processes.h>

#include <iostream>

namespace hybrid
{
  /// What a process says: nothing, unless it is the first.
  struct Voice
  {
    explicit Voice(const Processes &processes)
      : stream(processes.is_first() ? std::cout.rdbuf() : nullptr)
      , log(stream, processes.is_first() && output::standard_output_is_terminal())
    {}

    std::ostream stream;
    output::Log  log;
  };
} // namespace hybrid
