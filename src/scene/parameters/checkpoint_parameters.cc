// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/checkpoint_parameters.h>
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  void declare(ParameterTable &table, CheckpointParameters &checkpoint)
  {
    ParameterSection section(table, {"Checkpoint"});
    section.integer(
      "Step interval",
      checkpoint.step_interval,
      {0, 1000000000},
      "Steps between checkpoints, from which hybrid --resume goes on; 0: none by steps. "
      "Results do not depend on it.");
    section.number(
      "Wall interval",
      checkpoint.wall_interval,
      "s",
      ParameterRange::at_least(0.),
      "Wall time between checkpoints, longer where writing would take more than a twentieth of the "
      "time; 0: none by time. With both intervals 0 there are no checkpoints, but Ctrl-C still "
      "writes one.");
  }
} // namespace hybrid::scene
