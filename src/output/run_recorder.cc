// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/blocks_off_base.h>
#include <hybrid/output/failed_joints.h>
#include <hybrid/output/input_tables.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/output/section_tables.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/downhill.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  RunRecorder::RunRecorder(const RunParts &run, const HistoryFile::Mode mode)
    : parts(run)
    , probes(run.blocks, run.continuum, run.foundation)
    , file(run.scene.output.directory + "/run.h5", mode)
    , pictures(run.scene.output.directory, run.blocks, run.continuum)
    , downhill(run.blocks != nullptr && !run.blocks->soles.empty() ? run.blocks->downhill.shared()
                                                                   : scene::downhill_sign(run.mesh))
    , bedding(run.continuum,
              run.scene.bedding.slips ? run.blocks : nullptr,
              run.scene.bedding.names)
    , slip(run.blocks, run.scene.output.slip_threshold)
    , joint_lines(run.blocks, run.scene.output.slip_threshold)
    , lines(run.scene, run.mesh, probes)
    , peaks(run.scene.monitors.has_peak_fields ? run.blocks : nullptr,
            run.scene.monitors.has_peak_fields ? run.continuum : nullptr,
            run.scene.monitors.filter_frequency)
    , ledger(run.continuum != nullptr,
             {run.scene.continuum.boundary_springs,
              run.scene.has_bedrock_blocks(),
              bedding.has_planes(),
              !run.scene.edge_loads.tractions.empty(),
              run.blocks != nullptr && run.blocks->blocks_yield,
              run.blocks != nullptr && run.blocks->water.changes()})
    , last_flush(std::chrono::steady_clock::now())
  {
    file.set_attribute("/", "title", parts.scene.title);
    file.set_attribute("/", "base_monitor", parts.scene.monitors.base_monitor);
    file.set_attribute("/", "downhill_sign", std::vector<double>{downhill});
    add_series();
    write_spectrum(file, parts.fit, parts.scene.motion.outcrop);
    write_section_materials(file, parts.scene, parts.mesh, parts.blocks);
    if (parts.blocks != nullptr)
      {
        write_heterogeneity(file, parts.scene.heterogeneity, *parts.blocks);
        write_water(file, *parts.blocks);
        write_water_tables(file, parts.scene.environment.water_tables);
      }
    add_monitors();
    add_watched_points();
    add_boreholes();
    bedding.add_series(file);
    slip.add_series(file);
    joint_lines.add_series(file);
    lines.add_series(file);
  }



  void RunRecorder::add_series()
  {
    const char *energy_words =
      "change since t = 0, where the value was the attribute start; held and "
      "lost: positive, work from outside: negative; all terms sum to zero";
    time_series          = file.add_series("time", "s", 1, "end of each step");
    const char *names[3] = {"acceleration", "velocity", "displacement"};
    const char *units[3] = {"m/s2", "m/s", "m"};
    for (int k = 0; k < 3; ++k)
      input_series[k] =
        file.add_series(std::string("input/") + names[k], units[k], 2, "outcrop motion");
    step_series[0] = file.add_series("steps/dt", "s", 1, "step size");
    step_series[1] = file.add_series("steps/iterations", "1", 1, "open-close iterations");
    step_series[2] =
      file.add_series("steps/solver_iterations", "1", 1, "iterations of the linear solver");
    step_series[3]  = file.add_series("steps/wall_time", "s", 1, "wall time of the step");
    energy_time     = file.add_series("energy/time", "s", 1, "times of the audits");
    energy_residual = file.add_series("energy/residual", "1", 1, "relative residual of the audit");
    for (const std::string &name : ledger.names())
      energy_series.push_back(file.add_series("energy/" + name, "J/m", 1, energy_words));

    if (parts.blocks == nullptr || parts.blocks->n_foundation_nodes() == 0)
      return;
    std::vector<double> position;
    for (const Vec2 &node : parts.blocks->initial.foundation_nodes)
      position.insert(position.end(), {node.x(), node.y()});
    const std::size_t nodes = position.size() / 2;
    file.write_table(
      "interface/position", "m", position.data(), nodes, 2, "contact surface of the base");
    interface_time = file.add_series("interface/time", "s", 1, "times of the pictures");
    interface_force =
      file.add_series("interface/force", "N/m", 2 * nodes, "of the blocks on each node");
    interface_sum = file.add_series("interface/total_force",
                                    "N/m",
                                    2,
                                    "of the blocks on all nodes, end of each step");
  }



  void RunRecorder::add_boreholes()
  {
    for (const scene::Borehole &hole : parts.scene.monitors.boreholes)
      {
        Profile             profile;
        std::vector<double> depth;
        for (int k = 0; k < hole.samples; ++k)
          {
            const double fraction =
              hole.samples > 1 ? static_cast<double>(k) / (hole.samples - 1) : 0.;
            const Vec2 x = hole.top + fraction * (hole.bottom - hole.top);
            profile.probes.push_back(probes.add(x, hole.name + " sample " + std::to_string(k)));
            depth.push_back(hole.top.y() - x.y());
          }
        const std::string path = "profiles/" + hole.name;
        file.write_table(path + "/depth", "m", depth.data(), depth.size(), 1, "below the top");
        profile.row.resize(2 * depth.size());
        profile.series = file.add_series(path + "/displacement",
                                         "m",
                                         profile.row.size(),
                                         "relative to the base, pairs");
        file.set_attribute(
          path,
          "position",
          std::vector<double>{hole.top.x(), hole.top.y(), hole.bottom.x(), hole.bottom.y()});
        if (!hole.measured_mm.empty())
          {
            file.set_attribute(path, "measured_mm", hole.measured_mm);
            file.set_attribute(path, "measured_depth_m", hole.measured_depth);
            file.set_attribute(path, "measured_error_mm", hole.measured_error_mm);
          }
        profiles.push_back(std::move(profile));
      }
  }



  void RunRecorder::start(const coupling::CoupledState &state)
  {
    probes.set_reference(state);
    if (parts.blocks != nullptr)
      {
        pictures.set_reference(state.blocks);
        slip.set_reference(state.blocks, file);
        joint_lines.set_reference(state.blocks);
        for (const dda::BlockState &block : state.blocks.blocks)
          reference_centroids.push_back(block.centroid);
        peak_displacement.assign(reference_centroids.size(), 0.);
      }
    lines.start(state);
    peaks.start(state);
    record_energy(state);
    const std::vector<std::string> names = ledger.names();
    for (std::size_t k = 0; k < names.size(); ++k)
      file.set_attribute("energy/" + names[k], "start", std::vector<double>{ledger.at_start()[k]});
    record_picture(state);
    next_picture = parts.scene.output.picture_interval;
    next_audit   = parts.scene.output.audit_interval;
    file.flush();
  }



  Vec2 RunRecorder::base_displacement() const
  {
    if (base_monitor < 0 || monitors[base_monitor].histories[0].empty())
      return Vec2::Zero();
    const auto &u = monitors[base_monitor].histories[0];
    return {u[u.size() - 2], u[u.size() - 1]};
  }



  void RunRecorder::record_motion(const coupling::CoupledState &state)
  {
    const Vec2 input[3] = {parts.motion.outcrop_acceleration(state.time),
                           parts.motion.outcrop_velocity(state.time),
                           parts.motion.outcrop_displacement(state.time)};
    for (int k = 0; k < 3; ++k)
      file.append(input_series[k], input[k].data());
    input_acceleration.insert(input_acceleration.end(), {input[0].x(), input[0].y()});

    for (MonitorSeries &monitor : monitors)
      {
        const PointMotion m       = probes.sample(state, monitor.probe);
        const Vec2        pair[3] = {m.displacement, m.velocity, m.acceleration};
        for (int k = 0; k < 3; ++k)
          {
            file.append(monitor.series[k], pair[k].data());
            monitor.histories[k].insert(monitor.histories[k].end(), {pair[k].x(), pair[k].y()});
          }
      }
    for (MonitorSeries &point : watched_motion)
      {
        const PointMotion m       = probes.sample(state, point.probe);
        const Vec2        pair[3] = {m.displacement, m.velocity, m.acceleration};
        for (int k = 0; k < 3; ++k)
          point.histories[k].insert(point.histories[k].end(), {pair[k].x(), pair[k].y()});
      }
    const Vec2 base = base_displacement();
    for (Profile &profile : profiles)
      {
        for (std::size_t k = 0; k < profile.probes.size(); ++k)
          {
            const Vec2 u           = probes.sample(state, profile.probes[k]).displacement - base;
            profile.row[2 * k]     = u.x();
            profile.row[2 * k + 1] = u.y();
          }
        file.append(profile.series, profile.row.data());
      }
  }



  void RunRecorder::record_energy(const coupling::CoupledState &state)
  {
    const continuum::ContinuumEnergy bedrock  = parts.continuum != nullptr
                                                  ? parts.continuum->audit_energy(state.continuum)
                                                  : continuum::ContinuumEnergy();
    const std::vector<double>       &terms    = ledger.update(state, bedrock);
    const double                     residual = ledger.residual(), now = state.time;
    file.append(energy_time, &now);
    file.append(energy_residual, &residual);
    for (std::size_t k = 0; k < terms.size(); ++k)
      file.append(energy_series[k], &terms[k]);
    bedding.record(state, file);
    last_audit = now;
  }



  void RunRecorder::record_picture(const coupling::CoupledState &state)
  {
    const double now = last_picture = state.time;
    pictures.add(state);
    if (parts.blocks != nullptr)
      overlaps.look(state.blocks.geometry, now);
    slip.record_profile(state.blocks, now, file);
    joint_lines.record(state.blocks, now, file);
    if (interface_time < 0)
      return;
    file.append(interface_time, &now);
    file.append(interface_force, state.blocks.foundation_force.data());
  }



  void RunRecorder::record_total_force(const coupling::CoupledState &state)
  {
    if (interface_sum < 0)
      return;
    const Eigen::VectorXd &force = state.blocks.foundation_force;
    Vec2                   sum   = Vec2::Zero();
    for (Eigen::Index k = 0; k + 1 < force.size(); k += 2)
      sum += Vec2(force[k], force[k + 1]);
    file.append(interface_sum, sum.data());
  }



  void RunRecorder::update_peaks(const coupling::CoupledState &state)
  {
    const Vec2 base = base_displacement();
    for (std::size_t b = 0; b < peak_displacement.size(); ++b)
      peak_displacement[b] =
        std::max(peak_displacement[b],
                 (state.blocks.blocks[b].centroid - reference_centroids[b] - base).norm());
  }



  RunRecorder::Needs RunRecorder::needs(const double time, const double dt) const
  {
    return {is_audit_due(time, dt), is_picture_due(time, dt)};
  }



  bool RunRecorder::is_audit_due(const double time, const double dt) const
  {
    return time >= next_audit - early_of(dt);
  }



  bool RunRecorder::is_picture_due(const double time, const double dt) const
  {
    return parts.scene.output.picture_interval > 0. && time >= next_picture - early_of(dt);
  }



  void RunRecorder::record_step(const coupling::CoupledState &state,
                                const dda::StepResult        &step,
                                const double                  dt,
                                const double                  wall_time)
  {
    const double iterations = step.iterations, solver_iterations = step.solver_iterations;
    const double now = state.time;
    times.push_back(now);
    file.append(time_series, &now);
    file.append(step_series[0], &dt);
    file.append(step_series[1], &iterations);
    file.append(step_series[2], &solver_iterations);
    file.append(step_series[3], &wall_time);
    ledger.note_kinetic_of_blocks(state.blocks.energy.kinetic);
    record_motion(state);
    record_total_force(state);
    update_peaks(state);
    slip.record(state.blocks, file);
    lines.record(state, dt, file);
    peaks.record(state, dt, base_displacement());

    const double early = early_of(dt);
    if (is_audit_due(now, dt))
      {
        record_energy(state);
        const double interval = parts.scene.output.audit_interval;
        while (next_audit <= now + early)
          next_audit += std::max(interval, dt);
        if (interval < dt) // every step, also after one that is cut
          next_audit = now + interval;
      }
    if (is_picture_due(now, dt))
      {
        record_picture(state);
        while (next_picture <= now + early)
          next_picture += std::max(parts.scene.output.picture_interval, dt);
      }
    flush_if_due();
  }



  void RunRecorder::flush_if_due()
  {
    // A flush copies the whole file: the longer that takes, the rarer it is done.
    constexpr double max_fraction = 0.02; // of the wall time
    const auto       now          = std::chrono::steady_clock::now();
    const double interval = std::max(parts.scene.output.flush_interval, flush_cost / max_fraction);
    if (std::chrono::duration<double>(now - last_flush).count() <= interval)
      return;
    file.flush();
    last_flush = std::chrono::steady_clock::now();
    flush_cost = std::chrono::duration<double>(last_flush - now).count();
  }



  void RunRecorder::write_section(const coupling::CoupledState &state)
  {
    std::vector<double> outline;
    for (const auto &line : parts.mesh.lines)
      {
        if (line.first.rfind("bedding", 0) == 0 || line.first == "mass_surface")
          continue;
        for (const auto &edge : line.second)
          for (const int node : edge)
            outline.insert(outline.end(), {parts.mesh.nodes[node].x(), parts.mesh.nodes[node].y()});
      }
    if (!outline.empty())
      file.write_table(
        "section/outline", "m", outline.data(), outline.size() / 4, 4, "edges of the bedrock");
    write_surface(file, parts.mesh);
    if (parts.blocks == nullptr)
      return;
    const Vec2           base = base_displacement();
    const dda::Geometry &g    = parts.blocks->initial;
    std::vector<double>  points, final_points, displacement;
    for (const Vec2 &v : g.vertices)
      points.insert(points.end(), {v.x(), v.y()});
    for (const Vec2 &v : state.blocks.geometry.vertices)
      final_points.insert(final_points.end(), {v.x(), v.y()});
    for (std::size_t b = 0; b < reference_centroids.size(); ++b)
      {
        const Vec2 u = state.blocks.blocks[b].centroid - reference_centroids[b] - base;
        displacement.insert(displacement.end(), {u.x(), u.y()});
      }
    file.write_integers("section/blocks_offsets", g.offset, "first vertex");
    file.write_table("section/blocks_points", "m", points.data(), g.vertices.size(), 2, "initial");
    file.write_table(
      "section/blocks_points_final", "m", final_points.data(), g.vertices.size(), 2, "at the end");
    if (parts.blocks->blocks_yield)
      {
        std::vector<double> plastic;
        for (const dda::BlockState &block : state.blocks.blocks)
          plastic.push_back(block.plastic_strain);
        file.write_table("section/blocks_plastic_strain",
                         "1",
                         plastic.data(),
                         plastic.size(),
                         1,
                         "plastic shear strain at the end, static stage included");
      }
    file.write_table("section/blocks_displacement",
                     "m",
                     displacement.data(),
                     displacement.size() / 2,
                     2,
                     "of centroids at the end, relative to the base monitor if there is one");
    file.write_table("section/blocks_peak_displacement",
                     "m",
                     peak_displacement.data(),
                     peak_displacement.size(),
                     1,
                     "largest magnitude, relative to the base monitor if there is one");
    const scene::EnvironmentParameters &around = parts.scene.environment;
    if (around.has_level())
      file.set_attribute("section", "water_level", std::vector<double>{around.water_level});
  }



  void RunRecorder::write_joints(const coupling::CoupledState &state)
  {
    std::vector<double>  time, position, ends;
    std::vector<int>     kind;
    const dda::Geometry &g = parts.blocks->initial;
    for (std::size_t j = 0; j < parts.blocks->joints.size(); ++j)
      {
        const dda::JointState &s = state.blocks.joints[j];
        if (s.failure == dda::FailureKind::none)
          continue;
        const dda::Joint &joint = parts.blocks->joints[j];
        const Vec2        p     = joint_point(g, joint, joint.points[0]),
                   q            = joint_point(g, joint, joint.points[1]);
        time.push_back(s.failure_time);
        kind.push_back(s.failure == dda::FailureKind::tensile ? 1 : 2);
        position.insert(position.end(), {0.5 * (p.x() + q.x()), 0.5 * (p.y() + q.y())});
        ends.insert(ends.end(), {p.x(), p.y(), q.x(), q.y()});
      }
    file.write_table(
      "joints/failure_time", "s", time.data(), time.size(), 1, "negative: static stage");
    file.write_integers("joints/failure_kind", kind, "1 tensile, 2 shear");
    file.write_table("joints/position", "m", position.data(), time.size(), 2, "middle, initial");
    file.write_table("joints/ends", "m", ends.data(), time.size(), 4, "initial");
  }



  void RunRecorder::finish(const coupling::CoupledState &state, Summary &summary)
  {
    if (last_audit != state.time)
      record_energy(state);
    if (last_picture != state.time)
      record_picture(state);
    write_section(state);
    peaks.write(slip.largest_of_blocks(),
                file,
                parts.scene.output.directory +
                  (peaks.has_left_nodes() ? "/peaks_blocks.vtu" : "/peaks.vtu"));
    if (parts.blocks != nullptr)
      {
        write_joints(state);
        slip.finish(state.blocks, file, summary);
        joint_lines.summarize(state.blocks, summary);
        summary.deepest_overlap = {overlaps.deepest(), overlaps.time_of_deepest()};
        summary.blocks_off_base = blocks_off_base(*parts.blocks, state.blocks);
        count_failed_joints(*parts.blocks, state.blocks, summary);
      }
    bedding.summarize(state, summary);
    if (!times.empty())
      summarize_monitors(summary);
    file.flush();
    if (!times.empty())
      estimate_error(summary);

    summary.energy_residual = ledger.largest_residual();
    const auto names        = ledger.names();
    for (std::size_t k = 0; k < names.size(); ++k)
      summary.energy[names[k]] = ledger.values()[k];
  }
} // namespace hybrid::output
