// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <mpi.h>
#include <string>
#include <string_view>

namespace hybrid::restart
{
  /**
   * A file that ranks write together, each its parts, under a temporary name; it takes its name
   * when all is there. Whoever reads it finds the old content or the new one, also after a kill of
   * any rank at any moment.
   *
   * Each rank writes at its places of the file (pwrite), and says if it fails. Not by MPI-IO: on a
   * full disk that of Open MPI 4.1 reports success, and never says why it failed.
   */
  class SharedFile
  {
  public:
    /// All ranks call it. @throws WriteError on the first rank, FirstProcessFailed on the others,
    /// if a rank cannot open it.
    SharedFile(std::string file_name, MPI_Comm communicator);

    SharedFile(const SharedFile &)            = delete;
    SharedFile &operator=(const SharedFile &) = delete;

    /// A file that is not finished goes.
    ~SharedFile();

    /// From @p position on; of this rank alone. What fails is told by finish().
    void write(std::uint64_t position, std::string_view content);

    /// It takes its name; all ranks call it. @param durable also after a power failure: waits until
    /// the disk has it. @throws as the constructor; the old content is still there.
    void finish(bool durable);

  private:
    /// @throws as the constructor if @p error, an errno, is not 0 on any rank
    void agree(int error);

    /// Close it and take it away.
    void abandon();

    const std::string name;
    const MPI_Comm    comm;
    bool              is_first   = true;
    int               descriptor = -1;
    int               failed     = 0; ///< errno of the first failure; 0: none
  };
} // namespace hybrid::restart
