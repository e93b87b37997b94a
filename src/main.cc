// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/command_line.h>
#include <hybrid/output/plot_command.h>
#include <hybrid/output/progress.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/scene_reader.h>
#include <hybrid/simulation.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <omp.h>

extern "C" void
openblas_set_num_threads(int threads);

namespace
{
  using namespace hybrid;

  /// Reference-counted start and end of MPI.
  struct MpiSession
  {
    MpiSession(int &argc, char **&argv)
    {
      MPI_Init(&argc, &argv);
    }

    ~MpiSession()
    {
      MPI_Finalize();
    }
  };



  void prepare_directory(const scene::SceneParameters &scene, output::Log &log)
  {
    std::error_code error;
    std::filesystem::create_directories(scene.output.directory, error);
    if (error)
      throw InputError("Output/Directory: cannot make the directory '" + scene.output.directory +
                       "': " + error.message());
    std::filesystem::remove(scene.output.directory + "/summary.json", error); // of an earlier run
    log.open_file(scene.output.directory + "/log.txt");
    std::ofstream(scene.output.directory + "/params.used.prm") << scene.used_prm;
  }



  /// Mistakes that show only when the model is built name the scene.
  std::unique_ptr<Simulation>
  make_simulation(const std::string &file, const scene::SceneParameters &scene, output::Log &log)
  {
    try
      {
        return std::make_unique<Simulation>(scene, log, MPI_COMM_WORLD);
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
  }



  int run_scene(const CommandLine &command, int &argc, char **&argv)
  {
    const scene::SceneParameters scene = scene::read_scene(command.target, command.overrides);
    omp_set_num_threads(scene.threads);
    openblas_set_num_threads(1); // its bits change with the number of threads
    const MpiSession session(argc, argv);
    output::Log      log(std::cout, output::standard_output_is_terminal());
    const auto       simulation = make_simulation(command.target, scene, log);
    if (command.action == Action::run)
      prepare_directory(scene, log);
    simulation->print_card();
    if (command.action == Action::check)
      {
        log.info("The scene can be run.");
        return 0;
      }
    return simulation->run() == RunStatus::finished ? 0 : 1;
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
            std::cout << usage();
            return 0;
          case Action::print_parameters:
            scene::print_all_parameters(std::cout);
            return 0;
          case Action::plot:
            return output::plot(command.target);
          case Action::check:
          case Action::run:
            return run_scene(command, argc, argv);
        }
    }
  catch (const InputError &error)
    {
      std::cerr << "error: " << error.what() << std::endl;
      return 2;
    }
  catch (const std::exception &error)
    {
      std::cerr << "error: " << error.what() << std::endl;
      return 3;
    }
  return 3;
}
