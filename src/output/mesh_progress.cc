// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/formatted.h>
#include <hybrid/output/mesh_progress.h>
#include <hybrid/output/terminal.h>
#include <hybrid/scene/mesh/section_mesh_reader.h>

#include <iostream>

namespace hybrid::output
{
  namespace
  {
    // Cells that take so long that a user should know what is going on: some seconds.
    constexpr double      many_to_mesh    = 2e4;
    constexpr std::size_t many_to_prepare = 100000;



    std::unique_ptr<Heartbeat> beat(const char *what)
    {
      return std::make_unique<Heartbeat>(std::cout, standard_output_is_terminal(), what);
    }
  } // namespace



  scene::SectionMesh read_section_mesh(const scene::MeshParameters &parameters, Log &log)
  {
    std::unique_ptr<Heartbeat> heartbeat;
    return scene::read_section_mesh(parameters, [&](const double cells) {
      if (cells < many_to_mesh)
        return;
      log.info(formatted("Meshing: up to %.2g million cells, this takes a while", 1e-6 * cells));
      heartbeat = beat("Meshing");
    });
  }



  std::unique_ptr<Heartbeat> tell_of_preparation(const scene::SectionMesh &mesh, Log &log)
  {
    const std::size_t cells = mesh.bedrock_cells.size() + mesh.blocks.size();
    if (cells < many_to_prepare)
      return nullptr;
    log.info("Preparing " + std::to_string(cells) + " cells and blocks: this takes a while");
    return beat("Preparing");
  }
} // namespace hybrid::output
