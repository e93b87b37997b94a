// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  struct InputMotion;


  /// Where a motion can come from: a value of Motion/Type. To add one: a file that makes it, and a
  /// line in motion_sources().
  struct MotionSource
  {
    /// Fill the motion and what is to be said about it. @param time_step dt of the run [s].
    /// @throws InputError.
    using Make = void (*)(const MotionParameters &parameters, double time_step, InputMotion &input);

    /// @throws InputError of @p table if the parameters do not go together.
    using Check = void (*)(const MotionParameters &parameters, const ParameterTable &table);

    std::string name; ///< of Motion/Type
    Make        make;
    Check       check        = nullptr; ///< nullptr: nothing to check
    std::string own_peak     = "";      ///< what its peak is, in words; "": it has 1 m/s2
    bool        reads_record = false;   ///< Motion/File
  };


  /// All of them, in the order of the documentation.
  const std::vector<MotionSource> &motion_sources();


  /// That of @p name, or nullptr.
  const MotionSource *find_motion_source(const std::string               &name,
                                         const std::vector<MotionSource> &sources);
} // namespace hybrid::scene
