// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

namespace hybrid::scene
{
  namespace
  {
    const char *const blanks = " \t\r\f\v";

    std::string trimmed(const std::string &text)
    {
      const auto begin = text.find_first_not_of(blanks);
      if (begin == std::string::npos)
        return "";
      return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
    }
  } // namespace


  std::vector<std::string> split_fields(const std::string &line)
  {
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty())
      return {};

    std::vector<std::string> fields;
    const bool               has_commas = text.find_first_of(",;") != std::string::npos;
    const char *const        separators = has_commas ? ",;" : blanks;
    std::size_t              begin      = 0;
    while (begin <= text.size())
      {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        if (has_commas || end > begin)
          fields.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    return fields;
  }


  std::vector<TableRow> read_text_table(const std::string &file)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file, 0, "the file cannot be read.");

    std::vector<TableRow> rows;
    std::string           text;
    for (int line = 1; std::getline(stream, text); ++line)
      {
        check_text(text, file, line);
        std::vector<std::string> fields = split_fields(text);
        if (!fields.empty())
          rows.push_back({line, std::move(fields)});
      }
    if (stream.bad())
      throw InputError(file, 0, "the file cannot be read.");
    return rows;
  }


  void check_text(std::string &text, const std::string &file, const int line)
  {
    if (line == 1 && text.rfind("\xef\xbb\xbf", 0) == 0)
      text.erase(0, 3);
    if (text.find('\0') != std::string::npos)
      throw InputError(file,
                       line,
                       "the file is no plain text (it has a zero byte here); save it as text in "
                       "UTF-8 or ASCII.");
  }


  InputError
  wrong_columns(const TableRow &row, const std::string &expected, const std::string &file)
  {
    const std::size_t n = row.fields.size();
    std::string       sentence =
      "found " + std::to_string(n) + (n == 1 ? " column" : " columns") + "; expected " + expected;
    double     value;
    const bool has_number =
      std::any_of(row.fields.begin(), row.fields.end(), [&](const std::string &field) {
        return parse_number(field, value);
      });
    if (!has_number)
      sentence += " (a line of words must start with #)";
    return {file, row.line, sentence + "."};
  }


  bool parse_number(const std::string &text, double &value)
  {
    const char *const end   = text.data() + text.size();
    const char       *begin = text.data();
    if (begin != end && *begin == '+')
      ++begin;
    const auto result = std::from_chars(begin, end, value);
    return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
  }


  double to_number(const std::string &text,
                   const std::string &what,
                   const std::string &file,
                   const int          line)
  {
    double value;
    if (!parse_number(text, value))
      throw InputError(file, line, "'" + text + "' is not a number; expected " + what + ".");
    return value;
  }
} // namespace hybrid::scene
