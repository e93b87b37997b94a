// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/checkpoint.h>
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/history_file.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/crash_guard.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/scene_reader.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <unistd.h>

namespace hybrid
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What every run leaves in its directory.
    constexpr const char *files[] = {"summary.json", "run.h5", "log.txt", "params.used.prm"};

    /// And what some leave besides.
    constexpr const char *other_files[] = {"blocks.pvd",
                                           "joints.pvd",
                                           "continuum.pvd",
                                           "peaks.vtu",
                                           "peaks_blocks.vtu",
                                           "checkpoint/state.bin",
                                           "checkpoint/told_errors.bin"};



    bool exists(const std::string &path)
    {
      std::error_code error;
      return fs::exists(path, error);
    }



    /// params.used.prm alone is left by what was killed while its scene was prepared.
    bool holds_run(const std::string &directory)
    {
      return std::any_of(std::begin(files), std::end(files), [&](const std::string &file) {
        return file != "params.used.prm" && exists(directory + "/" + file);
      });
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



    /// A file, and what a kill has left of its next version.
    void remove_versions(const std::string &file)
    {
      remove_file(file);
      remove_file(restart::temporary_name(file));
    }



    bool is_picture(const fs::path &file)
    {
      const std::string name     = file.filename().string();
      const fs::path    finished = file.extension() == ".tmp" ? file.stem() : file.filename();
      for (const char *part : {"blocks_", "joints_", "continuum_"})
        if (name.rfind(part, 0) == 0 && finished.extension() == ".vtu")
          return true;
      return false;
    }



    /// Only what hybrid has written; whatever else the user keeps there stays.
    void remove_run(const std::string &directory)
    {
      for (const char *file : files)
        remove_versions(directory + "/" + file);
      for (const char *file : other_files)
        remove_versions(directory + "/" + file);
      forget_further_runs(directory);
      std::error_code error;
      for (const auto &entry : fs::directory_iterator(directory + "/vtu", error))
        if (is_picture(entry.path()))
          remove_file(entry.path());
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



  std::string parameters_file(const std::string &directory)
  {
    return directory + "/params.used.prm";
  }



  std::string further_run_directory(const std::string &directory)
  {
    return directory + "/checkpoint/further_run";
  }



  void forget_further_runs(const std::string &directory)
  {
    std::error_code ignored; // all of it is the program's own
    fs::remove_all(further_run_directory(directory), ignored);
  }



  std::string told_errors_file(const std::string &directory)
  {
    return directory + "/checkpoint/told_errors.bin";
  }



  std::string step_record_file(const std::string &directory)
  {
    return directory + "/checkpoint/longer_steps.bin";
  }



  void forget_step_record(const std::string &directory)
  {
    remove_versions(step_record_file(directory));
  }



  std::string resume_command(const std::string &directory)
  {
    const bool plain =
      directory.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "/._-+,:=@%") == std::string::npos;
    return "hybrid --resume " + (plain ? directory : "\"" + directory + "\"");
  }



  void refuse_earlier_run(const std::string &directory)
  {
    if (!holds_run(directory))
      return;
    const std::string rest = "replace it with the option --force, or name another directory with "
                             "-s Output/Directory=...";
    if (!exists(parameters_file(directory)))
      throw InputError("Output/Directory: '" + directory +
                       "' holds an earlier run that cannot be continued, as it has no "
                       "params.used.prm; " +
                       rest);
    throw InputError("Output/Directory: '" + directory +
                     "' holds an earlier run; continue that with '" + resume_command(directory) +
                     "', " + rest);
  }



  void check_directory(const std::string &directory)
  {
    fs::path place = directory;
    while (!place.empty() && !exists(place.string()))
      place = place == place.parent_path() ? fs::path() : place.parent_path();
    if (place.empty())
      place = ".";
    const std::string cannot = "Output/Directory: cannot write into '" + directory + "': ";
    if (!fs::is_directory(place))
      throw InputError(cannot + "'" + place.string() + "' is a file");
    if (access(place.c_str(), W_OK) != 0)
      throw InputError(cannot + "'" + place.string() + "': " + std::strerror(errno));
  }



  void prepare_directory(const scene::SceneParameters &scene,
                         const bool                    force,
                         output::Log                  &log,
                         DirectoryLock                &lock)
  {
    const std::string &directory = scene.output.directory;
    if (!force)
      refuse_earlier_run(directory);
    make_directory(directory);
    lock.take(directory);
    remove_run(directory);
    make_directory(directory + "/checkpoint");
    write_parameters(scene);
    log.open_file(directory + "/log.txt");
  }



  ScenePrepared::~ScenePrepared()
  {
    std::error_code error;
    for (const std::string &path : made) // a directory with other files stays
      fs::remove(path, error);
    done();
  }



  void ScenePrepared::done()
  {
    made.clear();
    scene::CrashGuard::delete_at_crash({});
  }



  void ScenePrepared::begin(const scene::SceneParameters &scene, DirectoryLock &lock)
  {
    const std::string &directory = scene.output.directory;
    if (holds_run(directory))
      return;
    std::vector<std::string> above;
    for (fs::path place = directory; !place.empty() && !exists(place.string());
         place          = place == place.parent_path() ? fs::path() : place.parent_path())
      above.push_back(place.string());
    make_directory(directory);
    lock.take(directory);
    made.push_back(parameters_file(directory));
    made.insert(made.end(), above.begin(), above.end());
    scene::CrashGuard::delete_at_crash(made);
    write_parameters(scene);
  }



  void write_parameters(const scene::SceneParameters &scene)
  {
    output::write_atomically(parameters_file(scene.output.directory), scene.used_prm);
  }



  scene::SceneParameters read_scene_of_run(const std::string              &directory,
                                           const std::vector<std::string> &overrides)
  {
    const std::string file = parameters_file(directory);
    if (fs::is_regular_file(directory))
      throw InputError("'" + directory +
                       "' is a file; --resume takes the output directory of a run");
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
