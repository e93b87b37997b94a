// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/parameters/parameter_declarations.h>

#include <algorithm>
#include <set>
#include <utility>

namespace hybrid::scene
{
  namespace
  {
    void add_named_points(const std::string &text, MonitorParameters &monitors)
    {
      for (const auto &row : parse_rows(text, 2))
        monitors.monitors.push_back({row.first, Vec2(row.second[0], row.second[1])});
    }

    void add_points_of_file(const std::string &text, MonitorParameters &monitors)
    {
      const std::vector<std::string> names = parse_names(text);
      if (names.empty() && monitors.file.empty())
        return;
      if (monitors.file.empty())
        throw InputError("needs the CSV file with these points in Monitors/File");
      if (names.empty())
        throw InputError("must list the rows of Monitors/File that are monitors");
      for (const auto &point : read_points(monitors.file, names))
        monitors.monitors.push_back({point.first, point.second});
    }

    void add_line(MonitorParameters &monitors, const std::string &name, std::vector<Vec2> points)
    {
      for (const MonitorLine &line : monitors.lines)
        if (line.name == name)
          throw InputError("line '" + name + "' is given twice");
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        if (points[k] == points[k + 1])
          throw InputError("line '" + name + "' has the same point twice in a row");
      monitors.lines.push_back({name, std::move(points)});
    }

    void add_lines_of_file(MonitorParameters &monitors)
    {
      for (auto &[name, points] : read_polylines(monitors.lines_file))
        {
          if (points.size() < 2)
            throw InputError("line '" + name +
                             "' of Monitors/Lines file has one point but must "
                             "have two or more");
          add_line(monitors, name, std::move(points));
        }
    }

    void add_lines(const std::string &text, MonitorParameters &monitors)
    {
      for (const std::string &part : split(text, ';'))
        {
          if (part.empty()) // after the last ';', or nothing at all
            continue;
          const std::size_t colon = part.find(':');
          const auto        names = parse_names(part.substr(0, colon));
          if (names.size() != 1)
            throw InputError("'" + part + "' must have the form 'name' or 'name: x, y, x, y, ...'");
          std::vector<double> numbers;
          if (colon != std::string::npos)
            for (const std::string &word : split(part.substr(colon + 1), ','))
              {
                const std::optional<double> number = parse_number(word);
                if (!number)
                  throw InputError("'" + word + "' of '" + names[0] + "' must be a number");
                numbers.push_back(*number);
              }
          if (colon != std::string::npos && (numbers.size() < 4 || numbers.size() % 2 != 0))
            throw InputError("'" + names[0] + "' has " + std::to_string(numbers.size()) +
                             " numbers but must have x, y of two points or more");
          std::vector<Vec2> points;
          for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
            points.emplace_back(numbers[k], numbers[k + 1]);
          add_line(monitors, names[0], std::move(points));
        }
      if (!monitors.lines_file.empty())
        add_lines_of_file(monitors);
    }

    void add_boreholes(const std::string &text, MonitorParameters &monitors)
    {
      for (const auto &row : parse_rows(text, 4))
        {
          const std::vector<double> &x = row.second;
          if (x[0] != x[2] || x[1] <= x[3])
            throw InputError("'" + row.first +
                             "' must run vertically down: x, top, x, bottom with top > bottom");
          Borehole borehole;
          borehole.name    = row.first;
          borehole.top     = Vec2(x[0], x[1]);
          borehole.bottom  = Vec2(x[2], x[3]);
          borehole.samples = monitors.borehole_samples;
          monitors.boreholes.push_back(borehole);
        }
    }

