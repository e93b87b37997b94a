// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mpi.h>
#include <string>
#include <string_view>
#include <vector>

namespace hybrid::restart
{
  /**
   * Numbers of a state that ranks share: in a checkpoint they stand where one rank alone writes a
   * vector, as it does, though no rank has all of them. They come in blocks, each of numbers that
   * are shared and of others behind them that all ranks have.
   */
  struct SharedVector
  {
    const std::vector<double> *vector = nullptr;                  ///< whose place they take
    std::size_t                blocks = 1, shared = 0, alike = 0; ///< alike: those that all have

    /// Numbers of a block that this rank writes; those of the ranks follow each other. All ranks
    /// call it.
    std::function<std::vector<double>(std::size_t block)> portion;

    /// Those that all have; empty without.
    std::function<const double *(std::size_t block)> rest;

    /// Read what is this rank's. @param numbers all shared ones of the block, 8 bytes each; not
    /// called if the vector was empty
    std::function<void(std::size_t block, const char *numbers)> take;

    bool is_empty = false; ///< now; it may be read nevertheless

    std::size_t length() const
    {
      return blocks * (shared + alike);
    }
  };


  /// write_checkpoint() by all ranks, with the same bytes on any number of them, in which each
  /// writes its part of @p vectors. All ranks call it. @param write_state of the first one counts
  /// @throws as SharedFile
  void write_shared_checkpoint(const std::string                    &file_name,
                               std::uint64_t                         layout,
                               const std::function<void(Archive &)> &write_state,
                               const std::vector<SharedVector>      &vectors,
                               MPI_Comm                              communicator);


  /// Reads the shared numbers of a state: each rank its own.
  class SharedReading
  {
  public:
    /// The archive passes over the vectors. Both have to outlive this object.
    SharedReading(Archive &archive, const std::vector<SharedVector> &vectors);

    /// Once the first rank has read its archive, whatever the others have read of theirs. All ranks
    /// call it. @param state what the archive reads
    void take(std::string_view state, MPI_Comm communicator);

  private:
    const std::vector<SharedVector> &vectors;
    std::vector<std::uint64_t>       places; ///< of the numbers in the state
  };
} // namespace hybrid::restart
