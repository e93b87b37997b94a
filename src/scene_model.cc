// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/block_foundation.h>
#include <hybrid/coupling/condensed_foundation.h>
#include <hybrid/coupling/rigid_foundation.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/statics/lifts.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/output/memory_estimate.h>
#include <hybrid/output/mesh_progress.h>
#include <hybrid/output/probes.h>
#include <hybrid/output/sample_line.h>
#include <hybrid/output/watched_points.h>
#include <hybrid/partners.h>
#include <hybrid/returned_memory.h>
#include <hybrid/scene/checks/mesh_check.h>
#include <hybrid/scene/mesh/edge_chain.h>
#include <hybrid/scene/mesh/stable_step.h>
#include <hybrid/scene/parameters/linear_solver.h>
#include <hybrid/scene/parameters/time_integrator.h>
#include <hybrid/scene_model.h>

#include <algorithm>
#include <malloc.h>

namespace hybrid
{
  namespace
  {
    int size_of(const MPI_Comm communicator)
    {
      int size = 1;
      MPI_Comm_size(communicator, &size);
      return size;
    }



    bool shares_blocks(const scene::SceneParameters &scene, const std::size_t n_blocks)
    {
      return n_blocks >= static_cast<std::size_t>(scene.shared_blocks);
    }



    /// Processes that keep a factor of the bedrock in the memory of this machine: where blocks are
    /// shared out each has its own.
    int factors_here(const bool has_shared_blocks, const MPI_Comm communicator)
    {
      if (!has_shared_blocks)
        return 1;
      MPI_Comm here;
      MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
      const int count = size_of(here);
      MPI_Comm_free(&here);
      return count;
    }



    /// The polyline of a rigid base: sliding surface and ground of the mesh, left to right.
    std::vector<Vec2> surface_of(const scene::SectionMesh &mesh)
    {
      std::vector<scene::SectionMesh::Edge> edges;
      for (const char *name : {"ground", "sliding_surface"})
        {
          const auto line = mesh.lines.find(name);
          if (line != mesh.lines.end())
            edges.insert(edges.end(), line->second.begin(), line->second.end());
        }
      std::vector<Vec2> nodes;
      int               last = -1;
      for (const auto &edge :
           scene::chain_edges(edges, mesh.nodes, "of ground and sliding_surface"))
        {
          if (last >= 0 && edge[0] != last)
            break; // another path, farther right
          if (last < 0)
            nodes.push_back(mesh.nodes[edge[0]]);
          nodes.push_back(mesh.nodes[last = edge[1]]);
        }
      return nodes;
    }
  } // namespace



  SceneModel::SceneModel(const scene::SceneParameters &parameters,
                         output::Log                  &log,
                         MPI_Comm                      communicator)
    : mesh(output::read_section_mesh(parameters.mesh, log))
    , scene(scene::with_linear_solver(scene::with_time_integrator(parameters, mesh),
                                      size_of(communicator)))
    , input(scene::make_input_motion(parameters.motion, parameters.time))
    , motion(input.motion, parameters.motion, input.vertical)
    , processes(communicator)
  {
    const auto heartbeat = output::tell_of_preparation(mesh, log);
    scene::check_section_mesh(mesh, scene);
    if (scene.has_continuum())
      make_continuum(log, communicator);
    if (scene.has_blocks())
      {
        make_blocks();
        share_blocks();
      }
    if (scene.environment.is_staged())
      dda::check_lifts(*blocks);
    check_points();
    malloc_trim(0); // what set-up has left
  }



