// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/output/bedrock_pictures.h>
#include <hybrid/output/pvd_series.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * The VTU series of a run for ParaView: continuum.pvd, blocks.pvd, joints.pvd. In all three the
   * points are where they have moved to, and "displacement [m]" says how far from the state at
   * rest: points + (s - 1) displacement draws motions s times as large.
   */
  class Pictures
  {
  public:
    /// Parts that are nullptr are left out. They must outlive the pictures.
    Pictures(const std::string          &directory,
             const dda::Model           *blocks,
             const continuum::Continuum *continuum);

    /// Displacements of blocks count from @p reference (the end of the static stage).
    void set_reference(const dda::DdaState &reference);

    /// The other processes that share a bedrock call BedrockPictures::write().
    void add(const coupling::CoupledState &state);

    /// Reference and number of pictures so far, for the checkpoint. Reading takes over the pictures
    /// of the earlier run and drops later ones.
    void serialize(restart::Archive &archive);

    /// Pictures before the checkpoint whose files are gone, relative to the directory.
    std::vector<std::string> missing_files() const;

  private:
    const dda::Model              *model;
    std::optional<BedrockPictures> bedrock;
    dda::Geometry                  reference;
    VtuWriter                      writer;
    bool                           varied_modulus  = false; ///< moduli of blocks scatter
    bool                           varied_strength = false; ///< strengths of joints scatter
    std::unique_ptr<PvdSeries>     block_series, joint_series, continuum_series;

    void add_blocks(const coupling::CoupledState &state);

    void add_joints(const coupling::CoupledState &state);
  };
} // namespace hybrid::output
