// SPDX-License-Identifier: GPL-3.0-or-later
// Mutated input files for every reader of the scene module. Allowed is: a sound result, or an
// InputError of one line. See doc/developer_guide.md, "Fuzzing".
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/polygon_reader.h>
#include <hybrid/scene/mesh/section_mesh_reader.h>
#include <hybrid/scene/motion/motion_reader.h>
#include <hybrid/scene/motion/response_spectrum.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/parameters/scene_reader.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mutator.h"

namespace
{
  using namespace hybrid;
  namespace fs = std::filesystem;

  constexpr int hang = 20; // [s]; a read that is stopped after it counts as a hang

  /// A result that no reader may give.
  struct Nonsense : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  void require(const bool sound, const std::string &what)
  {
    if (!sound)
      throw Nonsense("accepted: " + what);
  }

  bool is_finite(const std::vector<double> &values)
  {
    return std::all_of(values.begin(), values.end(), [](const double x) {
      return std::isfinite(x);
    });
  }

  bool is_finite(const std::vector<Vec2> &points)
  {
    return std::all_of(points.begin(), points.end(), [](const Vec2 &x) { return x.allFinite(); });
  }

  void check_motion(const scene::Motion &motion)
  {
    require(is_finite(motion.samples()), "a motion with samples that are not finite");
    require(motion.time_step() > 0. && std::isfinite(motion.time_step()), "the motion's time step");
  }

  void check_scene(const scene::SceneParameters &scene)
  {
    for (const auto &[name, m] : scene.materials)
      {
        require(m.density > 0. && std::isfinite(m.density), "density of " + name);
        require(m.young_modulus > 0. && std::isfinite(m.young_modulus), "modulus of " + name);
        require(m.poisson_ratio < 0.5, "Poisson's ratio of " + name);
        require(m.cohesion >= 0. && m.tensile_strength >= 0., "strength of " + name);
      }
    require(std::isfinite(scene.time.time_step) && scene.time.time_step > 0., "Time/Time step");
    require(std::isfinite(scene.time.end_time) && scene.time.end_time >= 0., "Time/End time");
    require(scene.time.end_time == 0. || scene.time.time_step <= 10. * scene.time.end_time,
            "a time step of more than ten times the end time");
    require(std::isfinite(scene.environment.gravity), "gravity");
  }

  void check_mesh(const scene::SectionMesh &mesh)
  {
    require(is_finite(mesh.nodes), "nodes that are not finite");
    const int  n     = mesh.nodes.size();
    const auto known = [n](const int node) { return node >= 0 && node < n; };
    for (const auto &block : mesh.blocks)
      require(block.size() >= 3 && std::all_of(block.begin(), block.end(), known),
              "a block's nodes");
    for (const auto &cell : mesh.bedrock_cells)
      require(std::all_of(cell.begin(), cell.end(), known), "a cell's nodes");
    for (const auto &[name, edges] : mesh.lines)
      for (const auto &edge : edges)
        require(known(edge[0]) && known(edge[1]), "nodes of line " + name);
  }

  /// Read @p file as what its kind says and look at the result.
  void read(const std::string &kind, const std::string &file)
  {
    scene::SectionMesh mesh;
    if (kind == "prm")
      check_scene(scene::read_scene(file));
    else if (kind == "at2")
      check_motion(scene::read_at2_motion(file));
    else if (kind == "record")
      check_motion(scene::read_text_motion(file, 9.80665));
    else if (kind == "spectrum")
      {
        const scene::ResponseSpectrum spectrum = scene::read_response_spectrum(file, false, 1.);
        require(is_finite({spectrum.lowest_frequency(), spectrum.highest_frequency()}),
                "a spectrum's frequencies");
      }
    else if (kind == "points")
      for (const auto &[name, x] : scene::read_points(file, {"S1", "S2"}))
        require(x.allFinite(), "point " + name);
    else if (kind == "blocks")
      scene::read_polygons(file, mesh);
    else if (kind == "surface")
      scene::read_surface(file, mesh);
    else
      {
        scene::MeshParameters parameters;
        parameters.file = file;
        mesh            = scene::read_section_mesh(parameters);
      }
    check_mesh(mesh);
  }

