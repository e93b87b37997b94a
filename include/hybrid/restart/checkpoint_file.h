// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace hybrid::restart
{
  /// What a checkpoint file holds.
  struct CheckpointContent
  {
    std::uint64_t layout = 0; ///< checksum of the description of the state (Archive::describer())
    std::string_view state;   ///< content of an Archive: the file itself, not a copy

    std::shared_ptr<const char> file; ///< in memory as far as it is read
  };

  /// Version of the file format that this program writes and reads.
  constexpr std::uint32_t checkpoint_version = 16;

  /// Write under a temporary name, bring to the disk, rename: after a kill or a power failure there
  /// is the old checkpoint or the new one. The state is never in memory as a whole.
  /// @param layout as in CheckpointContent @param write_state fills the archive with the state
  /// @throws WriteError.
  void write_checkpoint(const std::string                    &file_name,
                        std::uint64_t                         layout,
                        const std::function<void(Archive &)> &write_state);

  /// A checkpoint to @p file, portion by portion. @param sum checksum of the state so far, for who
  /// writes parts of it elsewhere; begins with that of nothing
  void put_checkpoint(const std::function<void(std::string_view)> &file,
                      std::uint64_t                                layout,
                      std::uint64_t                               &sum,
                      const std::function<void(Archive &)>        &write_state);

  /// @param verify look at all of it: one of several ranks is enough @throws InputError if there is
  /// no file, or one that is no checkpoint, has another version or is damaged.
  CheckpointContent read_checkpoint(const std::string &file_name, bool verify = true);
} // namespace hybrid::restart
