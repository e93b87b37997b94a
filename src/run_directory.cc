// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/checkpoint.h>
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/history_file.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/scene_reader.h>

#include <filesystem>

namespace hybrid
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What every run leaves in its directory.
    constexpr const char *files[] = {"summary.json", "run.h5", "log.txt", "params.used.prm"};

    /// And what some leave besides.
    constexpr const char *other_files[] = {"run.h5.tmp",
                                           "blocks.pvd",
                                           "joints.pvd",
                                           "continuum.pvd",
                                           "checkpoint/state.bin",
                                           "checkpoint/state.bin.tmp"};



    bool exists(const std::string &path)
    {
      std::error_code error;
      return fs::exists(path, error);
    }



    bool holds_run(const std::string &directory)
    {
      for (const char *file : files)
        if (exists(directory + "/" + file))
          return true;
      return false;
    }



    void remove_file(const fs::path &file)
    {
      std::error_code error, other;
      fs::remove(file, error);
      if (!fs::exists(fs::symlink_status(file, other)))
        return; // a directory that cannot be written says so even of files that are not there
      if (error && error != std::errc::not_a_directory)
        throw InputError("cannot delete '" + file.string() +
                         "' of the earlier run: " + error.message());
    }



    /// Only what hybrid has written; whatever else the user keeps there stays.
    void remove_run(const std::string &directory)
    {
      for (const char *file : files)
        remove_file(directory + "/" + file);
      for (const char *file : other_files)
        remove_file(directory + "/" + file);
      std::error_code error;
      for (const auto &entry : fs::directory_iterator(directory + "/vtu", error))
        {
          const std::string name = entry.path().filename().string();
          for (const char *part : {"blocks_", "joints_", "continuum_"})
            if (name.rfind(part, 0) == 0 && entry.path().extension() == ".vtu")
              remove_file(entry.path());
        }
    }



    void make_directory(const std::string &directory)
    {
      std::error_code error;
      fs::create_directories(directory, error);
      if (error)
        throw InputError("Output/Directory: cannot make the directory '" + directory +
                         "': " + error.message());
    }
  } // namespace



  void refuse_earlier_run(const std::string &directory)
  {
    if (holds_run(directory))
      throw InputError("Output/Directory: '" + directory +
                       "' holds an earlier run; continue that with 'hybrid --resume " + directory +
                       "', replace it with the option --force, or name another directory with -s "
                       "Output/Directory=...");
  }



  void prepare_directory(const scene::SceneParameters &scene, const bool force, output::Log &log)
  {
    const std::string &directory = scene.output.directory;
    if (!force)
      refuse_earlier_run(directory);
    make_directory(directory);
    remove_run(directory);
    make_directory(directory + "/checkpoint");
    log.open_file(directory + "/log.txt");
    write_parameters(scene);
  }



  void write_parameters(const scene::SceneParameters &scene)
  {
    output::write_atomically(scene.output.directory + "/params.used.prm", scene.used_prm);
  }



  scene::SceneParameters read_scene_of_run(const std::string              &directory,
                                           const std::vector<std::string> &overrides)
  {
    const std::string file = directory + "/params.used.prm";
    if (!fs::is_regular_file(file))
      throw InputError("'" + directory + "' holds no run that could be resumed: there is no '" +
                       file + "'");
    std::vector<std::string> all = overrides;
    all.push_back("Output/Directory=" + directory);
    return scene::read_scene(file, all);
  }



  bool has_not_begun(const std::string &directory)
  {
    if (exists(checkpoint_file(directory)) || exists(directory + "/summary.json"))
      return false;
    const std::string histories = directory + "/run.h5";
    if (!exists(histories))
      return true;
    output::HistoryFile file(histories, output::HistoryFile::Mode::resume);
    return file.rows(file.add_series("time", "s", 1, "")) == 0;
  }
} // namespace hybrid
