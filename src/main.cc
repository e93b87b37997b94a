// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/checkpoint.h>
#include <hybrid/command_line.h>
#include <hybrid/output/progress.h>
#include <hybrid/output/version.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/write_error.h>
#include <hybrid/run_directory.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/simulation.h>
#include <hybrid/tool.h>
#include <hybrid/waiting_threads.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <omp.h>

extern "C" void
openblas_set_num_threads(int threads);

namespace
{
  using namespace hybrid;

  /// Start and end of MPI, unless the caller of main() has started it.
  struct MpiSession
  {
    MpiSession(int &argc, char **&argv)
    {
      int is_initialized = 0;
      MPI_Initialized(&is_initialized);
      is_owner = is_initialized == 0;
      if (is_owner)
        MPI_Init(&argc, &argv);
      int processes = 1;
      MPI_Comm_size(MPI_COMM_WORLD, &processes);
      if (processes > 1)
        {
          // All would write the same files.
          if (is_owner)
            MPI_Finalize();
          throw InputError("hybrid runs in one process, but mpirun started " +
                           std::to_string(processes) +
                           ": start it without mpirun and set Parallel/Threads to the number of "
                           "cores to use");
        }
    }

    ~MpiSession()
    {
      if (is_owner)
        MPI_Finalize();
    }

    bool is_owner;
  };



  /// Mistakes that show only when the model is built name the scene.
  std::unique_ptr<Simulation>
  make_simulation(const std::string &file, const scene::SceneParameters &scene, output::Log &log)
  {
    try
      {
        auto simulation = std::make_unique<Simulation>(scene, log, MPI_COMM_WORLD);
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
  int run_guarded(const std::string &directory, const Work &work)
  {
    try
      {
        return exit_code(work());
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



  /// Repeat a run that has finished, with shorter steps, until Time/Error target is met. Each
  /// repetition is a run of its own: it can be resumed, and looks at the target at its end.
  RunStatus meet_error_target(std::unique_ptr<Simulation> simulation,
                              const Interruption         &interruption)
  {
    const std::string directory = simulation->directory();
    StepChoice        choice    = simulation->next_step_size();
    while (choice.step)
      {
        const std::string            size = scene::number_text(*choice.step);
        const scene::SceneParameters scene =
          read_scene_of_run(directory, {"Time/Time step=" + size});
        if (simulation->record_for_repetition())
          output::write_step_record(step_record_file(directory),
                                    *simulation->record_for_repetition());
        simulation.reset(); // its memory
        output::Log log(std::cout, output::standard_output_is_terminal());
        simulation = make_simulation(directory, scene, log);
        prepare_directory(scene, true, log);
        log.info("Repeated in steps of " + size + " s: " + choice.why);
        simulation->report().card();
        const RunStatus status = simulation->run(interruption);
        if (status != RunStatus::finished)
          return status;
        choice = simulation->next_step_size();
      }
    if (!choice.unmet.empty())
      std::cerr << "warning: Time/Error target is not known to be met: " << choice.unmet
                << std::endl;
    return RunStatus::finished;
  }



  int run_scene(const CommandLine            &command,
                const scene::SceneParameters &scene,
                int                          &argc,
                char                       **&argv)
  {
    if (command.action != Action::check)
      sleep_while_waiting(scene.threads, argv);
    const bool force = command.force || command.action == Action::resume;
    if (command.action == Action::run && !force)
      refuse_earlier_run(scene.output.directory);
    check_directory(scene.output.directory);
    prepare_process();
    const MpiSession session(argc, argv);
    output::Log      log(std::cout, output::standard_output_is_terminal());
    if (command.action == Action::resume)
      log.info("Resumed before the first checkpoint: the run begins anew");
    auto               simulation = make_simulation(command.target, scene, log);
    const Interruption interruption; // before anything is written
    if (command.action != Action::check)
      prepare_directory(scene, force, log);
    if (command.action == Action::run)
      forget_step_record(scene.output.directory);
    simulation->report().card();
    simulation->report().memory(command.action != Action::check);
    if (command.action == Action::check)
      {
        warn_of_earlier_run(scene.output.directory, log);
        log.info("The scene can be run.");
        return 0;
      }
    return run_guarded(scene.output.directory, [&] {
      const RunStatus status = simulation->run(interruption);
      return status == RunStatus::finished ? meet_error_target(std::move(simulation), interruption)
                                           : status;
    });
  }



  int resume_run(const CommandLine &command, int &argc, char **&argv)
  {
    const scene::SceneParameters scene = read_scene_of_run(command.target, command.overrides);
    sleep_while_waiting(scene.threads, argv);
    if (has_not_begun(command.target))
      return run_scene(command, scene, argc, argv);
    const restart::CheckpointContent checkpoint =
      restart::read_checkpoint(checkpoint_file(command.target));
    prepare_process();
    const MpiSession   session(argc, argv);
    output::Log        log(std::cout, output::standard_output_is_terminal());
    auto               simulation = make_simulation(command.target, scene, log);
    const Interruption interruption;
    return run_guarded(command.target, [&] {
      const RunStatus status = simulation->resume(checkpoint, interruption);
      return status == RunStatus::finished ? meet_error_target(std::move(simulation), interruption)
                                           : status;
    });
  }
} // namespace



int
main(int argc, char **argv)
{
  try
    {
      const CommandLine command = parse_command_line(argc, argv);
      switch (command.action)
        {
          case Action::help:
            std::cout << command.help;
            return 0;
          case Action::version:
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
            return resume_run(command, argc, argv);
          case Action::check:
          case Action::run:
            return run_scene(command,
                             scene::read_scene(command.target, command.overrides),
                             argc,
                             argv);
        }
    }
  catch (const InputError &error)
    {
      std::cerr << "error: " << printable(error.what()) << std::endl;
      return 2;
    }
  catch (const std::bad_alloc &)
    {
      std::cerr << "error: there is not enough memory; hybrid --check tells what a run takes"
                << std::endl;
      return 3;
    }
  catch (const std::exception &error)
    {
      std::cerr << "error: " << error.what() << std::endl;
      return 3;
    }
  return 3;
}
