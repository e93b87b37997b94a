// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/directory_lock.h>
#include <hybrid/scene/input_error.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace hybrid
{
  DirectoryLock::~DirectoryLock()
  {
    if (descriptor >= 0)
      close(descriptor);
  }



  void DirectoryLock::take(const std::string &directory)
  {
    if (descriptor >= 0)
      return;
    descriptor = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0 || flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
      return;
    close(descriptor);
    descriptor = -1;
    throw InputError(
      "Output/Directory: another run is writing into '" + directory +
      "' at this moment: wait until it ends, stop it, or let this one write elsewhere");
  }
} // namespace hybrid
