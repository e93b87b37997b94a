// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/blas_kernels.h>
#include <hybrid/checkpoint.h>
#include <hybrid/command_line.h>
#include <hybrid/directory_lock.h>
#include <hybrid/error_runs.h>
#include <hybrid/output/advice.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/version.h>
#include <hybrid/processes.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/write_error.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/scene/parameters/time_integrator.h>
#include <hybrid/simulation.h>
#include <hybrid/tool.h>
#include <hybrid/voice.h>
#include <hybrid/waiting_threads.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <omp.h>
#include <thread>

extern "C" void
openblas_set_num_threads(int threads);

namespace
{
  using namespace hybrid;

  /// Of all processes, if the scene may be shared out among them and others take part.
  MPI_Comm communicator_of(const scene::SceneParameters &scene, const Processes &processes)
  {
    const bool is_explicit = scene.continuum.integrator != scene::TimeIntegrator::implicit_steps &&
                             scene::why_not_explicit(scene).empty();
    const bool iterates =
      scene::with_linear_solver(scene, processes.count()).continuum.linear_solver ==
      scene::LinearSolver::conjugate_gradients;
    return processes.count() > 1 && !processes.is_alone() &&
               (scene.has_blocks() || is_explicit || iterates)
             ? MPI_COMM_WORLD
             : MPI_COMM_SELF;
  }



  /// The first process computes alone, and the others wait. @return whether this one computes
  bool compute_alone(Processes &processes, output::Log &log)
  {
    processes.compute_alone();
    log.warning("mpirun started " + std::to_string(processes.count()) +
                " processes, and this scene is computed by the first one alone: shared out are "
                "blocks, from Parallel/Shared blocks on, a bedrock with Continuum/Linear solver = "
                "conjugate gradients, and waves alone with Continuum/Time integrator = explicit");
    return processes.is_first();
  }



  /// What of several processes may take part in the run. @return whether this one does.
  bool may_take_part(const scene::SceneParameters &scene, Processes &processes, output::Log &log)
  {
    return processes.count() == 1 || communicator_of(scene, processes) == MPI_COMM_WORLD ||
           compute_alone(processes, log);
  }



  /// The same once its parts are known.
  bool takes_part(const Simulation &simulation,
                  const int         threads,
                  Processes        &processes,
                  output::Log      &log)
  {
    if (processes.count() == 1 || processes.is_alone())
      return true;
    if (simulation.is_alone())
      return compute_alone(processes, log);
    if (const std::string warning =
          output::processes_warning(processes.on_this_machine(),
                                    threads,
                                    static_cast<int>(std::thread::hardware_concurrency()));
        !warning.empty())
      log.warning(warning);
    return true;
  }