    void add_measured_values(const std::string &text, MonitorParameters &monitors)
    {
      for (const auto &row : parse_rows(text, 2, 1))
        {
          const auto hole = std::find_if(monitors.boreholes.begin(),
                                         monitors.boreholes.end(),
                                         [&](const Borehole &b) { return b.name == row.first; });
          if (hole == monitors.boreholes.end())
            throw InputError("'" + row.first + "' is no borehole of Boreholes/Lines");
          hole->measured_depth.push_back(row.second[0]);
          hole->measured_mm.push_back(row.second[1]);
          if (row.second[2] < 0.)
            throw InputError("the error of '" + row.first + "' must not be negative");
          hole->measured_error_mm.push_back(row.second[2]);
        }
    }
  } // namespace

  void declare(ParameterTable &table, MonitorParameters &monitors)
  {
    ParameterSection section(table, {"Monitors"});
    section.value(
      "Points",
      "'name: x, y; name: x, y; ...' [m]",
      [&monitors](const std::string &text) { add_named_points(text, monitors); },
      "Points whose motion is recorded.");
    section.file("File",
                 monitors.file,
                 "a CSV file name,x,z [m]",
                 "More such points; Names picks the rows.");
    section.value(
      "Names",
      "names separated by commas",
      [&monitors](const std::string &text) { add_points_of_file(text, monitors); },
      "Rows of the file that are monitors.");
    section.text("Base",
                 monitors.base_monitor,
                 "a monitor's name, or empty",
                 "Displacement is reported relative to this monitor; empty: absolute.");
    section.number("Filter frequency",
                   monitors.filter_frequency,
                   "Hz",
                   ParameterRange::at_least(0.),
                   "Zero-phase low-pass for peaks and amplification; 0 is off.");
    section.toggle("Peak fields",
                   monitors.has_peak_fields,
                   "Largest acceleration, velocity, displacement and slip at every node of the "
                   "bedrock and every block: group fields of run.h5, and peaks.vtu.");
    section.file("Lines file",
                 monitors.lines_file,
                 "a CSV file name,x,z [m]",
                 "Polylines along which motion is recorded, as by Lines; rows of one name are one "
                 "line.");
    section.value(
      "Lines",
      "'name; name: x, y, x, y, ...; ...' [m]",
      [&monitors](const std::string &text) { add_lines(text, monitors); },
      "Lines along which displacement and acceleration are recorded: a line of the mesh by its name, "
      "or a polyline. Bedding planes and the sliding surface have both sides.");
    section.integer("Line points",
                    monitors.line_points,
                    {0, 100000},
                    "Points of each line, equally far apart; 0: the nodes of the mesh, or the "
                    "points given. One point is the middle.");
    section.number(
      "Line interval",
      monitors.line_interval,
      "s",
      ParameterRange::at_least(0.),
      "Between recorded rows of lines, rounded to whole steps; 0: every step. Where it "
      "is longer than a step, accelerations are means since the row before.");

    ParameterSection boreholes(table, {"Boreholes"});
    boreholes.integer("Samples", monitors.borehole_samples, {2, 10000}, "Points per borehole.");
    boreholes.value(
      "Lines",
      "'name: x, top, x, bottom; ...' [m]",
      [&monitors](const std::string &text) { add_boreholes(text, monitors); },
      "Vertical lines along which displacement is recorded.");
    boreholes.value(
      "Measured",
      "'name: depth, displacement, error; ...' [m, mm downhill, mm]",
      [&monitors](const std::string &text) { add_measured_values(text, monitors); },
      "Measured values that are drawn beside the computed profiles, with their error either way, "
      "which may be left out; nothing else uses them.");
  }

  void check(const MonitorParameters &monitors, const ParameterTable &table)
  {
    std::vector<std::string> names;
    std::set<std::string>    seen;
    for (const Monitor &monitor : monitors.monitors)
      {
        names.push_back(monitor.name);
        if (!seen.insert(monitor.name).second)
          throw table.error("Monitors/Names",
                            "'" + monitor.name + "' is a monitor of Monitors/Points already");
      }
    if (!monitors.base_monitor.empty() && seen.count(monitors.base_monitor) == 0)
      throw table.error("Monitors/Base",
                        "no such monitor" + suggestion(monitors.base_monitor, names));
  }
} // namespace hybrid::scene
