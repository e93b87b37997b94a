// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// One row of a text file of columns.
  struct TableRow
  {
    int                      line; ///< line number in the file, from 1
    std::vector<std::string> fields;
  };


  /**
   * Rows of a text file: fields separated by commas or semicolons, or else by blanks.
   * Beside semicolons or blanks a comma between digits is a decimal mark ("0,01; 0,3").
   * # starts a comment; empty lines are skipped, and so are lines without any number before the
   * first row: they are its heading.
   * @throws InputError if the file cannot be read or is no text.
   */
  std::vector<TableRow> read_text_table(const std::string &file);


  /// Throws InputError if a line of words before the first row of @p file has the name of one of
  /// its @p columns at the place of another one. Units in brackets and capitals do not matter.
  void check_heading(const std::string &file, const std::vector<std::string> &columns);


  /// Throws InputError for a @p line that is no text, and takes away the mark with which some
  /// editors begin a file in UTF-8.
  void check_text(std::string &text, const std::string &file, int line);


  /// @p row has another number of columns than @p expected ("time [s] and acceleration").
  InputError
  wrong_columns(const TableRow &row, const std::string &expected, const std::string &file);


  /// The fields of one line, separated and commented as above.
  std::vector<std::string> split_fields(const std::string &line);


  /// @return true and the value if all of @p text is one finite number ("." is the decimal mark in
  /// every locale; exponents begin with e or, in Fortran's double precision, d).
  bool parse_number(const std::string &text, double &value);


  /// The number in @p text. @throws InputError with file and line, saying @p what was expected.
  double
  to_number(const std::string &text, const std::string &what, const std::string &file, int line);
} // namespace hybrid::scene