  void SceneModel::make_continuum(output::Log &log, const MPI_Comm communicator)
  {
    const bool iterates = scene.continuum.linear_solver == scene::LinearSolver::conjugate_gradients;
    if (iterates || scene.continuum.is_explicit)
      return_large_vectors();
    continuum = std::make_unique<continuum::Continuum>(
      mesh, scene, motion, scene.has_blocks() && !iterates ? MPI_COMM_SELF : communicator);
    if (scene.continuum.is_explicit ||
        scene.continuum.linear_solver != scene::LinearSolver::automatic ||
        (scene.has_blocks() && scene.continuum.surface_form == scene::SurfaceForm::dense) ||
        !continuum->resolution().finds_band || !scene::why_not_iterated(scene).empty())
      return;
    const double needed  = output::estimate_memory(scene, mesh, nullptr, continuum.get()).total();
    const int    factors = factors_here(shares_blocks(scene, mesh.blocks.size()), communicator);
    int          fits    = factors * needed <= output::available_memory() ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &fits, 1, MPI_INT, MPI_MIN, communicator); // all do the same
    if (fits == 1)
      return;
    log.info("A factor of the bedrock does not fit the memory of this machine: implicit steps by "
             "conjugate gradients");
    scene::SceneParameters iterated  = scene;
    iterated.continuum.linear_solver = scene::LinearSolver::conjugate_gradients;
    return_large_vectors();
    continuum.reset();
    continuum = std::make_unique<continuum::Continuum>(mesh, iterated, motion, communicator);
  }



  void SceneModel::make_blocks()
  {
    if (scene.has_bedrock_blocks())
      {
        make_bedrock_blocks();
        return;
      }
    std::unique_ptr<coupling::CondensedFoundation> condensed;
    if (continuum != nullptr)
      condensed = std::make_unique<coupling::CondensedFoundation>(*continuum);
    else
      foundation = std::make_unique<coupling::RigidFoundation>(surface_of(mesh), motion);
    const coupling::Foundation &base = condensed != nullptr ? *condensed : *foundation;
    blocks = std::make_unique<dda::Model>(dda::build_model(mesh, scene, base.surface_nodes()));
    blocks->initial.foundation_shares = base.surface_shares();
    if (condensed == nullptr)
      return;
    blocks->initial.foundation_degree = scene.continuum.degree;
    condensed->set_water(coupling::WaterOnBedrock::make(*blocks));
    foundation = std::move(condensed);
  }



  void SceneModel::share_blocks()
  {
    if (size_of(processes) > 1 && shares_blocks(scene, blocks->blocks.size()))
      blocks->processes = std::make_shared<Partners>(processes);
    else if (continuum == nullptr || continuum->ownership() == nullptr)
      processes = MPI_COMM_SELF; // else all compute all blocks, and the bedrock together
  }



  void SceneModel::make_bedrock_blocks()
  {
    std::vector<Vec2> nodes;
    for (const int node : scene::cut_bedrock(mesh, scene).foundation)
      nodes.push_back(mesh.nodes[node]);
    blocks     = std::make_unique<dda::Model>(dda::build_model(mesh, scene, nodes));
    foundation = std::make_unique<coupling::BlockFoundation>(nodes, motion, scene, *blocks);
  }



  coupling::CoupledState SceneModel::initial_state() const
  {
    coupling::CoupledState state;
    if (foundation != nullptr)
      foundation->start(state);
    else if (continuum != nullptr)
      state.continuum = continuum->initial_state();
    if (blocks != nullptr)
      state.blocks = dda::initial_state(*blocks);
    return state;
  }



  double SceneModel::end_of_loads() const
  {
    double end = motion.end();
    if (!scene.edge_loads.tractions.empty())
      end = std::max(end, scene.edge_loads.start + scene.edge_loads.rise_time);
    const scene::LinearTable &level = scene.environment.water_tables.level;
    if (!level.empty())
      end = std::max(end, level.points.back().x());
    if (!scene.point_loads.loads.empty()) // the wavelet is even about its peak
      end = std::max(end, scene.point_loads.start + 3. / scene.point_loads.frequency);
    return end;
  }



  void SceneModel::check_points()
  {
    output::Probes probes(blocks.get(), continuum.get(), foundation.get());
    for (const scene::Monitor &monitor : scene.monitors.monitors)
      monitor_blocks.push_back(probes.block(probes.add(monitor.position, monitor.name)));
    for (const scene::Borehole &hole : scene.monitors.boreholes)
      {
        for (const Vec2 &end : {hole.top, hole.bottom})
          probes.add(end, hole.name);
        for (int k = 1; k + 1 < hole.samples; ++k)
          probes.add(hole.top + k / (hole.samples - 1.) * (hole.bottom - hole.top),
                     hole.name + " sample " + std::to_string(k));
      }
    for (const output::SampleLine &line : output::sample_lines(scene, mesh))
      output::add_line_probes(line, probes);
    if (scene.monitors.monitors.empty()) // RunRecorder asks for these
      for (const scene::Monitor &point :
           output::watched_points(mesh,
                                  blocks.get(),
                                  continuum != nullptr || scene.has_bedrock_blocks())
             .points)
        probes.add(point.position, point.name);
    if (continuum != nullptr)
      continuum->watch(probes.points_of_bedrock());
  }
} // namespace hybrid
