// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// One `set key = value` of a parameter file, and where it stands.
  struct ParameterLine
  {
    std::string              file;     ///< path as given, or "-s option"
    int                      line = 0; ///< 1-based; 0 for an option
    std::vector<std::string> section;  ///< subsections from outside to inside; empty at top level
    std::string              key;
    std::string              value;
    bool                     is_override =
      false;       ///< from the command line: file names resolve against the working directory
    int depth = 0; ///< how many files include the one that it stands in

    /// "Section/Key".
    std::string path() const;

    /// An error at this line.
    InputError error(const std::string &sentence) const;
  };

  /**
   * Read the lines of a file in deal.II's ParameterHandler syntax: subsection,
   * set, end, include, # comments, and a backslash at the end of a line that goes on.
   *
   * An included file resolves against the file that includes it, and closes
   * each subsection that it opens.
   *
   * @throws InputError with file and line for an unreadable file, a line that is none of
   * these, a missing or surplus `end`, and an include cycle.
   */
  std::vector<ParameterLine> scan_parameter_file(const std::string &file);

  /// "Section/Key=value" of the command line. @throws InputError if it has another form.
  ParameterLine parse_override(const std::string &option);

  /// "Section/Subsection" of a list of nested sections.
  std::string join_path(const std::vector<std::string> &section);
} // namespace hybrid::scene
