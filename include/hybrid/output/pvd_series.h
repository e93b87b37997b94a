// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/vtu_writer.h>

#include <string>
#include <utility>
#include <vector>

namespace hybrid::output
{
  /**
   * The pictures of one part of the model over time: DIR/<name>.pvd, which ParaView opens, and
   * DIR/vtu/<name>_00000.vtu, ... The .pvd is replaced after each picture, so it is valid at any
   * moment.
   */
  class PvdSeries
  {
  public:
    /// @param output_directory of the run; "vtu" is made in it. @param part such as "blocks".
    PvdSeries(std::string output_directory, std::string part);

    /// Write a picture at simulated time @p time [s] and list it.
    void add(double time, const VtuWriter &picture);

    /// Take over the pictures of an earlier run up to @p last_time [s] (inclusive); later ones are
    /// dropped.
    void resume(double last_time);

    std::size_t n_pictures() const
    {
      return pictures.size();
    }

  private:
    void write_pvd() const;

    std::string                                 directory;
    std::string                                 name;
    std::vector<std::pair<double, std::string>> pictures; ///< time [s], file relative to directory
  };
} // namespace hybrid::output
