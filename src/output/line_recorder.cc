// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/line_recorder.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// Steps from row to row.
    double steps_per_row(const scene::SceneParameters &scene)
    {
      return std::max(1., std::round(scene.monitors.line_interval / scene.time.time_step));
    }
  } // namespace



  double LineRecorder::interval(const scene::SceneParameters &scene)
  {
    return steps_per_row(scene) * scene.time.time_step;
  }



  double LineRecorder::numbers_per_row(const scene::SceneParameters &scene,
                                       const scene::SectionMesh     &mesh)
  {
    double numbers = 0.;
    for (const SampleLine &line : sample_lines(scene, mesh))
      numbers += 4. * static_cast<double>(line.points.size()) * (line.has_sides ? 2. : 1.);
    return numbers;
  }



  LineRecorder::LineRecorder(const scene::SceneParameters &scene,
                             const scene::SectionMesh     &mesh,
                             Probes                       &all_probes)
    : probes(all_probes)
    , is_every_step(steps_per_row(scene) == 1.)
    , spacing(interval(scene))
    , next_row(spacing)
  {
    for (SampleLine &points : sample_lines(scene, mesh))
      {
        Line line;
        for (LineSide &side : add_line_probes(points, all_probes))
          {
            line.names.push_back(side.name);
            line.sides.push_back({std::move(side.probes), {}});
          }
        line.points = std::move(points);
        lines.push_back(std::move(line));
      }
  }



  void LineRecorder::add_series(HistoryFile &file)
  {
    if (lines.empty())
      return;
    time = file.add_series("lines/time", "s", 1, "times of the rows");
    file.set_attribute("lines",
                       "acceleration",
                       is_every_step ? "at the end of the step" : "mean since the row before");
    for (Line &line : lines)
      {
        const std::string   path = "lines/" + line.points.name + "/";
        const std::size_t   n    = line.points.points.size();
        std::vector<double> position, tangent;
        for (std::size_t k = 0; k < n; ++k)
          {
            position.insert(position.end(), {line.points.points[k].x(), line.points.points[k].y()});
            tangent.insert(tangent.end(),
                           {line.points.tangents[k].x(), line.points.tangents[k].y()});
          }
        file.write_table(path + "position", "m", position.data(), n, 2, "points of the line");
        file.write_table(path + "tangent", "1", tangent.data(), n, 2, "above is to its left");
        file.write_table(
          path + "distance", "m", line.points.distance.data(), n, 1, "along the line");
        for (std::size_t s = 0; s < line.sides.size(); ++s)
          {
            Side             &side      = line.sides[s];
            const std::string side_path = path + line.names[s] + "/";
            side.displacement           = file.add_series(side_path + "displacement",
                                                "m",
                                                2 * n,
                                                "absolute, pairs",
                                                HistoryFile::Precision::single);
            side.acceleration           = file.add_series(side_path + "acceleration",
                                                "m/s2",
                                                2 * n,
                                                "absolute, pairs",
                                                HistoryFile::Precision::single);
          }
      }
  }



  void LineRecorder::start(const coupling::CoupledState &state)
  {
    last_row = state.time;
    next_row = state.time + spacing;
    if (is_every_step)
      return;
    for (Line &line : lines)
      for (Side &side : line.sides)
        for (const int probe : side.probes)
          side.velocity.push_back(probes.sample(state, probe).velocity);
  }



  void LineRecorder::record_side(const coupling::CoupledState &state, Side &side, HistoryFile &file)
  {
    const std::size_t n = side.probes.size();
    displacement.resize(2 * n);
    acceleration.resize(2 * n);
    for (std::size_t k = 0; k < n; ++k)
      {
        const PointMotion motion = probes.sample(state, side.probes[k]);
        Vec2              a      = motion.acceleration;
        if (!is_every_step)
          {
            a                = (motion.velocity - side.velocity[k]) / (state.time - last_row);
            side.velocity[k] = motion.velocity;
          }
        for (int c = 0; c < 2; ++c)
          {
            displacement[2 * k + c] = motion.displacement[c];
            acceleration[2 * k + c] = a[c];
          }
      }
    file.append(side.displacement, displacement.data());
    file.append(side.acceleration, acceleration.data());
  }



  void LineRecorder::record(const coupling::CoupledState &state, const double dt, HistoryFile &file)
  {
    const double early = 1e-6 * dt, now = state.time;
    if (lines.empty() || (!is_every_step && now < next_row - early))
      return;
    while (next_row <= now + early)
      next_row += spacing;
    file.append(time, &now);
    for (Line &line : lines)
      for (Side &side : line.sides)
        record_side(state, side, file);
    last_row = now;
  }



  void LineRecorder::serialize(restart::Archive &archive)
  {
    archive(next_row, last_row);
    for (Line &line : lines)
      for (Side &side : line.sides)
        archive(side.velocity);
  }
} // namespace hybrid::output
