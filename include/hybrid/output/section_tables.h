// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/output/history_file.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::output
{
  /**
   * What the section is made of, for pictures (run_file.md): section/bedding/NAME,
   * section/cells and cells_material of a continuum, section/blocks_material, and section/belt and
   * belt_material if the mass is bonded to its base. Materials are indices into the attribute
   * "materials" of the group.
   * @param model nullptr: no blocks
   */
  void write_section_materials(HistoryFile                  &file,
                               const scene::SceneParameters &scene,
                               const scene::SectionMesh     &mesh,
                               const dda::Model             *model);

  /// The line sliding_surface, if there is one: section/surface, and surface_offsets of its paths.
  void write_surface(HistoryFile &file, const scene::SectionMesh &mesh);
} // namespace hybrid::output
