// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/hdf5_handle.h>
#include <hybrid/output/shared_tables.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/restart/first_process_failed.h>
#include <hybrid/restart/write_error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace hybrid::output
{
  SharedTables::SharedTables(const std::string &file_name,
                             const std::size_t  bytes,
                             const MPI_Comm     communicator)
    : name(file_name)
    , temporary(restart::temporary_name(file_name))
    , comm(communicator)
  {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    is_first = rank == 0;
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // failures are exceptions
    agree(is_first ? reserve(bytes) : 0);
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file properties");
    H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
    H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL);
    file = H5Fopen(temporary.c_str(), H5F_ACC_RDWR, access);
    agree(file < 0 ? EIO : 0);
  }



  int SharedTables::reserve(const std::size_t bytes) const
  {
    constexpr off_t of_hdf5    = 1 << 20; // more than it needs beside the tables; cut off by it
    const int       descriptor = open(temporary.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0)
      return errno;
    const off_t size  = lseek(descriptor, 0, SEEK_END);
    const int   error = posix_fallocate(descriptor, 0, size + static_cast<off_t>(bytes) + of_hdf5);
    ::close(descriptor);
    return error == EOPNOTSUPP || error == EINVAL ? 0 : error; // a file system without it
  }



  void SharedTables::close()
  {
    if (file >= 0)
      H5Fclose(file);
    file = -1;
  }



  void SharedTables::write(const std::string         &path,
                           const std::size_t          columns,
                           const std::vector<double> &rows)
  {
    std::uint64_t n = rows.size() / columns, before = 0;
    MPI_Exscan(&n, &before, 1, MPI_UINT64_T, MPI_SUM, comm);
    const hsize_t    offset[] = {is_first ? 0 : before, 0}; // the first one's is undefined
    const hsize_t    count[]  = {n, columns};
    const int        rank     = columns == 1 ? 1 : 2;
    const Hdf5Handle table(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
    const Hdf5Handle space(H5Dget_space(table), H5Sclose, "read a data space");
    const Hdf5Handle memory(H5Screate_simple(rank, count, nullptr), H5Sclose, "make a data space");
    if (n > 0)
      H5Sselect_hyperslab(space, H5S_SELECT_SET, offset, nullptr, count, nullptr);
    else
      {
        H5Sselect_none(space);
        H5Sselect_none(memory);
      }
    const Hdf5Handle together(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "make transfer properties");
    H5Pset_dxpl_mpio(together, H5FD_MPIO_COLLECTIVE);
    agree(H5Dwrite(table, H5T_NATIVE_DOUBLE, memory, space, together, rows.data()) < 0 ? EIO : 0);
  }



  void SharedTables::finish()
  {
    const herr_t flushed = H5Fflush(file, H5F_SCOPE_GLOBAL);
    const herr_t closed  = H5Fclose(file);
    file                 = -1;
    agree(flushed < 0 || closed < 0 ? EIO : 0);
    agree(is_first ? restart::put_in_place(name, false) : 0);
  }



  void SharedTables::agree(const int error)
  {
    int of_all = error;
    MPI_Allreduce(MPI_IN_PLACE, &of_all, 1, MPI_INT, MPI_MAX, comm);
    if (of_all == 0)
      return;
    close();
    if (!is_first)
      throw FirstProcessFailed{FirstProcessFailed::of_writing};
    std::remove(temporary.c_str());
    throw WriteError("cannot write '" + name + "': " + std::strerror(of_all));
  }
} // namespace hybrid::output
