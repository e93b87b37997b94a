// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/output/vtu_writer.h>

#include <string>

namespace hybrid::output
{
  /// Pictures of the bedrock, one file each, by all processes that share it.
  class BedrockPictures
  {
  public:
    /// The bedrock must outlive the pictures.
    explicit BedrockPictures(const continuum::Continuum &bedrock);

    /// All processes call it. @param file_name that of the first one counts
    void write(const continuum::ContinuumState &state, const std::string &file_name) const;

  private:
    const continuum::Continuum &continuum;

    VtuWriter draw(const continuum::ContinuumState &state) const;
  };


  /// A text of the first rank on all.
  std::string from_first(std::string text, MPI_Comm communicator);
} // namespace hybrid::output
