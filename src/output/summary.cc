// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/summary.h>

#include <nlohmann/json.hpp>

namespace hybrid::output
{
  namespace
  {
    using Json = nlohmann::ordered_json; // members stay in the order in which they are named


    Json joints(const Summary &summary)
    {
      return {{"tensile", summary.joints.tensile},
              {"shear", summary.joints.shear},
              {"static",
               {{"tensile", summary.static_joints.tensile},
                {"shear", summary.static_joints.shear}}},
              {"first_failure_time_s", summary.first_failure_time},
              {"first_loss_time_s", summary.first_loss_time}};
    }


    Json slip(const Summary::Slip &slip)
    {
      return {{"mean", slip.mean},
              {"largest", slip.largest},
              {"largest_at", slip.where},
              {"mean_left", slip.mean_left},
              {"largest_left", slip.largest_left},
              {"part_slipped", slip.part},
              {"threshold", slip.threshold},
              {"downhill", slip.downhill},
              {"blocks_off_surface", slip.off_surface}};
    }


    Json slip_by_name(const std::map<std::string, Summary::PlaneSlip> &lines)
    {
      Json object = Json::object();
      for (const auto &[name, slip] : lines)
        object[name] = {{"largest_left", slip.largest_left},
                        {"largest_at", slip.where},
                        {"opening_left", slip.opening_left}};
      return object;
    }


    Json base_shear(const Summary::BaseShear &base)
    {
      return {{"shear_N_per_m", base.shear},
              {"shear_left_N_per_m", base.shear_left},
              {"normal_left_N_per_m", base.normal_left},
              {"mobilised_at_rest", base.mobilised_at_rest},
              {"mobilised", base.mobilised},
              {"mobilised_left", base.mobilised_left}};
    }


    Json static_stage(const Summary::StaticStage &stage)
    {
      if (!stage.settled)
        return nullptr;
      Json result = {{"equilibrium", stage.equilibrium},
                     {"planes_hold", stage.planes_hold},
                     {"slid", stage.slid},
                     {"residual", stage.residual},
                     {"iterations", stage.iterations},
                     {"largest_displacement_m", stage.displacement}};
      if (stage.lifts_moved > 0.)
        result["largest_displacement_of_lifts_m"] = stage.lifts_moved;
      return result;
    }


    Json contact_search(const Summary::ContactSearch &search)
    {
      return {{"steps", search.steps}, {"searches", search.searches}, {"lists", search.lists}};
    }


    Json monitor(const MonitorSummary &monitor)
    {
      return {{"peak_displacement_m", monitor.peak_displacement},
              {"peak_velocity_m_s", monitor.peak_velocity},
              {"peak_acceleration_m_s2", monitor.peak_acceleration},
              {"final_displacement_m", monitor.final_displacement},
              {"amplification", monitor.amplification},
              {"amplification_until_first_failure", monitor.amplification_until_first_failure}};
    }


    Json error_part(const Summary::ErrorPart &part)
    {
      Json        object  = Json::object();
      const char *names[] = {"displacement", "velocity", "acceleration"};
      for (int q = 0; q < 3; ++q)
        object[names[q]] = {{"part_of_peak", part.part[q]}, {"monitor", part.where[q]}};
      object["slip_left"] = {{"part", part.slip_left}};
      return object;
    }


    Json overlap(const Summary::DeepestOverlap &seen)
    {
      const dda::Overlap &of = seen.of;
      return {{"part_of_size", of.part},
              {"depth_m", of.depth},
              {"block_size_m", of.size},
              {"with", of.other == dda::foundation_body ? "ground" : "block"},
              {"place_m", {of.place.x(), of.place.y()}},
              {"time_s", seen.time}};
    }


    Json probable_error(const Summary::ProbableError &error)
    {
      if (!error.reason.empty())
        return {{"estimated", false}, {"reason", error.reason}, {"watched", error.watched}};
      return {{"estimated", true},
              {"watched", error.watched},
              {"measured_from_time_step_s", error.measured_from},
              {"until_s", error.until},
              {"failed_in_both_by_s", error.until_later},
              {"blocks_strike", error.blocks_strike},
              {"blocks_may_flutter", error.may_flutter},
              {"time_step", error_part(error.step)},
              {"half_the_step", error_part(error.left_by_half())},
              {"acceleration_peaks_at_an_end", error.peak_at_end},
              {"bedrock_mesh", error_part(error.mesh)}};
    }


    Json mesh_error(const Summary::MeshError &error)
    {
      if (!error.reason.empty())
        return {{"estimated", false}, {"reason", error.reason}};
      return {{"estimated", true},
              {"coarser_meshes", error.meshes},
              {"order_is_seen", error.order_is_seen},
              {"coarsened_part", error.coarsened},
              {"smaller_cells_at_corners", error.of_corners},
              {"keeps_thin_layers", error.keeps_layers},
              {"until_s", error.until},
              {"half_the_step_too", error.with_step},
              {"mesh", error_part(error.size)},
              {"half_the_size", error_part(error.half_size)}};
    }


    Json monitors(const Summary &summary)
    {
      Json object = Json::object();
      for (const auto &[name, values] : summary.monitors)
        object[name] = monitor(values);
      return object;
    }
  } // namespace



  std::string to_json(const Summary &summary)
  {
    const Json object = {{"title", summary.title},
                         {"finished", summary.finished},
                         {"steps", summary.steps},
                         {"simulated_time_s", summary.simulated_time},
                         {"wall_time_s", summary.wall_time},
                         {"processor_time_s", summary.processor_time},
                         {"peak_memory_mb", summary.peak_memory},
                         {"blocks", summary.blocks},
                         {"continuum_unknowns", summary.continuum_unknowns},
                         {"interface_unknowns", summary.interface_unknowns},
                         {"resolved_frequency_hz", summary.resolved_frequency},
                         {"resolved_by_part_hz", summary.resolved_by_part},
                         {"motion_frequency_hz", summary.motion_frequency},
                         {"cuts", summary.wasted.cuts},
                         {"cuts_moved_too_far", summary.wasted.moved_too_far},
                         {"retries", summary.wasted.retries},
                         {"iterations", summary.iterations},
                         {"few_body_iterations", summary.few_iterations},
                         {"unconverged_iterations", summary.wasted.iterations},
                         {"contact_search", contact_search(summary.contact_search)},
                         {"energy_residual", summary.energy_residual},
                         {"energy_J_per_m", summary.energy},
                         {"static_stage", static_stage(summary.static_stage)},
                         {"deepest_overlap", overlap(summary.deepest_overlap)},
                         {"blocks_off_base", summary.blocks_off_base},
                         {"joints", joints(summary)},
                         {"slip_m", slip(summary.slip)},
                         {"bedding_slip_m", slip_by_name(summary.planes)},
                         {"joint_line_slip_m", slip_by_name(summary.joint_lines)},
                         {"base_shear", base_shear(summary.base_shear)},
                         {"filter_frequency_hz", summary.filter_frequency},
                         {"outcrop_peak_acceleration_m_s2", summary.outcrop_peak_acceleration},
                         {"probable_error", probable_error(summary.probable_error)},
                         {"mesh_error", mesh_error(summary.mesh_error)},
                         {"monitors", monitors(summary)},
                         {"processor_times_s", summary.stages},
                         {"timings_s", summary.timings}};
    // JSON is UTF-8: a title in another encoding loses its letters, not the summary.
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }



  void write_summary(const Summary &summary, const std::string &file_name)
  {
    write_atomically(file_name, to_json(summary));
  }
} // namespace hybrid::output
