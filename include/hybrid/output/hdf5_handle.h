// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>

namespace hybrid::output
{
  /// An HDF5 identifier that is closed at the end of its scope.
  class Hdf5Handle
  {
  public:
    Hdf5Handle(const hid_t identifier, herr_t (*close)(hid_t), const std::string &what)
      : id(identifier)
      , close_function(close)
    {
      if (id < 0)
        throw std::runtime_error("HDF5 failed to " + what);
    }

    ~Hdf5Handle()
    {
      close_function(id);
    }

    Hdf5Handle(const Hdf5Handle &)            = delete;
    Hdf5Handle &operator=(const Hdf5Handle &) = delete;

    operator hid_t() const
    {
      return id;
    }

  private:
    hid_t id;
    herr_t (*close_function)(hid_t);
  };
} // namespace hybrid::output
