// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/memory_estimate.h>
#include <hybrid/output/formatted.h>
#include <hybrid/output/line_recorder.h>
#include <hybrid/output/memory_estimate.h>
#include <hybrid/output/peak_fields.h>
#include <hybrid/output/watched_points.h>

#include <algorithm>
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace hybrid::output
{
  namespace
  {
    constexpr double megabyte = 1048576.;

    /// Resident memory now [B].
    double resident_memory()
    {
      std::ifstream file("/proc/self/statm");
      double        all = 0., resident = 0.; // pages
      return file >> all >> resident ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.;
    }



    /// Largest resident memory so far [B].
    double peak_memory()
    {
      rusage usage;
      return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024. * static_cast<double>(usage.ru_maxrss)
                                                 : 0.;
    }



    /// Numbers that a run keeps: run.h5 and once more while it is flushed; what peaks are taken
    /// from, in vectors with room for up to twice as many.
    double history_numbers(const scene::SceneParameters &scene)
    {
      const double steps    = scene.time.end_time / scene.time.time_step;
      const double monitors = 6. * static_cast<double>(scene.monitors.monitors.size());
      double       profiles = 0.;
      for (const scene::Borehole &hole : scene.monitors.boreholes)
        profiles += 2. * hole.samples;
      constexpr double time = 1., motion = 6., step = 4., input = 2.;
      const double     watched = scene.monitors.monitors.empty() ? 6. * WatchedPoints::most : 0.;
      const double filtered = scene.monitors.filter_frequency > 0. ? time + 2. / 3. * monitors : 0.;
      return steps * (2. * (time + motion + step + monitors + filtered + profiles) +
                      2. * (time + input + monitors + watched));
    }
  } // namespace



  namespace
  {
    /// Nodes of the bedrock whose peaks this process keeps.
    std::size_t nodes_here(const continuum::Continuum *continuum)
    {
      if (continuum == nullptr)
        return 0;
      const continuum::Ownership *shared = continuum->ownership();
      return shared != nullptr ? shared->portion().size() : continuum->n_unknowns() / 2;
    }
  } // namespace



  MemoryEstimate estimate_memory(const scene::SceneParameters &scene,
                                 const scene::SectionMesh     &mesh,
                                 const dda::Model             *blocks,
                                 const continuum::Continuum   *continuum)
  {
    MemoryEstimate estimate;
    malloc_trim(0); // what reading and meshing have left
    estimate.built       = resident_memory();
    estimate.continuum   = continuum != nullptr ? continuum->estimated_memory() : 0.;
    estimate.preparation = peak_memory();
    if (blocks != nullptr)
      {
        const dda::SolverMemory solver = dda::estimated_memory(*blocks, continuum != nullptr);
        const bool              loose  = blocks->joints.empty(); // what touches may slide at once
        estimate.blocks                = solver.bonded + (loose ? solver.sliding : 0.);
        estimate.sliding               = loose ? 0. : solver.sliding;
      }
    const double rows = scene.time.end_time / LineRecorder::interval(scene);
    // as the others, in run.h5 and once more while it is flushed
    const double lines = 2. * sizeof(float) * rows * LineRecorder::numbers_per_row(scene, mesh);
    estimate.histories = sizeof(double) * history_numbers(scene) + lines;
    if (scene.monitors.has_peak_fields)
      estimate.histories +=
        PeakFields::memory(nodes_here(continuum) + (blocks != nullptr ? blocks->n_blocks() : 0));
    return estimate;
  }



  double available_memory()
  {
    double memory =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    std::ifstream limit("/sys/fs/cgroup/memory.max"); // "max" without a limit
    double        bytes = 0.;
    if (limit >> bytes && bytes > 0.)
      memory = std::min(memory, bytes);
    return memory;
  }



  std::string describe(const MemoryEstimate &estimate, const int processes)
  {
    const std::string of_each = processes > 1 ? " for each process" : "";
    std::string       text =
      formatted("Memory     about %.0f MB%s: program and model %.0f, bedrock %.0f, blocks %.0f, "
                "histories %.0f",
                estimate.total() / megabyte,
                of_each.c_str(),
                estimate.built / megabyte,
                estimate.continuum / megabyte,
                estimate.blocks / megabyte,
                estimate.histories / megabyte);
    if (estimate.sliding > 0.)
      {
        text += formatted("; once joints slide %.0f more", estimate.sliding / megabyte);
      }
    return text;
  }



  std::string
  memory_warning(const MemoryEstimate &estimate, const int processes, const double available)
  {
    const double needed = processes * (estimate.total() + estimate.sliding);
    if (needed <= available)
      return "";
    const std::string who =
      processes > 1 ? "the " + std::to_string(processes) + " processes on this machine need"
                    : "the run needs";
    const std::string advice =
      processes > 1 ? "fewer processes, of several threads each (Time/Threads), or a coarser mesh"
                    : "a coarser mesh";
    return formatted("%s about %.0f MB of memory, this machine has %.0f MB; %s %s less",
                     who.c_str(),
                     needed / megabyte,
                     available / megabyte,
                     advice.c_str(),
                     processes > 1 ? "need" : "needs");
  }
} // namespace hybrid::output
