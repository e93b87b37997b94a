// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * The text of parameter values: numbers, lists and named rows. The functions that return
 * an optional are silent; those that do not throw InputError with what is wrong, without file
 * and line, which the caller adds.
 */
namespace hybrid::scene
{
  /// Without blanks at both ends.
  std::string trim(const std::string &text);

  /// Trimmed parts between separators; one empty part for an empty text.
  std::vector<std::string> split(const std::string &text, char separator);

  /// A finite number that fills the whole text; independent of the locale.
  std::optional<double> parse_number(const std::string &text);

  /// An integer that fills the whole text.
  std::optional<int> parse_integer(const std::string &text);

  /// Shortest text that reads back to the same number.
  std::string number_text(double value);

  /// "a, b, c" with distinct names, each of letters, digits, '_', '-', '.'; empty text: no names.
  std::vector<std::string> parse_names(const std::string &text);

  /// "name SEPARATOR value; ..." in order, with distinct names; empty text: no pairs.
  std::vector<std::pair<std::string, std::string>> parse_pairs(const std::string &text,
                                                               char               separator);

  /// "name: x, y, ...; ..." with @p columns numbers each, and up to @p optional more, which are 0
  /// where they are left out.
  std::vector<std::pair<std::string, std::vector<double>>>
  parse_rows(const std::string &text, std::size_t columns, std::size_t optional = 0);

  /**
   * The points of a CSV file "name,x,z" (header and # lines are skipped) whose names are listed,
   * in the order of the list.
   * @throws InputError with file and line if a name is missing or stands in several rows.
   */
  std::vector<std::pair<std::string, Vec2>> read_points(const std::string              &file,
                                                        const std::vector<std::string> &names);

  /// All polylines of a CSV file "name,x,z" (header and # lines are skipped): rows of one name, in
  /// their order. @throws InputError with file and line.
  std::vector<std::pair<std::string, std::vector<Vec2>>> read_polylines(const std::string &file);
} // namespace hybrid::scene
