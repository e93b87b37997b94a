// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/durable_file.h>
#include <hybrid/restart/first_process_failed.h>
#include <hybrid/restart/shared_file.h>
#include <hybrid/restart/write_error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace hybrid::restart
{
  SharedFile::SharedFile(std::string file_name, const MPI_Comm communicator)
    : name(std::move(file_name))
    , comm(communicator)
  {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    is_first = rank == 0;
    // The first one makes it, before the others open it.
    if (is_first)
      descriptor =
        open(temporary_name(name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    agree(is_first && descriptor < 0 ? errno : 0);
    if (!is_first)
      descriptor = open(temporary_name(name).c_str(), O_WRONLY | O_CLOEXEC);
    agree(descriptor < 0 ? errno : 0);
  }



  SharedFile::~SharedFile()
  {
    if (descriptor >= 0)
      abandon();
  }



  void SharedFile::abandon()
  {
    if (descriptor >= 0)
      close(descriptor);
    descriptor = -1;
    if (is_first)
      std::remove(temporary_name(name).c_str());
  }



  void SharedFile::write(std::uint64_t position, std::string_view content)
  {
    while (!content.empty() && failed == 0)
      {
        const ssize_t n =
          pwrite(descriptor, content.data(), content.size(), static_cast<off_t>(position));
        if (n < 0 && errno != EINTR)
          failed = errno;
        else if (n > 0)
          {
            position += static_cast<std::uint64_t>(n);
            content.remove_prefix(static_cast<std::size_t>(n));
          }
      }
  }



  void SharedFile::finish(const bool durable)
  {
    if (failed == 0 && durable && fsync(descriptor) != 0 && errno != EINVAL)
      failed = errno;
    const int closed = close(descriptor);
    descriptor       = -1;
    agree(failed == 0 && closed != 0 ? errno : failed);
    if (is_first)
      failed = put_in_place(name, durable);
    agree(failed);
  }



  void SharedFile::agree(const int error)
  {
    int of_all = error;
    MPI_Allreduce(MPI_IN_PLACE, &of_all, 1, MPI_INT, MPI_MAX, comm);
    if (of_all == 0)
      return;
    abandon();
    if (is_first)
      throw WriteError("cannot write '" + name + "': " + std::strerror(of_all));
    throw FirstProcessFailed{FirstProcessFailed::of_writing};
  }
} // namespace hybrid::restart
