// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/linear_table.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    double number_in_column(const TableRow    &row,
                            const int          column,
                            const ColumnRange &range,
                            const std::string &file)
    {
      const std::string &text  = row.fields[column];
      const double       value = to_number(text, range.name, file, row.line);
      if (std::abs(value) > range.largest)
        throw InputError(file,
                         row.line,
                         range.name + " = " + text + " must be between -" +
                           std::to_string(std::lround(range.largest)) + " and " +
                           std::to_string(std::lround(range.largest)) + ".");
      return value;
    }



    double extreme(const std::vector<Vec2> &points, const bool highest)
    {
      double found = points.front().y();
      for (const Vec2 &point : points)
        found = highest ? std::max(found, point.y()) : std::min(found, point.y());
      return found;
    }
  } // namespace



  double LinearTable::operator()(const double place) const
  {
    if (place <= points.front().x())
      return points.front().y();
    if (place >= points.back().x())
      return points.back().y();
    const auto next =
      std::upper_bound(points.begin(), points.end(), place, [](const double x, const Vec2 &point) {
        return x < point.x();
      });
    const Vec2 &a = *(next - 1), &b = *next;
    return a.y() + (place - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
  }



  double LinearTable::lowest() const
  {
    return extreme(points, false);
  }



  double LinearTable::highest() const
  {
    return extreme(points, true);
  }



  double LinearTable::highest_between(const double from, const double to) const
  {
    double found = std::max((*this)(from), (*this)(to));
    for (const Vec2 &point : points)
      if (point.x() > from && point.x() < to)
        found = std::max(found, point.y());
    return found;
  }



  LinearTable
  read_linear_table(const std::string &file, const ColumnRange &place, const ColumnRange &value)
  {
    const std::vector<TableRow> rows = read_text_table(file);
    if (rows.empty())
      throw InputError(file,
                       0,
                       "the table has no row; at least one of " + place.name + " and " +
                         value.name + " is needed.");
    LinearTable table;
    for (const TableRow &row : rows)
      {
        if (row.fields.size() != 2)
          throw wrong_columns(row, place.name + " and " + value.name, file);
        const Vec2 point(number_in_column(row, 0, place, file),
                         number_in_column(row, 1, value, file));
        if (!table.points.empty() && !(point.x() > table.points.back().x()))
          throw InputError(file,
                           row.line,
                           place.name + " = " + row.fields[0] +
                             " is not above that of the row before; it must rise from row to row.");
        table.points.push_back(point);
      }
    return table;
  }
} // namespace hybrid::scene
