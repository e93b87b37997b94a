// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/coupling/foundation.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/output/log.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <memory>
#include <mpi.h>
#include <vector>

namespace hybrid
{
  /// What a scene calls for, built. Parts that it does not have are never made.
  struct SceneModel
  {
    /// Read the mesh and motion and build the parts; writes no file. @param communicator of the
    /// processes that there are. @throws InputError.
    SceneModel(const scene::SceneParameters &scene, output::Log &log, MPI_Comm communicator);

    /// At rest, unstressed.
    coupling::CoupledState initial_state() const;

    /// When the motion has ended, edge loads have risen and point loads have passed [s].
    double end_of_loads() const;

    scene::SectionMesh                    mesh;
    const scene::SceneParameters          scene;
    const scene::InputMotion              input; ///< as given
    const scene::GroundMotion             motion;
    MPI_Comm                              processes;  ///< that compute it: all, or this one alone
    std::unique_ptr<continuum::Continuum> continuum;  ///< the bedrock of finite elements, or null
    std::unique_ptr<dda::Model>           blocks;     ///< of the mass and of the bedrock, or null
    std::unique_ptr<coupling::Foundation> foundation; ///< what the blocks stand on, or null
    std::vector<int> monitor_blocks; ///< the block that each monitor belongs to; -1: none

  private:
    /// With a factor if it fits the memory, where the scene leaves that open.
    void make_continuum(output::Log &log, MPI_Comm communicator);
    void make_blocks();

    /// Share blocks out if they are many.
    void share_blocks();

    /// A bedrock of blocks and what it stands on.
    void make_bedrock_blocks();

    /// Every monitor, borehole and line lies in the model, found before anything is written; what
    /// the monitors belong to, and what the bedrock is watched at.
    /// @throws InputError.
    void check_points();
  };
} // namespace hybrid
