// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hybrid
{
  /**
   * Keeps other runs out of an output directory, as long as it lives.
   *
   * The lock belongs to the process: it is gone when that ends, however it ends, and leaves no
   * file. On file systems that know no locks every run may enter.
   */
  class DirectoryLock
  {
  public:
    DirectoryLock() = default;
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock &)            = delete;
    DirectoryLock &operator=(const DirectoryLock &) = delete;

    /// Nothing where it was taken before. @param directory that exists
    /// @throws InputError if another run is there.
    void take(const std::string &directory);

  private:
    int descriptor = -1;
  };
} // namespace hybrid
