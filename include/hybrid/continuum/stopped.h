// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

namespace hybrid::continuum
{
  /// Who watches has ended a long search within a step (Continuum::watch_search()); the state is
  /// that of before the step.
  class Stopped : public std::exception
  {
  public:
    const char *what() const noexcept override
    {
      return "stopped while the stiffness of the surface was found";
    }
  };
} // namespace hybrid::continuum
