// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::scene
{
  /// Section "Checkpoint": when a running scene is saved, so that it can be resumed.
  struct CheckpointParameters
  {
    int    step_interval = 0;   ///< accepted steps between checkpoints; 0: none by steps
    double wall_interval = 60.; ///< wall time between checkpoints [s]; 0: none by time

    bool is_on() const
    {
      return step_interval > 0 || wall_interval > 0.;
    }
  };
} // namespace hybrid::scene
