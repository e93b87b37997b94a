// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/motion_reader.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    constexpr double standard_gravity     = 9.80665; // [m/s2]
    constexpr double foot                 = 0.3048;  // [m]
    constexpr double largest_acceleration = 1e4;     // [m/s2]: a thousand g


    std::string in_words(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }


    /// What the header of a PEER record says.
    struct At2Header
    {
      std::size_t points = 0;                ///< NPTS
      double      dt     = 0.;               ///< [s]
      double      unit   = standard_gravity; ///< of the values [m/s2]
      int         lines  = 0;                ///< of the header, including the one with NPTS
    };


    std::string upper_case(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const unsigned char c) {
        return std::toupper(c);
      });
      return text;
    }


    /// @return whether @p line (upper case) has @p word, not as the end of a longer one.
    bool has_word(const std::string &line, const std::string &word)
    {
      for (auto at = line.find(word); at != std::string::npos; at = line.find(word, at + 1))
        if (at == 0 || !std::isalpha(static_cast<unsigned char>(line[at - 1])))
          return true;
      return false;
    }


    /// The text of the number that follows @p key and "=", ":" or blanks; empty if there is none.
    std::string number_after(const std::string &line, const std::string &key)
    {
      const auto at = line.find(key);
      if (at == std::string::npos)
        return "";
      const auto begin = std::min(line.find_first_not_of(" \t=:", at + key.size()), line.size());
      const auto end   = line.find_first_not_of("0123456789.E+-", begin);
      return line.substr(begin, end - begin);
    }


    /// @return whether the header line has NPTS and DT, in any of the usual forms.
    bool parse_points_and_step(const std::string &line,
                               const std::string &file,
                               const int          number,
                               At2Header         &header)
    {
      const auto keyword = line.find("NPTS");
      if (keyword == std::string::npos)
        return false;

      std::string                    count   = number_after(line, "NPTS");
      std::string                    step    = number_after(line, "DT");
      const std::vector<std::string> leading = split_fields(line.substr(0, keyword));
      if (count.empty() && leading.size() == 2) // "6557 .00244 NPTS, DT"
        {
          count = leading[0];
          step  = leading[1];
        }
      double points = 0.;
      if (!parse_number(count, points) || !parse_number(step, header.dt))
        throw InputError(file,
                         number,
                         "the header line '" + line +
                           "' is not understood; expected NPTS= <count>, DT= <seconds>.");
      if (!(header.dt > 0.) || points < 2. || points > 1e9)
        throw InputError(file,
                         number,
                         "NPTS is " + in_words(points) + " and DT " + in_words(header.dt) +
                           " s; at least two points and a positive time step are needed.");
      header.points = static_cast<std::size_t>(points);
      header.lines  = number;
      return true;
    }


    At2Header read_at2_header(std::istream &stream, const std::string &file)
    {
      At2Header   header;
      std::string line;
      for (int number = 1; number <= 100 && std::getline(stream, line); ++number)
        {
          line = upper_case(line);
          if (!line.empty() && line.back() == '\r')
            line.pop_back();
          if (has_word(line, "CM/S") || has_word(line, "(GAL)") || has_word(line, "OF GAL"))
            header.unit = 0.01;
          else if (has_word(line, "M/S"))
            header.unit = 1.;
          else if (has_word(line, "FT/S"))
            header.unit = foot;
          if (has_word(line, "UNITS") && !has_word(line, "ACCELERATION"))
            for (const char *other : {"VELOCITY", "DISPLACEMENT"})
              if (has_word(line, other))
                throw InputError(file,
                                 number,
                                 "this is no record of acceleration: its header says '" + line +
                                   "'. PEER's files of acceleration end in .AT2.");
          if (parse_points_and_step(line, file, number, header))
            return header;
        }
      throw InputError(file,
                       0,
                       "no header line with NPTS and DT was found, as PEER's records have; for two "
                       "columns of time and acceleration set Motion/Type = text.");
    }


    /// The acceleration [m/s2] in @p text, given in @p unit [m/s2].
    double to_acceleration(const std::string &text,
                           const double       unit,
                           const std::string &file,
                           const int          line)
    {
      const double a = unit * to_number(text, "an acceleration", file, line);
      if (!(std::abs(a) <= largest_acceleration))
        throw InputError(file,
                         line,
                         "the acceleration " + text + " is " + in_words(a) + " m/s2; at most " +
                           in_words(largest_acceleration) + " m/s2 are allowed.");
      return a;
    }


    /// Unit of the last digit of a number as it is printed: 0.01 of 2.50, 1e-4 of 1.5e-3.
    double last_digit(const std::string &number)
    {
      const std::size_t exponent = number.find_first_of("eEdD");
      const std::string mantissa = number.substr(0, exponent);
      const std::size_t point    = mantissa.find_first_of(".,");
      const int decimals = point == std::string::npos ? 0 : int(mantissa.size() - point) - 1;
      const int power    = exponent == std::string::npos ? 0 : std::atoi(&number[exponent + 1]);
      return std::pow(10., power - decimals);
    }


    void check_spacing(const std::string           &file,
                       const std::vector<TableRow> &rows,
                       const std::vector<double>   &t)
    {
      const double dt = (t.back() - t.front()) / (t.size() - 1);
      for (std::size_t i = 1; i < t.size(); ++i)
        if (!(t[i] > t[i - 1]))
          throw InputError(file,
                           rows[i].line,
                           "the time " + in_words(t[i]) + " s does not follow " +
                             in_words(t[i - 1]) + " s.");

      std::vector<double> spacing(t.size() - 1);
      for (std::size_t i = 1; i < t.size(); ++i)
        spacing[i - 1] = t[i] - t[i - 1];
      std::vector<double> ordered = spacing;
      std::nth_element(ordered.begin(), ordered.begin() + ordered.size() / 2, ordered.end());
      const double typical = ordered[ordered.size() / 2];

      // Printed times are rounded: 1/128 s with three digits is 7 or 8 ms. Trailing zeros may be
      // left out.
      double unit = last_digit(rows[0].fields[0]);
      for (const TableRow &row : rows)
        unit = std::min(unit, last_digit(row.fields[0]));
      const double rounding = unit < 0.25 * typical ? unit : 0.;
      for (std::size_t i = 1; i < t.size(); ++i)
        if (std::abs(spacing[i - 1] - typical) > 0.05 * typical + rounding)
          throw InputError(file,
                           rows[i].line,
                           "the spacing of " + in_words(spacing[i - 1]) +
                             " s differs from the others of " + in_words(typical) +
                             " s; samples must be equally spaced: interpolate them.");
      for (std::size_t i = 1; i < t.size(); ++i)
        if (std::abs(t[i] - t[0] - i * dt) > 0.1 * dt + rounding)
          throw InputError(file,
                           rows[i].line,
                           "the time " + in_words(t[i]) + " s should be " +
                             in_words(t[0] + i * dt) +
                             " s; samples must be equally spaced: interpolate them.");
    }


    /// A file of PEER's is known by its header, whatever its name.
    void refuse_at2(const std::string &file)
    {
      std::ifstream stream(file);
      std::string   line;
      At2Header     header;
      for (int number = 1; number <= 20 && std::getline(stream, line); ++number)
        {
          bool has_header = false;
          try
            {
              has_header = parse_points_and_step(upper_case(line.substr(0, line.find('#'))),
                                                 file,
                                                 number,
                                                 header);
            }
          catch (const InputError &)
            {} // another use of the word
          if (has_header)
            throw InputError(
              file,
              number,
              "this is a record of PEER (NPTS and DT in its header); set Motion/Type "
              "= at2.");
        }
    }


    InputError wrong_columns_of_motion(const TableRow &row, const std::string &file)
    {
      double value;
      if (row.fields.size() == 1 && parse_number(row.fields[0], value))
        return {file,
                row.line,
                "found 1 column; expected time [s] and acceleration (to accelerations alone add "
                "the time before each, or the header of a PEER record with NPTS and DT for "
                "Motion/Type = at2)."};
      return wrong_columns(row, "time [s] and acceleration", file);
    }
  } // namespace


  Motion read_text_motion(const std::string &file, const double unit, double *const first_time)
  {
    refuse_at2(file);
    const std::vector<TableRow> rows = read_text_table(file);
    if (rows.size() < 2)
      throw InputError(file,
                       0,
                       "found " + std::to_string(rows.size()) +
                         (rows.size() == 1 ? " sample" : " samples") +
                         "; a motion needs at least two rows of time and acceleration.");
    std::vector<double> t, a;
    for (const TableRow &row : rows)
      {
        if (row.fields.size() != 2)
          throw wrong_columns_of_motion(row, file);
        t.push_back(to_number(row.fields[0], "a time [s]", file, row.line));
        a.push_back(to_acceleration(row.fields[1], unit, file, row.line));
      }
    check_spacing(file, rows, t);
    if (first_time != nullptr)
      *first_time = t.front();
    return Motion((t.back() - t.front()) / (t.size() - 1), a);
  }


  Motion read_at2_motion(const std::string &file)
  {
    std::ifstream stream(file);
    if (!stream)
      throw InputError(file, 0, "the file cannot be read.");
    const At2Header header = read_at2_header(stream, file);

    std::vector<double> a;
    std::string         text;
    for (int line = header.lines + 1; std::getline(stream, text); ++line)
      for (const std::string &field : split_fields(text))
        a.push_back(to_acceleration(field, header.unit, file, line));
    if (a.size() != header.points)
      throw InputError(file,
                       header.lines,
                       "the header announces " + std::to_string(header.points) +
                         " points, but the file has " + std::to_string(a.size()) + ".");
    return Motion(header.dt, a);
  }

} // namespace hybrid::scene
