// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>

namespace hybrid
{
  /// A file of a run cannot be written: full disk, vanished directory, no permission. What was
  /// written before is as it was.
  class WriteError : public InputError
  {
  public:
    using InputError::InputError;
  };
} // namespace hybrid
