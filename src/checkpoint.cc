// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/checkpoint.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>

namespace hybrid
{
  namespace
  {
    double steady_seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
    }



    std::string trimmed(const std::string &text)
    {
      const std::size_t begin = text.find_first_not_of(" \t");
      if (begin == std::string::npos)
        return "";
      return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
    }



    /// Values of a complete parameter file by "Section/Name".
    std::map<std::string, std::string> settings(const std::string &prm)
    {
      std::map<std::string, std::string> values;
      std::vector<std::string>           sections;
      std::istringstream                 text(prm);
      for (std::string raw; std::getline(text, raw);)
        {
          const std::string line = trimmed(raw.substr(0, raw.find('#')));
          if (line.rfind("subsection ", 0) == 0)
            sections.push_back(trimmed(line.substr(11)));
          else if (line == "end" && !sections.empty())
            sections.pop_back();
          else if (line.rfind("set ", 0) == 0)
            {
              std::string path;
              for (const std::string &section : sections)
                path += section + "/";
              const std::size_t sign                           = line.find('=');
              values[path + trimmed(line.substr(4, sign - 4))] = trimmed(line.substr(sign + 1));
            }
        }
      return values;
    }



    bool may_change(const std::string &path)
    {
      for (const char *section : {"Output/", "Checkpoint/", "Parallel/"})
        if (path.rfind(section, 0) == 0)
          return true;
      return path == "Time/End time" || path == "Time/Error target" ||
             path == "Time/Error estimate" || path == "Mesh/Error estimate";
    }
  } // namespace



  std::string checkpoint_file(const std::string &directory)
  {
    return directory + "/checkpoint/state.bin";
  }



  CheckpointSchedule::CheckpointSchedule(const scene::CheckpointParameters &intervals,
                                         std::function<double()>            wall_clock)
    : parameters(intervals)
    , clock(wall_clock ? std::move(wall_clock) : std::function<double()>(steady_seconds))
    , last(clock())
  {}



  bool CheckpointSchedule::is_due(const long steps) const
  {
    constexpr double others = 19.; ///< time for all else, over that of writing
    return (parameters.step_interval > 0 && steps % parameters.step_interval == 0) ||
           (parameters.wall_interval > 0. &&
            clock() - last >= std::max(parameters.wall_interval, others * taking));
  }



  void CheckpointSchedule::begins()
  {
    began = clock();
  }



  void CheckpointSchedule::written()
  {
    last   = clock();
    taking = last - began;
  }



  std::uint64_t fingerprint(const scene::SectionMesh &mesh, const scene::GroundMotion &motion)
  {
    restart::Archive archive = restart::Archive::writer();
    archive.put(mesh.nodes);
    archive.put(mesh.bedrock_cells);
    archive.put(mesh.bedrock_region);
    archive.put(mesh.bedrock_region_names);
    archive.put(mesh.bedrock_surface);
    archive.put(mesh.blocks);
    archive.put(mesh.block_region);
    archive.put(mesh.block_region_names);
    archive.put(mesh.lines);
    archive.put(motion.outcrop().time_step());
    archive.put(motion.outcrop().samples());
    if (const scene::Motion &vertical = motion.vertical_outcrop(); !vertical.empty())
      {
        archive.put(vertical.time_step());
        archive.put(vertical.samples());
      }
    return restart::checksum(archive.content());
  }



  void check_same_scene(const std::string &before, const std::string &after)
  {
    const auto old_values = settings(before), new_values = settings(after);
    for (const auto &[path, value] : new_values)
      {
        const auto old = old_values.find(path);
        if (!may_change(path) && (old == old_values.end() || old->second != value))
          throw InputError(
            path + " = '" + value + "' differs from the run that is resumed" +
            (old == old_values.end() ? ", which does not have it" : " ('" + old->second + "')") +
            "; only Time/End time, Error target, Error estimate and the sections Output, "
            "Checkpoint and Parallel may change");
      }
    for (const auto &entry : old_values)
      if (new_values.count(entry.first) == 0)
        throw InputError(entry.first + " of the run that is resumed is missing");
  }
} // namespace hybrid
