// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <mpi.h>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * Tables of an HDF5 file of which each rank has rows that follow each other: written by all at
   * once, into a file that nobody reads yet (a kill leaves an HDF5 file that is written in place
   * unreadable), and which takes its name when all is there. Tables have been declared
   * (HistoryFile).
   *
   * The first rank reserves the room for all before anything is written: a full disk is told then.
   * MPI-IO of Open MPI 4.1 would report success. A file that is not finished stays open: what fails
   * on one rank alone ends all.
   */
  class SharedTables
  {
  public:
    /// @param file_name what it is to be called; now it has its temporary name @param bytes of all
    /// tables, as the first one knows. All ranks call it. @throws as restart::SharedFile
    SharedTables(const std::string &file_name, std::size_t bytes, MPI_Comm communicator);

    SharedTables(const SharedTables &)            = delete;
    SharedTables &operator=(const SharedTables &) = delete;

    /// Rows of this rank, which follow those of the ranks before it. All ranks call it.
    /// @throws std::runtime_error
    void write(const std::string &path, std::size_t columns, const std::vector<double> &rows);

    /// It takes its name. All ranks call it. @throws as restart::SharedFile
    void finish();

  private:
    int  reserve(std::size_t bytes) const; ///< @return errno, or 0
    void agree(int error);
    void close();

    const std::string name, temporary;
    const MPI_Comm    comm;
    bool              is_first = true;
    std::int64_t      file     = -1; ///< HDF5 identifier
  };
} // namespace hybrid::output