  /// Where mutated files lie: as deep as the scenes, so that they find the meshes and what they
  /// include.
  class Workplace
  {
  public:
    Workplace(const fs::path &source, const fs::path &folder)
      : root(folder)
    {
      fs::create_directories(root / "parameters/mutated");
      std::error_code ignored;
      fs::create_directory_symlink(source / "meshes", root / "meshes", ignored);
      for (const char *name : {"verification", "hard", "majiagou"})
        for (const auto &entry : fs::directory_iterator(source / "parameters" / name))
          fs::create_symlink(entry.path(),
                             root / "parameters/mutated" / entry.path().filename(),
                             ignored);
    }

    std::string write(const std::string &kind, const std::string &text) const
    {
      const fs::path file =
        root / "parameters/mutated" / (kind == "msh" ? "input.msh" : "input.tmp");
      std::ofstream(file, std::ios::binary) << text;
      return file;
    }

  private:
    const fs::path root;
  };

  /// Read @p file in a process of its own, which the reader ends with a sentence and exit code 2
  /// where gmsh crashes: that too is an InputError.
  void read_apart(const std::string &kind, const std::string &file)
  {
    int ends[2];
    if (pipe(ends) != 0)
      throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0)
      {
        dup2(ends[1], STDERR_FILENO);
        alarm(hang);
        try
          {
            read(kind, file);
            std::_Exit(0);
          }
        catch (const InputError &error)
          {
            std::cerr << "error: " << error.what() << "\n";
            std::_Exit(2);
          }
        catch (const std::exception &error)
          {
            std::cerr << error.what() << "\n";
          }
        std::_Exit(3);
      }
    close(ends[1]);
    std::string text;
    char        buffer[1024];
    for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof(buffer))) > 0;)
      text.append(buffer, n);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!text.empty() && text.back() == '\n')
      text.pop_back();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 2 && text.rfind("error: ", 0) == 0)
      throw InputError(text);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
      throw Nonsense("status " + std::to_string(status) + ": " + text);
  }

  void read_input(const std::string &kind, const std::string &file)
  {
    kind == "msh" ? read_apart(kind, file) : read(kind, file);
  }

} // namespace


#ifdef HYBRID_LIBFUZZER

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  static const char *const kinds[] = {
    "prm", "at2", "record", "spectrum", "points", "blocks", "surface", "msh"};
  static const Workplace place(HYBRID_SOURCE_DIR,
                               fs::temp_directory_path() / ("fuzz_" + std::to_string(getpid())));
  if (size == 0)
    return 0;
  const std::string kind = kinds[data[0] % 8];
  try
    {
      read_input(kind, place.write(kind, std::string(data + 1, data + size)));
    }
  catch (const InputError &)
    {}
  return 0; // every other exception ends the process: libFuzzer reports and keeps the input
}

#else

namespace
{
  constexpr double longest_read = 1.; // of computing [s]

