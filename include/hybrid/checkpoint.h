// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <cstdint>
#include <functional>
#include <string>

namespace hybrid
{
  /// The checkpoint of the run in @p directory.
  std::string checkpoint_file(const std::string &directory);


  /// When a checkpoint is due: after so many steps of the whole run, or so much wall time, but so
  /// much later that writing takes at most a twentieth of the time.
  class CheckpointSchedule
  {
  public:
    /// @param wall_clock in seconds from any origin; the steady clock if empty.
    explicit CheckpointSchedule(const scene::CheckpointParameters &parameters,
                                std::function<double()>            wall_clock = {});

    /// @param steps accepted since the start of the run.
    bool is_due(long steps) const;

    /// A checkpoint begins to be written.
    void begins();

    /// It has been written.
    void written();

  private:
    const scene::CheckpointParameters parameters;
    const std::function<double()>     clock;
    double                            last;        ///< wall clock at the last checkpoint [s]
    double                            began  = 0.; ///< the same where its writing began [s]
    double                            taking = 0.; ///< what writing it took [s]
  };


  /// Number that tells scenes with the same parameters apart whose files have other content.
  std::uint64_t fingerprint(const scene::SectionMesh &mesh, const scene::GroundMotion &motion);


  /**
   * What may differ between the parameters of a run and those it is resumed with: the end time, and
   * the sections Output, Checkpoint and Parallel.
   * @param before, after complete parameter files (SceneParameters::used_prm).
   * @throws InputError naming the first other difference.
   */
  void check_same_scene(const std::string &before, const std::string &after);
} // namespace hybrid
