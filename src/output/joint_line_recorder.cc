// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/joint_line_recorder.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hybrid::output
{
  JointLineRecorder::JointLineRecorder(const dda::Model *blocks, const double slip_threshold)
    : model(blocks)
    , threshold(slip_threshold)
  {
    if (blocks == nullptr)
      return;
    for (const dda::JointLine &line : blocks->joint_lines)
      lines.push_back({&line, ways(blocks->initial, line)});
  }



  Vec2 JointLineRecorder::place(const dda::JointLine::Edge &edge) const
  {
    const dda::Geometry &g = model->initial;
    return 0.5 * (g.vertices[edge.vertex] + g.vertices[g.next(edge.vertex)]);
  }



  JointLineRecorder::Ways JointLineRecorder::ways(const dda::Geometry  &g,
                                                  const dda::JointLine &line)
  {
    Ways found;
    for (const dda::JointLine::Edge &edge : line.edges)
      {
        const Vec2 &first = g.vertices[edge.vertex], &second = g.vertices[g.next(edge.vertex)];
        const Vec2  along = (second - first).normalized(), outward(along.y(), -along.x());
        const Vec2  way =
          0.5 * (g.vertices[edge.twin] + g.vertices[g.next(edge.twin)] - first - second);
        // Outlines run counterclockwise: along -x where the other block is the upper one.
        found.slip.push_back(-way.dot(along));
        found.opening.push_back(way.dot(outward));
      }
    return found;
  }



  JointLineRecorder::Ways JointLineRecorder::since_rest(const dda::DdaState &state,
                                                        const Line          &line)
  {
    Ways now = ways(state.geometry, *line.edges);
    for (std::size_t k = 0; k < now.slip.size(); ++k)
      {
        now.slip[k] -= line.at_rest.slip[k];
        now.opening[k] -= line.at_rest.opening[k];
      }
    return now;
  }



  void JointLineRecorder::add_series(HistoryFile &file)
  {
    for (Line &line : lines)
      {
        const dda::Geometry &g = model->initial;
        std::vector<double>  position, length;
        for (const dda::JointLine::Edge &edge : line.edges->edges)
          {
            const Vec2 middle = place(edge);
            position.insert(position.end(), {middle.x(), middle.y()});
            length.push_back((g.vertices[g.next(edge.vertex)] - g.vertices[edge.vertex]).norm());
          }
        const std::size_t n    = length.size();
        const std::string path = "joint_lines/" + line.edges->name + "/";
        file.write_table(
          path + "position", "m", position.data(), n, 2, "middle of each edge, initial");
        file.write_table(path + "length", "m", length.data(), n, 1, "of each edge");
        line.slip_series    = file.add_series(path + "slip", "m", n, "of the upper side along +x");
        line.opening_series = file.add_series(path + "opening", "m", n, "parting positive");
      }
    if (lines.empty())
      return;
    time_series = file.add_series("joint_lines/time", "s", 1, "times of the pictures");
    file.set_attribute("joint_lines", "threshold", std::vector<double>{threshold});
  }



  void JointLineRecorder::set_reference(const dda::DdaState &state)
  {
    for (Line &line : lines)
      line.at_rest = ways(state.geometry, *line.edges);
  }



  void
  JointLineRecorder::record(const dda::DdaState &state, const double time, HistoryFile &file) const
  {
    if (lines.empty())
      return;
    file.append(time_series, &time);
    for (const Line &line : lines)
      {
        const Ways now = since_rest(state, line);
        file.append(line.slip_series, now.slip.data());
        file.append(line.opening_series, now.opening.data());
      }
  }



  void JointLineRecorder::summarize(const dda::DdaState &state, Summary &summary) const
  {
    for (const Line &line : lines)
      {
        const Ways          now  = since_rest(state, line);
        Summary::PlaneSlip &left = summary.joint_lines[line.edges->name];
        for (std::size_t k = 0; k < now.slip.size(); ++k)
          {
            left.opening_left = std::max(left.opening_left, now.opening[k]);
            if (k > 0 && !(std::abs(now.slip[k]) > std::abs(left.largest_left)))
              continue;
            const Vec2 middle = place(line.edges->edges[k]);
            left.largest_left = now.slip[k];
            left.where        = {{middle.x(), middle.y()}};
          }
      }
  }



  void JointLineRecorder::serialize(restart::Archive &archive)
  {
    for (Line &line : lines)
      archive(line.at_rest.slip, line.at_rest.opening);
  }
} // namespace hybrid::output
