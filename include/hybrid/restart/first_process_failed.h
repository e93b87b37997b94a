// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid
{
  /// What the first process has failed at and told; the others end with it, in silence.
  struct FirstProcessFailed
  {
    static constexpr int of_writing = 3; ///< the code of a file that cannot be written

    int exit_code;
  };
} // namespace hybrid
