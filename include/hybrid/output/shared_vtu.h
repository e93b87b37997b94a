// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/vtu_file.h>
#include <hybrid/restart/shared_file.h>

#include <mpi.h>

namespace hybrid::output
{
  /**
   * A .vtu file that all ranks write: the first one its text, each its part of the arrays as a zlib
   * block of its own. Readers find one piece with all points and cells, as if one rank had written
   * it. All ranks call every function, in the same order.
   */
  class SharedVtu final : public VtuFile
  {
  public:
    /// @throws as SharedFile
    SharedVtu(const std::string &file_name, MPI_Comm communicator);

    /// The same on all ranks.
    void add_text(std::string_view text) override;

    /// @param data of this rank; parts of the ranks follow each other. As many bytes on each, fewer
    /// on the last that has any, none on those behind it.
    void add_array(const void *data, std::size_t n_bytes) override;

    /// @throws as SharedFile
    void finish();

  private:
    /// What a rank has of an array.
    struct Part
    {
      std::uint64_t n_bytes, compressed;
      unsigned char first[8]; ///< bytes of the block; a group of base64 may need two of the next
    };

    void add_header(const std::vector<Part> &parts);

    restart::SharedFile file;
    MPI_Comm            comm;
    int                 rank = 0, ranks = 1;
    std::uint64_t       end = 0; ///< of what is in the file so far
  };
} // namespace hybrid::output
