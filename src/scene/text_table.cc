// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cctype>
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


    /// Line @p number of a file, without its comment.
    std::string line_of(const std::string &file, const int number)
    {
      std::ifstream stream(file);
      std::string   text;
      for (int line = 0; line < number && std::getline(stream, text);)
        ++line;
      return trimmed(text.substr(0, text.find('#')));
    }


    /// "0,01 0,3" or "0,01;0,3": digits on both sides of every comma, and another separator.
    /// Commas that part columns make no row of numbers of such a line.
    bool has_decimal_commas(const std::string &text)
    {
      const auto is_digit = [&](const std::size_t i) {
        return i < text.size() && text[i] >= '0' && text[i] <= '9';
      };
      bool has_comma = false;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == ',')
          {
            if (i == 0 || !is_digit(i - 1) || !is_digit(i + 1))
              return false;
            has_comma = true;
          }
      return has_comma && text.find_first_of(" \t;") != std::string::npos &&
             text.find('.') == std::string::npos;
    }


    /// A number, in quotation marks or not finite too: one that is meant to be in the table.
    bool looks_like_number(const std::string &field)
    {
      const char *const quotes = "\"'";
      const auto        begin  = field.find_first_not_of(quotes);
      if (begin == std::string::npos)
        return false;
      const std::string inside = field.substr(begin, field.find_last_not_of(quotes) + 1 - begin);
      double            value;
      const char *const end  = inside.data() + inside.size();
      const auto        read = std::from_chars(inside.data(), end, value);
      return (read.ec == std::errc() && read.ptr == end) || parse_number(inside, value);
    }


    /// "X [m]" is x.
    std::string column_name(const std::string &field)
    {
      std::string name = field.substr(0, field.find_first_of(" \t[("));
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
      });
      return name;
    }


    /// What would make a row readable, in brackets; empty if that is not known.
    std::string remedy_for(const std::string &text)
    {
      if (text.find('"') != std::string::npos || text.find('\'') != std::string::npos)
        return " (leave the quotation marks away)";
      double                         value;
      const std::vector<std::string> fields = split_fields(text);
      if (std::none_of(fields.begin(), fields.end(), [&](const std::string &field) {
            return parse_number(field, value);
          }))
        return " (a line of words must start with #)";
      return "";
    }
  } // namespace


  std::vector<std::string> split_fields(const std::string &line)
  {
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty())
      return {};

    std::vector<std::string> fields;
    const bool               has_decimals = has_decimal_commas(text);
    const std::string        marks        = has_decimals ? ";" : ",;";
    const bool               has_marks    = text.find_first_of(marks) != std::string::npos;
    const std::string        separators   = has_marks ? marks : blanks;
    std::size_t              begin        = 0;
    while (begin <= text.size())
      {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        if (has_marks || end > begin)
          fields.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    if (has_decimals)
      for (std::string &field : fields)
        std::replace(field.begin(), field.end(), ',', '.');
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
        if (!fields.empty() &&
            !(rows.empty() && std::none_of(fields.begin(), fields.end(), looks_like_number)))
          rows.push_back({line, std::move(fields)});
      }
    if (stream.bad())
      throw InputError(file, 0, "the file cannot be read.");
    return rows;
  }


  void check_heading(const std::string &file, const std::vector<std::string> &columns)
  {
    std::ifstream stream(file);
    std::string   text;
    for (int line = 1; std::getline(stream, text); ++line)
      {
        check_text(text, file, line);
        const std::vector<std::string> fields = split_fields(text);
        if (std::any_of(fields.begin(), fields.end(), looks_like_number))
          return;
        for (std::size_t i = 0; i < fields.size(); ++i)
          {
            const auto found = std::find(columns.begin(), columns.end(), column_name(fields[i]));
            if (found == columns.end() || found - columns.begin() == static_cast<long>(i))
              continue;
            std::string order;
            for (const std::string &column : columns)
              order += (order.empty() ? "" : ", ") + column;
            throw InputError(file,
                             line,
                             "the heading names '" + fields[i] + "' as column " +
                               std::to_string(i + 1) + "; the order of the columns is " + order +
                               ".");
          }
      }
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
    sentence += remedy_for(line_of(file, row.line));
    return {file, row.line, sentence + "."};
  }


  bool parse_number(const std::string &text, double &value)
  {
    std::string in_c     = text;
    const auto  exponent = in_c.find_first_of("dD"); // as Fortran writes double precision
    if (exponent != std::string::npos)
      in_c[exponent] = 'e';
    const char *const end   = in_c.data() + in_c.size();
    const char       *begin = in_c.data();
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
      throw InputError(file,
                       line,
                       "'" + text + "' is not a number; expected " + what +
                         remedy_for(line_of(file, line)) + ".");
    return value;
  }
} // namespace hybrid::scene
