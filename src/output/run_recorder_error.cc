// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/block_strikes.h>
#include <hybrid/output/mesh_dispersion.h>
#include <hybrid/output/probable_error.h>
#include <hybrid/output/run_recorder.h>
#include <hybrid/scene/mesh/reentrant_corner.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace hybrid::output
{
  namespace
  {
    constexpr std::size_t least_rows       = 20;
    constexpr double      largest_friction = 0.05; ///< of all that was lost inside [-]
    constexpr double      largest_abrupt   = 0.02; ///< of the peak acceleration, at once [-]
    constexpr double      largest_fracture = 0.05; ///< of all that the blocks lost [-]
    constexpr double      flutter_friction = 15.;  ///< undamped blocks do above 18 degrees [deg]
    constexpr double      flutter_damping  = 0.08; ///< ends it, over tan phi (doc/accuracy.md) [-]



    /// Parts of what a run lost, by name; 0 if it has none.
    double lost(const EnergyLedger &ledger, const std::string &name)
    {
      return std::max(ledger.value(name), 0.);
    }



    /// What went the first of these ways, of what went all of them [-].
    double part_of_first(const EnergyLedger &ledger, const std::vector<std::string> &ways)
    {
      double total = 0.;
      for (const std::string &way : ways)
        total += lost(ledger, way);
      return total > 0. ? lost(ledger, ways.front()) / total : 0.;
    }



    /// Of what is lost within the model [-].
    double part_of_friction(const EnergyLedger &ledger)
    {
      return part_of_first(ledger,
                           {"friction_loss", "blocks_damping_loss", "bedrock_damping_loss"});
    }



    /// Steepest friction of the mass on the ground, tan phi [-]: of its belts, or without any of
    /// contacts.
    double friction_on_ground(const dda::Model &model)
    {
      double result = 0.;
      for (const dda::Joint &joint : model.joints)
        if (joint.kind == dda::JointKind::belt)
          result = std::max(result, joint.law.friction({}));
      if (result > 0.)
        return result;
      std::set<int> surfaces(model.contacts.segment.begin(), model.contacts.segment.end());
      surfaces.insert(model.contacts.edge.begin(), model.contacts.edge.end());
      for (const int surface : surfaces)
        if (surface >= 0)
          for (const dda::ContactLaw &contact : model.contacts.of[surface])
            result = std::max(result, contact.law.friction({}));
      return result;
    }



    /// Blocks with little damping that slide on steep friction flutter as soon as steps resolve it
    /// (doc/verification/flutter.md). What these steps do not resolve, vibrations of more than
    /// 1/step, has a damping ratio of at least half of damping time over step; that of Maxwell
    /// branches ends with their band.
    bool may_flutter(const dda::Model *model, const double time_step)
    {
      if (model == nullptr)
        return false;
      const double friction   = friction_on_ground(*model);
      const double least_time = 2. * time_step * flutter_damping * friction;
      bool         any        = false;
      for (int b = 0; b < model->n_mass(); ++b)
        any = any || (model->blocks[b].damping_time < least_time &&
                      (model->bonded[b] || !model->damps_loose));
      return any && friction > std::tan(flutter_friction * M_PI / 180.);
    }



    int count_loose(const dda::Model *model)
    {
      int result = 0;
      for (int b = 0; model != nullptr && b < model->n_mass(); ++b)
        result += model->bonded[b] ? 0 : 1;
      return result;
    }



    std::string in_percent(const double part)
    {
      return std::to_string(std::lround(100. * part)) + " %";
    }



    /// What shakes a scene, as ErrorRecord::source; empty: it is set off at t = 0.
    std::function<double(double)> shaking(const scene::SceneParameters &scene,
                                          const scene::GroundMotion    &motion)
    {
      if (!motion.empty())
        {
          const double angle = scene.motion.angle * M_PI / 180.;
          const Vec2   along(std::cos(angle), std::sin(angle));
          return
            [&motion, along](const double t) { return motion.outcrop_displacement(t).dot(along); };
        }
      if (scene.point_loads.loads.empty() || !scene.has_continuum())
        return {};
      const double f = scene.point_loads.frequency, middle = scene.point_loads.start + 1.5 / f;
      return [f, middle](const double t) { // its rate is the wavelet
        const double x = M_PI * f * (t - middle);
        return (t - middle) * std::exp(-x * x);
      };
    }



    /// What acts besides what ErrorRecord::source tells of: how the model answers it is not known.
    /// Empty: nothing does, or all is set off at t = 0.
    std::string other_source(const scene::SceneParameters &scene, const scene::GroundMotion &motion)
    {
      const bool has_loads = !scene.point_loads.loads.empty() && scene.has_continuum();
      if (!motion.empty() && has_loads)
        return "point loads act beside the motion";
      if (scene.initial_wave.type == scene::WaveType::none || (motion.empty() && !has_loads))
        return "";
      return motion.empty() ? "an initial wave comes beside the point loads"
                            : "an initial wave comes beside the motion";
    }



    /// Accelerations, pairs at the ends of steps, are those of the motion but for round-off.
    bool are_led(const std::vector<double> &times,
                 const std::vector<double> &accelerations,
                 const scene::GroundMotion &motion)
    {
      constexpr double round_off = 1e-9;
      double           largest = 0., difference = 0.;
      for (std::size_t i = 0; !motion.empty() && i < times.size(); ++i)
        {
          const Vec2 led = motion.outcrop_acceleration(times[i]);
          largest        = std::max(largest, led.norm());
          difference =
            std::max(difference,
                     (Vec2(accelerations[2 * i], accelerations[2 * i + 1]) - led).norm());
        }
      return difference < round_off * largest;
    }



    /// Of its peak, the acceleration that a motion begins with [-].
    double abrupt_part(const scene::Motion &motion)
    {
      return motion.peak_acceleration() > 0.
               ? std::abs(motion.samples().front()) / motion.peak_acceleration()
               : 0.;
    }



    /// The waves of the bedrock are P waves: shaken steeply, or begun as such.
    bool shakes_p_waves(const RunParts &parts)
    {
      if (parts.motion.empty())
        return parts.scene.initial_wave.type == scene::WaveType::pressure;
      return std::abs(std::sin(parts.scene.motion.angle * M_PI / 180.)) > std::sqrt(0.5);
    }



    StepScheme step_scheme(const RunParts &parts, const std::vector<double> &time)
    {
      StepScheme scheme;
      scheme.newmark = parts.scene.time.newmark;
      double sum = 0., cubes = 0.; // an error of second order counts the mean of the squares
      for (std::size_t i = 1; i < time.size(); ++i)
        {
          const double dt = time[i] - time[i - 1];
          sum += dt;
          cubes += dt * dt * dt;
        }
      scheme.dt = std::sqrt(cubes / sum);
      if (parts.blocks != nullptr)
        for (const dda::BlockProperties &block : parts.blocks->blocks)
          scheme.late_damping += block.damping_time / parts.blocks->n_blocks();
      if (parts.continuum != nullptr && parts.scene.continuum.is_explicit)
        scheme.late_damping = parts.scene.continuum.rayleigh_stiffness;
      return scheme;
    }



    /// Errors of the finite elements where these are.
    Summary::ErrorPart mesh_error(const RunParts &parts, const ProbableError &estimate)
    {
      const auto   resolution = parts.continuum->resolution();
      const double cell_time =
        resolution.cell_time * (shakes_p_waves(parts) ? resolution.p_time / resolution.s_time : 1.);
      const int degree = parts.scene.continuum.degree;
      return estimate.in_rock(
        [&](const std::complex<double> s) {
          return mesh_frequency_error(degree,
                                      cell_time,
                                      s,
                                      parts.scene.continuum.is_explicit ? ElementMass::diagonal
                                                                        : ElementMass::consistent);
        },
        M_PI * degree / cell_time);
    }


    /// Empty: it tells how the model answers.
    std::string why_record_does_not_do(const ProbableError &estimate)
    {
      const std::string hardly_begun = estimate.hardly_begun();
      if (!hardly_begun.empty())
        return "the run ends as the motion begins at " + hardly_begun;
      const std::string reached = estimate.reached_at_end();
      return reached.empty() ? "" : "the run ends as a wave reaches " + reached;
    }



    /// Of the step and half of it, and of the finite elements; or the reason why this run does not
    /// tell it.
    void estimate_by_this_run(const RunParts         &parts,
                              const ErrorRecord      &record,
                              Summary::ProbableError &error)
    {
      const ProbableError estimate(record);
      error.reason = why_record_does_not_do(estimate);
      if (!error.reason.empty())
        {
          error.runs_would_do = true;
          return;
        }
      StepScheme   scheme = step_scheme(parts, record.time);
      const double step   = scheme.dt; // which may be divided into parts
      const auto   take   = [&](const double dt) {
        scheme.dt = dt;
        if (parts.continuum == nullptr)
          return;
        scheme.dt          = dt / parts.continuum->parts_of_step(dt);
        scheme.uncorrected = parts.continuum->uncorrected_part(dt, shakes_p_waves(parts));
      };
      take(step);
      error.step = estimate.of_steps(scheme);
      take(0.5 * step);
      if (parts.continuum != nullptr)
        error.parts = parts.continuum->parts_of_step(parts.scene.time.time_step);
      if (scheme.newmark.corrected_step > 0.)
        scheme.newmark.corrected_step *= 0.5;
      error.half_step = estimate.of_steps(scheme);
      if (parts.continuum != nullptr && parts.scene.point_loads.loads.empty())
        {
          error.mesh             = mesh_error(parts, estimate);
          error.mesh_has_corners = scene::has_reentrant_corner(parts.mesh);
        }
      if (std::isnan(error.step.part[1]))
        error.reason = "nothing moves";
    }
  } // namespace



  std::string RunRecorder::why_no_error(const bool any_monitor) const
  {
    const scene::SceneParameters &scene = parts.scene;
    if (scene.time.dynamic_coefficient < 1.)
      return "Time/Dynamic coefficient damps step by step";
    if (times.size() < least_rows || !any_monitor)
      return any_monitor                 ? "the run is too short"
             : points_of_error().empty() ? "there is no monitor, and nothing that moves to watch"
             : monitors.empty()          ? "no joint holds a block that is watched"
                                         : "all monitors are on blocks that no joint holds";
    if (parts.blocks != nullptr && !scene.edge_loads.tractions.empty())
      return "edge loads set the pace";
    if (parts.blocks != nullptr && parts.blocks->water.changes())
      return "the level of the water sets the pace";
    if (parts.blocks != nullptr && !parts.blocks->moving_blocks.empty())
      return "blocks fly";
    if (!scene.motion.vertical_file.empty())
      return "the motion has two components";
    const double at_once = abrupt_part(parts.motion.outcrop());
    if (at_once > largest_abrupt)
      return "the motion begins at once with " + in_percent(at_once) + " of its peak acceleration";
    const std::string besides = other_source(scene, parts.motion);
    if (!besides.empty())
      return besides;
    if (lost(ledger, "bedding_loss") > 0.)
      return "bedding planes slip or open";
    const bool fourth_order =
      scene.time.newmark.corrected_step > 0. && !scene.continuum.is_explicit;
    if (fourth_order && !scene.bedding.names.empty())
      return "elastic bedding planes have errors of their own under fourth order";
    if (scene.blocks.enabled && scene.environment.static_stage == scene::StaticStage::none &&
        scene.environment.gravity != 0.)
      return "the weight acts at once";
    const double friction = part_of_friction(ledger);
    if (friction > largest_friction)
      return "friction takes " + in_percent(friction) + " of the energy that is lost inside";
    const double fracture =
      part_of_first(ledger, {"fracture_loss", "friction_loss", "blocks_damping_loss"});
    if (fracture > largest_fracture)
      return "joints that crack take " + in_percent(fracture) +
             " of the energy that the blocks lose";
    return "";
  }



  void RunRecorder::estimate_error(Summary &summary) const
  {
    ErrorRecord record;
    record.time               = times;
    record.source             = shaking(parts.scene, parts.motion);
    record.corner             = parts.scene.monitors.filter_frequency;
    record.until              = summary.first_loss_time;
    record.base_is_prescribed = !parts.motion.empty() && !parts.scene.has_compliant_base();
    const std::vector<MonitorSeries> &points  = points_of_error();
    int                               n_loose = 0; // points on blocks that no joint holds
    for (std::size_t m = 0; m < points.size(); ++m)
      {
        const int block = probes.block(points[m].probe);
        if (block >= 0 && !parts.blocks->bonded[block])
          {
            ++n_loose;
            continue;
          }
        if (static_cast<int>(m) == base_of_error())
          record.base = static_cast<int>(record.monitors.size());
        record.monitors.push_back({points[m].name,
                                   &points[m].histories[0],
                                   block < 0,
                                   are_led(times, points[m].histories[2], parts.motion)});
      }
    Summary::ProbableError &error = summary.probable_error;
    if (monitors.empty())
      record.least_motion = WatchedPoints::least_motion;
    const bool has_base_alone = n_loose > 0 && record.monitors.size() == 1 && record.base == 0;
    error.reason              = why_no_error(!record.monitors.empty() && !has_base_alone);
    if (error.reason.empty() && n_loose > 0 && !monitors.empty())
      error.reason = std::to_string(n_loose) + " of " + std::to_string(monitors.size()) +
                     " monitors are on blocks that no joint holds";
    WatchedPoints counted = watched;
    counted.of_mass -= error.reason.empty() && monitors.empty() ? n_loose : 0;
    error.watched       = counted.text();
    error.blocks_strike = blocks_strike(count_loose(parts.blocks), ledger);
    if (parts.scene.time.newmark.corrected_step > 0.)
      error.assumed_order = 2.; // of joints; waves have more
    if (!error.reason.empty())
      {
        const bool is_damped = parts.scene.time.dynamic_coefficient < 1.;
        error.may_flutter    = part_of_friction(ledger) > largest_friction && !is_damped &&
                            may_flutter(parts.blocks, parts.scene.time.time_step);
        error.runs_would_do = times.size() >= least_rows && !points.empty() && !is_damped;
        return;
      }
    error.until = record.until;
    if (error.until <= record.time[least_rows - 1])
      {
        error.reason =
          "a joint failed in one of the first " + std::to_string(least_rows) + " steps";
        return;
      }
    estimate_by_this_run(parts, record, error);
  }



  StepRecord RunRecorder::step_record(const double until) const
  {
    StepRecord record;
    record.step = parts.scene.time.time_step;
    record.time = times;
    record.base = base_of_error();
    if (monitors.empty())
      record.least_motion = WatchedPoints::least_motion;
    record.corner = parts.scene.monitors.filter_frequency;
    record.until  = until;
    for (const MonitorSeries &monitor : points_of_error())
      record.monitors.push_back(
        {monitor.name, {{monitor.histories[0], monitor.histories[1], monitor.histories[2]}}});
    return record;
  }
} // namespace hybrid::output
