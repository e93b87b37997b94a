// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/step_record.h>
#include <hybrid/restart/archive.h>
#include <hybrid/restart/checkpoint_file.h>

#include <filesystem>

namespace hybrid::output
{
  namespace
  {
    std::uint64_t layout()
    {
      restart::Archive description = restart::Archive::describer();
      StepRecord       record;
      description(record);
      return restart::checksum(description.content());
    }
  } // namespace



  void serialize(restart::Archive &archive, StepRecord::Monitor &monitor)
  {
    auto &[name, histories] = monitor;
    archive(name, histories);
  }



  void serialize(restart::Archive &archive, StepRecord &record)
  {
    auto &[step, time, monitors, least_motion, base, corner, until, slip_left, difference] = record;
    archive(step, time, monitors, least_motion, base, corner, until, slip_left, difference);
  }



  void write_step_record(const std::string &file_name, const StepRecord &record)
  {
    restart::write_checkpoint(file_name, layout(), [&](restart::Archive &archive) {
      archive.put(record);
    });
  }



  std::optional<StepRecord> read_step_record(const std::string &file_name)
  {
    if (!std::filesystem::exists(file_name))
      return {};
    const restart::CheckpointContent content = restart::read_checkpoint(file_name);
    if (content.layout != layout())
      return {};
    StepRecord record;
    restart::Archive::reader_of(content.state)(record);
    return record;
  }
} // namespace hybrid::output
