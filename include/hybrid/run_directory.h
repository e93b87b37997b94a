// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/directory_lock.h>
#include <hybrid/output/log.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid
{
  /// The parameters that the run in @p directory was started with.
  std::string parameters_file(const std::string &directory);

  /// Where the scene is computed once more for its errors (Time/ and Mesh/Error estimate).
  std::string further_run_directory(const std::string &directory);

  /// Nothing of it is left.
  void forget_further_runs(const std::string &directory);

  /// What further runs have told of its errors: a run that is resumed after its end says it again.
  std::string told_errors_file(const std::string &directory);

  /// What a repetition of the run in @p directory is compared with (Time/Error target).
  std::string step_record_file(const std::string &directory);

  /// It is compared with nothing: a run that begins.
  void forget_step_record(const std::string &directory);

  /// What to type to go on with the run in @p directory.
  std::string resume_command(const std::string &directory);

  /// @throws InputError if an earlier run is there; says what can be done. One that was killed
  /// while its scene was prepared is none.
  void refuse_earlier_run(const std::string &directory);

  /// @throws InputError if no run could write into @p directory, or make it. Writes nothing.
  void check_directory(const std::string &directory);

  /**
   * Make the output directory of a new run, with params.used.prm and log.txt.
   *
   * @param force what an earlier run has left there is deleted.
   * @param lock is taken before anything is deleted.
   * @throws InputError if an earlier run or one under way is there, or nothing can be written.
   */
  void prepare_directory(const scene::SceneParameters &scene,
                         bool                          force,
                         output::Log                  &log,
                         DirectoryLock                &lock);

  /**
   * params.used.prm of a new run while its scene is prepared, which takes minutes for a large one:
   * what is killed then can be resumed, and begins anew. A scene that is refused leaves nothing.
   */
  class ScenePrepared
  {
  public:
    ScenePrepared() = default;

    /// Deletes the file and the directories that begin() has made, unless done().
    ~ScenePrepared();
    ScenePrepared(const ScenePrepared &)            = delete;
    ScenePrepared &operator=(const ScenePrepared &) = delete;

    /// Nothing where an earlier run is, which --force is going to replace.
    /// @param lock of the directory, is taken
    void begin(const scene::SceneParameters &scene, DirectoryLock &lock);

    void done();

  private:
    std::vector<std::string> made; ///< the file, its directory, those above
  };


  /// The scene of the run in @p directory, for which the results go there again.
  /// @throws InputError if there is no run, or a file that its scene needs is gone.
  scene::SceneParameters read_scene_of_run(const std::string              &directory,
                                           const std::vector<std::string> &overrides);

  /// The run in @p directory was killed before its first step: it has no checkpoint yet and nothing
  /// that could be lost.
  bool has_not_begun(const std::string &directory);

  /// params.used.prm of a run that goes on with other parameters.
  void write_parameters(const scene::SceneParameters &scene);
} // namespace hybrid
