// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/vtu_writer.h>
#include <hybrid/restart/archive_forward.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hybrid::output
{
  /**
   * The pictures of one part of the model over time: DIR/NAME.pvd, which ParaView opens, and
   * DIR/vtu/NAME_00000.vtu, ... The .pvd is replaced after each picture, so it is valid at any
   * moment.
   */
  class PvdSeries
  {
  public:
    /// @param output_directory of the run; "vtu" is made in it. @param part such as "blocks".
    PvdSeries(std::string output_directory, std::string part);

    /// Write a picture at simulated time @p time [s] and list it.
    void add(double time, const VtuWriter &picture);

    /// The same with what writes it to a file.
    void add(double time, const std::function<void(const std::string &file_name)> &write);

    /// The list of pictures, for the checkpoint. Reading writes the .pvd anew: later pictures of
    /// the earlier run are dropped, and those whose file is gone are left out.
    void serialize(restart::Archive &archive);

    /// Pictures before the checkpoint whose files are gone, relative to the directory.
    std::vector<std::string> missing_files() const;

  private:
    void write_pvd() const;

    std::string           directory;
    std::string           name;
    std::vector<double>   times;   ///< of the pictures [s]
    std::set<std::size_t> missing; ///< numbers of pictures whose file is gone

    /// File of picture @p number, relative to the directory.
    std::string file_of(std::size_t number) const;
  };
} // namespace hybrid::output
