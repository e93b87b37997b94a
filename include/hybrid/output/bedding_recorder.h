// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/output/history_file.h>
#include <hybrid/output/summary.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// The group `bedding` of run.h5: what the points of planes that may slip do, alike for a
  /// bedrock of finite elements (Gauss points) and of blocks (ends of joints).
  class BeddingRecorder
  {
  public:
    /// What has no such planes may be nullptr. @param names of the scene's planes
    BeddingRecorder(const continuum::Continuum     *continuum,
                    const dda::Model               *blocks,
                    const std::vector<std::string> &names);

    bool has_planes() const
    {
      return !planes.empty();
    }

    /// Make the data sets.
    void add_series(HistoryFile &file);

    void record(const coupling::CoupledState &state, HistoryFile &file) const;

    /// What the planes have slipped at the end of the run.
    void summarize(const coupling::CoupledState &state, Summary &summary) const;

  private:
    struct Plane
    {
      std::string       name;
      std::vector<Vec2> points; ///< initial [m]
      std::vector<int>  joints; ///< of blocks, two points each
      int slip = -1, opening = -1, normal_stress = -1, shear_stress = -1, condition = -1;
    };

    const continuum::Continuum *continuum;
    std::vector<Plane>          planes; ///< that may slip
    int                         time = -1;

    void add_block_planes(const dda::Model &blocks, const std::vector<std::string> &names);

    continuum::BeddingValues values(const coupling::CoupledState &state, std::size_t plane) const;
  };
} // namespace hybrid::output