  /// Processor time of this process and of those that read for it [s].
  double computed()
  {
    double sum = 0.;
    for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN})
      {
        rusage usage = {};
        getrusage(whose, &usage);
        for (const timeval &time : {usage.ru_utime, usage.ru_stime})
          sum += time.tv_sec + 1e-6 * time.tv_usec;
      }
    return sum;
  }

  struct Seed
  {
    std::string kind;
    std::string text;
    std::string name;
  };

  std::vector<Seed> read_seeds(const fs::path &source)
  {
    std::map<std::string, std::string> kind_of; // path -> kind, ordered
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator(source / "parameters"))
      {
        const std::string stem = entry.path().stem(), extension = entry.path().extension();
        if (entry.path().parent_path().parent_path().filename() == "examples" ||
            entry.path().parent_path().filename() == "benchmarks" ||
            (stem == "wave_packet" && extension == ".csv"))
          continue; // their files name each other, and tables for tools are no tables of blocks
        if (extension == ".prm")
          kind_of[entry.path()] = "prm";
        else if (extension == ".csv") // by the number of columns
          kind_of[entry.path()] = stem.rfind("eurocode", 0) == 0 ? "spectrum"
                                  : scene::read_text_table(entry.path()).back().fields.size() == 2
                                    ? "surface"
                                    : "blocks";
        else if (extension == ".txt")
          kind_of[entry.path()] = "record";
      }
    for (const fs::directory_entry &entry : fs::directory_iterator(source / "tests/fuzz/corpus"))
      {
        const std::string extension = entry.path().extension();
        kind_of[entry.path()]       = extension == ".txt"   ? "record"
                                      : extension == ".csv" ? "points"
                                                            : extension.substr(1);
      }
    std::vector<Seed> seeds;
    for (const auto &[path, kind] : kind_of)
      {
        std::ifstream      in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        seeds.push_back({kind, text.str(), fs::path(path).filename()});
      }
    return seeds;
  }

  void stop_hang(int)
  {
    const char text[] = "hang: a read took too long\n";
    if (write(STDERR_FILENO, text, sizeof(text) - 1) < 0)
      std::_Exit(98);
    std::_Exit(99);
  }

  struct Counts
  {
    int accepted = 0, refused = 0, failed = 0;
  };

  std::ofstream messages; ///< what refused inputs were told

  /// @return what is wrong with the outcome of reading @p file, or "".
  std::string outcome(const std::string &kind, const std::string &file, Counts &counts)
  {
    const double begin = computed();
    std::string  wrong;
    alarm(hang);
    try
      {
        read_input(kind, file);
        ++counts.accepted;
      }
    catch (const InputError &error)
      {
        const std::string text = error.what();
        messages << text << "\n";
        ++counts.refused;
        if (text.empty() || text.find('\n') != std::string::npos)
          wrong = "a message that is not one line: " + text;
      }
    catch (const std::exception &error)
      {
        wrong = std::string("not an InputError: ") + error.what();
      }
    alarm(0);
    const double taken = computed() - begin;
    if (wrong.empty() && taken > longest_read)
      wrong = "took " + std::to_string(taken) + " s";
    return wrong;
  }
} // namespace


/// reader_fuzzer FOLDER COUNT [SEED [ONLY_KIND]]: exit code 1 if an input failed; it is kept in
/// FOLDER.
int
main(int argc, char **argv)
{
  if (argc < 3)
    {
      std::cerr << "usage: reader_fuzzer FOLDER COUNT [SEED [KIND]]\n";
      return 2;
    }
  const fs::path      folder = argv[1];
  const unsigned long count = std::stoul(argv[2]), first = argc > 3 ? std::stoul(argv[3]) : 1;
  const std::string   only = argc > 4 ? argv[4] : "";
  std::signal(SIGALRM, stop_hang);

  const Workplace                                  place(HYBRID_SOURCE_DIR, folder);
  std::vector<Seed>                                seeds = read_seeds(HYBRID_SOURCE_DIR);
  std::map<std::string, std::vector<const Seed *>> by_kind;
  for (const Seed &seed : seeds)
    if (only.empty() || seed.kind == only)
      by_kind[seed.kind].push_back(&seed);

  messages.open(folder / "messages.txt");
  std::map<std::string, Counts> counts;
  int                           failures = 0;
  for (const Seed &seed : seeds)
    if (only.empty() || seed.kind == only)
      {
        Counts            sound;
        const std::string wrong = outcome(seed.kind, place.write(seed.kind, seed.text), sound);
        if (!wrong.empty() || sound.refused > 0)
          {
            std::cerr << "the unchanged " << seed.name << ": "
                      << (wrong.empty() ? "is refused" : wrong) << "\n";
            ++failures;
          }
      }
  for (unsigned long i = first; i < first + count; ++i)
    {
      auto kind = by_kind.begin();
      std::advance(kind, i % by_kind.size());
      const Seed       &seed  = *kind->second[i / by_kind.size() % kind->second.size()];
      const std::string text  = fuzz::Mutator(i).mutate(seed.text);
      const std::string file  = place.write(seed.kind, text);
      const std::string wrong = outcome(seed.kind, file, counts[seed.kind]);
      if (wrong.empty())
        continue;
      ++counts[seed.kind].failed;
      ++failures;
      const fs::path kept = folder / ("failed_" + std::to_string(i) + "." + seed.kind);
      fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
      std::cerr << "input " << i << " (" << seed.name << "), kept as " << kept.string() << ": "
                << wrong << "\n";
    }
  for (const auto &[kind, c] : counts)
    std::cout << kind << ": " << c.accepted << " accepted, " << c.refused << " refused, "
              << c.failed << " failed\n";
  return failures > 0 ? 1 : 0;
}

#endif
