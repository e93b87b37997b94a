// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

namespace hybrid::scene
{
  namespace
  {
    const char *const blanks = " \t\r\n";

    /// Names become groups of run.h5, subsections and files.
    void check_name(const std::string &name)
    {
      const bool fine = !name.empty() && std::all_of(name.begin(), name.end(), [](const char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
      });
      if (!fine)
        throw InputError("name '" + name + "' must consist of letters, digits, '_', '-' and '.'");
    }

    /// A row of a CSV file "name,x,z".
    struct PointRow
    {
      int         line; ///< of the file
      std::string name;
      Vec2        point; ///< [m]
    };

    /// All rows; a header and # lines are skipped.
    std::vector<PointRow> read_rows(const std::string &file)
    {
      std::ifstream in(file);
      if (!in)
        throw InputError("file '" + file + "' cannot be read");
      std::vector<PointRow> rows;
      std::string           text;
      bool                  header_may_come = true;
      for (int line = 1; std::getline(in, text); ++line)
        {
          check_text(text, file, line);
          text = trim(text.substr(0, text.find('#')));
          if (text.empty())
            continue;
          const std::vector<std::string> fields    = split(text, ',');
          const bool                     is_header = header_may_come && fields.size() == 3 &&
                                 !parse_number(fields[1]) && !parse_number(fields[2]);
          header_may_come = false;
          if (is_header)
            continue;
          const std::optional<double> x =
            fields.size() == 3 ? parse_number(fields[1]) : std::nullopt;
          const std::optional<double> z =
            fields.size() == 3 ? parse_number(fields[2]) : std::nullopt;
          if (!x || !z)
            throw InputError(file, line, "row '" + text + "' must have the form name,x,z");
          rows.push_back({line, fields[0], Vec2(*x, *z)});
        }
      return rows;
    }

    /// Skip a '+', which std::from_chars does not take.
    template <typename Number>
    std::optional<Number> parse_whole(const std::string &text)
    {
      const bool  plus  = text.size() > 1 && text[0] == '+' && text[1] != '-';
      const char *begin = text.data() + (plus ? 1 : 0);
      const char *end   = text.data() + text.size();
      Number      value{};
      const auto  result = std::from_chars(begin, end, value);
      if (result.ec != std::errc() || result.ptr != end)
        return {};
      return value;
    }
  } // namespace

  std::string trim(const std::string &text)
  {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
  }

  std::vector<std::string> split(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    std::size_t              begin = 0;
    for (;;)
      {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(trim(text.substr(begin, end - begin)));
        if (end == std::string::npos)
          return parts;
        begin = end + 1;
      }
  }

  std::optional<double> parse_number(const std::string &text)
  {
    const std::optional<double> value = parse_whole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  std::optional<int> parse_integer(const std::string &text)
  {
    return parse_whole<int>(text);
  }

  std::string number_text(const double value)
  {
    char       buffer[64];
    const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
    return {buffer, result.ptr};
  }

  std::vector<std::string> parse_names(const std::string &text)
  {
    std::vector<std::string> names;
    if (trim(text).empty())
      return names;
    for (const std::string &name : split(text, ','))
      {
        check_name(name);
        if (std::count(names.begin(), names.end(), name) > 0)
          throw InputError("name '" + name + "' stands twice in the list");
        names.push_back(name);
      }
    return names;
  }

  std::vector<std::pair<std::string, std::string>> parse_pairs(const std::string &text,
                                                               const char         separator)
  {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string &part : split(text, ';'))
      {
        if (part.empty()) // after the last ';', or nothing at all
          continue;
        const std::size_t at   = part.find(separator);
        const std::string name = trim(part.substr(0, at));
        if (at == std::string::npos || name.empty() || trim(part.substr(at + 1)).empty())
          throw InputError("'" + part + "' must have the form 'name " + separator + " value'");
        for (const auto &pair : pairs)
          if (pair.first == name)
            throw InputError("name '" + name + "' stands twice in the list");
        pairs.emplace_back(name, trim(part.substr(at + 1)));
      }
    return pairs;
  }

  std::vector<std::pair<std::string, std::vector<double>>>
  parse_rows(const std::string &text, const std::size_t columns, const std::size_t optional)
  {
    std::vector<std::pair<std::string, std::vector<double>>> rows;
    for (const auto &pair : parse_pairs(text, ':'))
      {
        check_name(pair.first);
        std::vector<double> numbers;
        for (const std::string &part : split(pair.second, ','))
          {
            const std::optional<double> number = parse_number(part);
            if (!number)
              throw InputError("'" + part + "' of '" + pair.first + "' must be a number");
            numbers.push_back(*number);
          }
        if (numbers.size() < columns || numbers.size() > columns + optional)
          throw InputError("'" + pair.first + "' has " + std::to_string(numbers.size()) +
                           " numbers but must have " + std::to_string(columns) +
                           (optional > 0 ? " to " + std::to_string(columns + optional) : ""));
        numbers.resize(columns + optional, 0.);
        rows.emplace_back(pair.first, numbers);
      }
    return rows;
  }

  std::vector<std::pair<std::string, Vec2>> read_points(const std::string              &file,
                                                        const std::vector<std::string> &names)
  {
    std::map<std::string, Vec2> found;
    std::vector<std::string>    available;
    for (const PointRow &row : read_rows(file))
      {
        available.push_back(row.name);
        if (std::count(names.begin(), names.end(), row.name) == 0)
          continue;
        if (!found.emplace(row.name, row.point).second)
          throw InputError(file,
                           row.line,
                           "'" + row.name + "' stands in several rows: it is not a point");
      }

    std::vector<std::pair<std::string, Vec2>> points;
    for (const std::string &name : names)
      {
        const auto point = found.find(name);
        if (point == found.end())
          throw InputError(file, 0, "there is no row '" + name + "'" + suggestion(name, available));
        points.emplace_back(name, point->second);
      }
    return points;
  }

  std::vector<std::pair<std::string, std::vector<Vec2>>> read_polylines(const std::string &file)
  {
    std::vector<std::pair<std::string, std::vector<Vec2>>> lines;
    for (const PointRow &row : read_rows(file))
      {
        check_name(row.name);
        auto line = std::find_if(lines.begin(), lines.end(), [&](const auto &known) {
          return known.first == row.name;
        });
        if (line == lines.end())
          line = lines.insert(line, {row.name, {}});
        line->second.push_back(row.point);
      }
    return lines;
  }
} // namespace hybrid::scene