  /// Mistakes that show only when the model is built name the scene.
  std::unique_ptr<Simulation> make_simulation(const std::string            &file,
                                              const scene::SceneParameters &scene,
                                              const Processes              &processes,
                                              output::Log                  &log)
  {
    try
      {
        auto simulation =
          std::make_unique<Simulation>(scene, log, communicator_of(scene, processes));
        omp_set_num_threads(scene.threads); // only now: gmsh sets it to one while it reads the mesh
        return simulation;
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
  }



  int exit_code(const RunStatus status)
  {
    switch (status)
      {
        case RunStatus::finished:
          return 0;
        case RunStatus::no_convergence:
        case RunStatus::energy_limit:
        case RunStatus::no_equilibrium:
          return 1;
        case RunStatus::interrupted:
          return 130;
      }
    return 3;
  }



  /// What fails during a run leaves everything up to the last flush.
  template <typename Work>
  int run_guarded(const std::string &directory, Processes &processes, const Work &work)
  {
    try
      {
        processes.set_together(true);
        const int code = exit_code(work());
        processes.set_together(false);
        return code;
      }
    catch (const WriteError &error)
      {
        std::string text = error.what();
        if (!text.empty() && text.back() == '.')
          text.pop_back();
        throw std::runtime_error(text + "; the results up to the last flush are in '" + directory +
                                 "', and '" + resume_command(directory) +
                                 "' goes on once the cause is removed");
      }
  }



  /// What a message quotes from a file may have control characters, which a screen would obey.
  std::string printable(std::string text)
  {
    for (char &c : text)
      if (static_cast<unsigned char>(c) < 32 || c == 127)
        c = '?';
    return text;
  }



  void prepare_process()
  {
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error of writing
    std::signal(SIGPIPE, SIG_IGN); // a run outlives its screen
    openblas_set_num_threads(1);   // its bits change with the number of threads
    use_better_blas_kernels();
  }



  /// What a run would be refused for, though the scene is sound.
  void warn_of_earlier_run(const std::string &directory, output::Log &log)
  {
    try
      {
        refuse_earlier_run(directory);
      }
    catch (const InputError &error)
      {
        log.warning(error.what());
      }
  }



  /// What a run that has finished calls for besides.
  RunStatus finish_run(std::unique_ptr<Simulation> simulation,
                       const RunStatus             status,
                       const Processes            &processes,
                       output::Log                &log,
                       DirectoryLock              &lock,
                       const Interruption         &interruption)
  {
    if (status != RunStatus::finished)
      return status;
    const SimulationMaker make = [&processes](const std::string            &file,
                                              const scene::SceneParameters &scene,
                                              output::Log                  &scene_log) {
      return make_simulation(file, scene, processes, scene_log);
    };
    if (simulation->has_error_target())
      return meet_error_target(std::move(simulation), make, processes, log, lock, interruption);
    tell_errors_by_further_runs(std::move(simulation), make, processes, log, interruption);
    return status;
  }



  int run_scene(const CommandLine            &command,
                const scene::SceneParameters &scene,
                Processes                    &processes,
                DirectoryLock                &lock)
  {
    const bool force    = command.force || command.action == Action::resume;
    const bool is_check = command.action == Action::check;
    prepare_process();
    ScenePrepared preparation;
    processes.on_first([&] {
      if (command.action == Action::run && !force)
        refuse_earlier_run(scene.output.directory);
      check_directory(scene.output.directory);
      if (!is_check && std::filesystem::is_directory(scene.output.directory))
        lock.take(scene.output.directory); // before it is meshed in vain
      if (command.action == Action::run)
        preparation.begin(scene, lock);
    });
    Voice voice(processes);
    if (command.action == Action::resume)
      voice.log.info("Resumed before the first checkpoint: the run begins anew");
    if (!may_take_part(scene, processes, voice.log))
      return processes.wait_for_first();
    auto simulation = make_simulation(command.target, scene, processes, voice.log);
    if (!takes_part(*simulation, scene.threads, processes, voice.log))
      {
        simulation.reset();
        return processes.wait_for_first();
      }
    const Interruption interruption; // before anything is written
    processes.on_first([&] {
      if (!is_check)
        prepare_directory(scene, force, voice.log, lock);
      preparation.done();
      if (command.action == Action::run)
        forget_step_record(scene.output.directory);
    });
    simulation->report().card();
    simulation->report().memory(!is_check, processes.is_alone() ? 1 : processes.on_this_machine());
    if (is_check)
      {
        warn_of_earlier_run(scene.output.directory, voice.log);
        voice.log.info("The scene can be run.");
        return 0;
      }
    return run_guarded(scene.output.directory, processes, [&] {
      const RunStatus status = simulation->run(interruption);
      return finish_run(std::move(simulation), status, processes, voice.log, lock, interruption);
    });
  }



  int resume_run(const CommandLine            &command,
                 const scene::SceneParameters &scene,
                 Processes                    &processes,
                 DirectoryLock                &lock)
  {
    processes.on_first([&] { lock.take(command.target); });
    if (has_not_begun(command.target))
      return run_scene(command, scene, processes, lock);
    const std::string          file = checkpoint_file(command.target);
    restart::CheckpointContent checkpoint;
    processes.on_first([&] { checkpoint = restart::read_checkpoint(file); });
    if (!processes.is_first())
      checkpoint = restart::read_checkpoint(file, false);
    prepare_process();
    Voice voice(processes);
    if (!may_take_part(scene, processes, voice.log))
      return processes.wait_for_first();
    auto simulation = make_simulation(command.target, scene, processes, voice.log);
    if (!takes_part(*simulation, scene.threads, processes, voice.log))
      {
        simulation.reset();
        return processes.wait_for_first();
      }
    const Interruption interruption;
    return run_guarded(command.target, processes, [&] {
      const RunStatus status = simulation->resume(checkpoint, interruption);
      return finish_run(std::move(simulation), status, processes, voice.log, lock, interruption);
    });
  }



  /// What computes or checks a scene.
  int compute(const CommandLine &command, Processes &processes, int &argc, char **&argv)
  {
    const bool                   resumes = command.action == Action::resume;
    const scene::SceneParameters scene   = resumes
                                             ? read_scene_of_run(command.target, command.overrides)
                                             : scene::read_scene(command.target, command.overrides);
    if (command.action != Action::check)
      sleep_while_waiting(scene.threads, argv);
    processes.start(argc, argv);
    DirectoryLock lock;
    return resumes ? resume_run(command, scene, processes, lock)
                   : run_scene(command, scene, processes, lock);
  }



  int act(const CommandLine &command, Processes &processes, int &argc, char **&argv)
  {
    const bool computes = command.action == Action::resume || command.action == Action::check ||
                          command.action == Action::run;
    if (!computes && !processes.is_first())
      return 0;
    switch (command.action)
      {
        case Action::help:
          std::cout << command.help;
          return 0;
        case Action::version:
          use_better_blas_kernels(); // as in a run
          std::cout << output::version_text();
          return 0;
        case Action::print_parameters:
          if (command.target.empty())
            scene::print_all_parameters(std::cout);
          else
            std::cout << scene::read_scene(command.target, command.overrides).used_prm;
          return 0;
        case Action::tool:
          return run_tool(command.tool, command.words);
        case Action::resume:
        case Action::check:
        case Action::run:
          return compute(command, processes, argc, argv);
      }
    return 3;
  }



  /// The exit code of @p work, with what it fails at on the screen.
  template <typename Work>
  int say_errors(const Processes &processes, const Work &work)
  {
    const auto say = [&](const std::string &text, const int code) {
      if (processes.is_first() || processes.are_together())
        std::cerr << "error: " << text << std::endl;
      processes.end_all(code);
      return code;
    };
    try
      {
        return work();
      }
    catch (const FirstProcessFailed &failure)
      {
        return failure.exit_code;
      }
    catch (const InputError &error)
      {
        return say(printable(error.what()), 2);
      }
    catch (const std::bad_alloc &)
      {
        return say("there is not enough memory; hybrid --check tells what a run takes", 3);
      }
    catch (const std::exception &error)
      {
        return say(error.what(), 3);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Processes processes;
  const int code = say_errors(processes, [&] {
    return act(parse_command_line(argc, argv), processes, argc, argv);
  });
  processes.release(code);
  return code;
}
