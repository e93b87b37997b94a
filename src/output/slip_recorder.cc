// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/blocks_off_base.h>
#include <hybrid/output/slip_recorder.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::output
{
  SlipRecorder::SlipRecorder(const dda::Model *blocks, const double slip_threshold)
    : model(blocks)
    , is_level(blocks == nullptr || blocks->downhill.is_level())
    , threshold(slip_threshold)
    , slip(blocks)
    , farthest(slip.n_soles(), 0.)
  {}



  void SlipRecorder::add_series(HistoryFile &file)
  {
    const std::size_t n = slip.n_soles();
    if (n == 0)
      return;
    std::vector<double> position, length, downhill, slide;
    for (int k = 0; k < slip.n_soles(); ++k)
      {
        position.insert(position.end(), {slip.position(k).x(), slip.position(k).y()});
        length.push_back(slip.length(k));
        downhill.push_back(slip.downhill(k));
        slide.push_back(slip.slide(k));
      }
    file.write_table("slip/position", "m", position.data(), n, 2, "middle of each sole, initial");
    file.write_table("slip/length", "m", length.data(), n, 1, "of each sole");
    file.write_table(
      "slip/downhill", "1", downhill.data(), n, 1, "sign of x downhill of each sole, 0: level");
    file.write_table(
      "slip/slide", "1", slide.data(), n, 1, "number of the slide that each sole belongs to");
    mean_series    = file.add_series("slip/mean", "m", 1, "of all soles, downhill positive");
    largest_series = file.add_series("slip/largest", "m", 1, "of the sole that has slid farthest");
    part_series    = file.add_series("slip/part",
                                  "1",
                                  1,
                                  "part of the length that has slid beyond the threshold so far");
    time_series    = file.add_series("slip/time", "s", 1, "times of the pictures");
    profile_series = file.add_series("slip/profile", "m", n, "of each sole");
    force_series   = file.add_series("base_shear/force",
                                   "N/m",
                                   2,
                                   "of the mass on what it stands on, end of each step");
    shear_series   = file.add_series("base_shear/shear", "N/m", 1, "downhill positive");
    normal_series  = file.add_series("base_shear/normal", "N/m", 1, "compression positive");
    strength_series =
      file.add_series("base_shear/strength", "N/m", 1, "that the shear may reach now");
    double mass = 0., weight = 0.;
    for (int b = 0; b < model->n_mass(); ++b)
      {
        mass += model->blocks[b].mass;
        weight += model->blocks[b].weight * model->gravity;
      }
    file.set_attribute("slip", "threshold", std::vector<double>{threshold});
    file.set_attribute("base_shear", "mass", std::vector<double>{mass});
    file.set_attribute("base_shear", "weight", std::vector<double>{weight});
  }



  double SlipRecorder::mobilised(const dda::SurfaceForce &force) const
  {
    if (!(force.strength > 0.))
      return 0.;
    return (is_level ? std::abs(force.shear) : force.shear) / force.strength;
  }



  std::string SlipRecorder::downhill_words() const
  {
    const double sign = model->downhill.shared();
    return sign > 0. ? "+x" : sign < 0. ? "-x" : is_level ? "level" : "both ways";
  }



  void SlipRecorder::set_reference(const dda::DdaState &state, HistoryFile &file)
  {
    if (slip.n_soles() == 0)
      return;
    slip.set_reference(state);
    const dda::SurfaceForce &rest = state.surface_force;
    const bool               held = !std::isfinite(rest.strength);
    mobilised_at_rest             = held ? MonitorSummary::unknown : mobilised(rest);
    file.set_attribute("base_shear",
                       "force_at_rest",
                       std::vector<double>{rest.force.x(), rest.force.y()});
    file.set_attribute("base_shear",
                       "at_rest",
                       std::vector<double>{rest.shear, rest.normal, rest.strength});
  }



  void SlipRecorder::record(const dda::DdaState &state, HistoryFile &file)
  {
    if (slip.n_soles() == 0)
      return;
    const std::vector<double> now   = slip.values(state);
    const int                 first = SoleSlip::farthest(now);
    const double              mean  = slip.mean(now);
    for (std::size_t k = 0; k < now.size(); ++k)
      farthest[k] = std::max(farthest[k], std::abs(now[k]));
    const double part = slip.part_beyond(farthest, threshold);
    file.append(mean_series, &mean);
    file.append(largest_series, &now[first]);
    file.append(part_series, &part);
    if (std::abs(mean) > std::abs(largest_mean))
      largest_mean = mean;
    if (std::abs(now[first]) > std::abs(largest))
      {
        largest = now[first];
        where   = slip.position(first);
      }

    const dda::SurfaceForce &force = state.surface_force;
    file.append(force_series, force.force.data());
    file.append(shear_series, &force.shear);
    file.append(normal_series, &force.normal);
    file.append(strength_series, &force.strength);
    if (std::abs(force.shear) > std::abs(largest_shear))
      largest_shear = force.shear;
    largest_mobilised = std::max(largest_mobilised, mobilised(force));
  }



  void SlipRecorder::record_profile(const dda::DdaState &state,
                                    const double         time,
                                    HistoryFile         &file) const
  {
    if (slip.n_soles() == 0)
      return;
    file.append(time_series, &time);
    file.append(profile_series, slip.values(state).data());
  }



  void SlipRecorder::finish(const dda::DdaState &state, HistoryFile &file, Summary &summary) const
  {
    if (slip.n_soles() == 0)
      return;
    file.write_table("slip/farthest",
                     "m",
                     farthest.data(),
                     farthest.size(),
                     1,
                     "largest size of each sole's slip during the run");
    const std::vector<double> now   = slip.values(state);
    const dda::SurfaceForce  &force = state.surface_force;
    summary.slip                    = {largest_mean,
                                       largest,
                                       {{where.x(), where.y()}},
                                       slip.mean(now),
                                       now[SoleSlip::farthest(now)],
                                       slip.part_beyond(farthest, threshold),
                                       threshold,
                                       downhill_words(),
                    state.last_step > 0. ? blocks_off_surface(*model, state) : 0};
    summary.base_shear              = {largest_shear,
                                       force.shear,
                                       force.normal,
                                       mobilised_at_rest,
                                       std::max(largest_mobilised, mobilised(force)),
                                       mobilised(force)};
  }



  std::vector<double> SlipRecorder::largest_of_blocks() const
  {
    std::vector<double> largest_slip(model != nullptr ? model->n_blocks() : 0, 0.);
    for (int k = 0; k < slip.n_soles(); ++k)
      {
        double &of_block = largest_slip[model->initial.block_of[slip.vertex(k)]];
        of_block         = std::max(of_block, farthest[k]);
      }
    return largest_slip;
  }



  void SlipRecorder::serialize(restart::Archive &archive)
  {
    archive(slip, largest_mean, largest, where, farthest);
    archive(largest_shear, mobilised_at_rest, largest_mobilised);
  }
} // namespace hybrid::output
