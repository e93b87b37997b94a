// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/told_errors.h>
#include <hybrid/restart/archive.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/scene/input_error.h>

#include <filesystem>

namespace hybrid::output
{
  namespace
  {
    std::uint64_t layout_of_told_errors()
    {
      restart::Archive description = restart::Archive::describer();
      ToldErrors       told;
      description(told);
      return restart::checksum(description.content());
    }
  } // namespace



  bool operator==(const ToldErrors::Asked &one, const ToldErrors::Asked &other)
  {
    return one.steps == other.steps && one.end_time == other.end_time &&
           one.second_step == other.second_step && one.of_mesh == other.of_mesh;
  }



  void serialize(restart::Archive &archive, Summary::ErrorPart &error)
  {
    auto &[part, where, slip_left] = error;
    archive(part, where, slip_left);
  }



  void serialize(restart::Archive &archive, Summary::ProbableError &error)
  {
    auto &[watched,
           reason,
           runs_would_do,
           may_flutter,
           blocks_strike,
           second_step,
           assumed_order,
           measured_from,
           until,
           failed_in_other,
           until_later,
           step,
           half_step,
           peak_at_end,
           parts,
           mesh,
           mesh_has_corners,
           cost] = error;
    archive(watched, reason, runs_would_do, may_flutter, blocks_strike, second_step, assumed_order);
    archive(measured_from, until, failed_in_other, until_later, step, half_step, peak_at_end);
    archive(parts, mesh, mesh_has_corners, cost);
  }



  void serialize(restart::Archive &archive, Summary::MeshError &error)
  {
    auto &[runs_would_do,
           follows,
           never,
           reason,
           meshes,
           until,
           failed_in_other,
           order_is_seen,
           coarsened,
           keeps_corners,
           keeps_layers,
           of_corners,
           with_step,
           size,
           half_size,
           cost] = error;
    archive(runs_would_do, follows, never, reason, meshes, until, failed_in_other);
    archive(order_is_seen, coarsened, keeps_corners, keeps_layers, of_corners, with_step);
    archive(size, half_size, cost);
  }



  void serialize(restart::Archive &archive, ToldErrors::Asked &asked)
  {
    auto &[steps, end_time, second_step, of_mesh] = asked;
    archive(steps, end_time, second_step, of_mesh);
  }



  void serialize(restart::Archive &archive, ToldErrors &told)
  {
    auto &[asked, step, mesh] = told;
    archive(asked, step, mesh);
  }



  void write_told_errors(const std::string &file_name, const ToldErrors &told)
  {
    restart::write_checkpoint(file_name, layout_of_told_errors(), [&](restart::Archive &archive) {
      archive.put(told);
    });
  }



  std::optional<ToldErrors> read_told_errors(const std::string &file_name)
  {
    if (!std::filesystem::exists(file_name))
      return {};
    try
      {
        const restart::CheckpointContent content = restart::read_checkpoint(file_name);
        if (content.layout != layout_of_told_errors())
          return {};
        ToldErrors told;
        restart::Archive::reader_of(content.state)(told);
        return told;
      }
    catch (const InputError &) // damaged, or of another version: further runs tell it anew
      {
        return {};
      }
  }
} // namespace hybrid::output
