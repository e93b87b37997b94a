// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <algorithm>
#include <string>

namespace hybrid::output
{
  /// What a run will take at most, as far as it can be told before [B].
  struct MemoryEstimate
  {
    double preparation = 0.; ///< the most so far, of the mesh generator for instance: measured
    double built       = 0.; ///< program, mesh, model and state: measured
    double continuum   = 0.; ///< factor, condensed matrices
    double blocks      = 0.; ///< springs, matrix, factor, see dda::SolverMemory
    double sliding     = 0.; ///< more once joints slide: not in the total
    double histories   = 0.; ///< run.h5, which is kept in memory, and what peaks are taken from

    double total() const
    {
      return std::max(preparation, built + continuum + blocks + histories);
    }
  };

  /// Of a scene whose model has just been built. Parts that are nullptr take nothing.
  MemoryEstimate estimate_memory(const scene::SceneParameters &scene,
                                 const scene::SectionMesh     &mesh,
                                 const dda::Model             *blocks,
                                 const continuum::Continuum   *continuum);

  /// Memory that this process may use [B]: the machine's, or less by a limit of its container.
  double available_memory();

  /// "Memory     about 460 MB: ...", of one of the @p processes that compute the scene.
  std::string describe(const MemoryEstimate &estimate, int processes);

  /// Warning if @p processes on one machine, each with this estimate, exceed what it has
  /// @p available [B], else empty.
  std::string memory_warning(const MemoryEstimate &estimate, int processes, double available);
} // namespace hybrid::output
