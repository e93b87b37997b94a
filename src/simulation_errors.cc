// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_orders.h>
#include <hybrid/output/watched_points.h>
#include <hybrid/scene/mesh/corner_cells.h>
#include <hybrid/scene/mesh/thin_layers.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/simulation.h>

#include <algorithm>

// What further runs for the errors of a run compute.

namespace hybrid
{
  std::string Simulation::coarser_mesh(const double factor) const
  {
    if (model.mesh.resolutions.empty() || !model.scene.mesh.polygons_file.empty())
      return "";
    std::string text;
    for (const auto &[name, value] : model.scene.mesh.numbers)
      if (model.mesh.resolutions.count(name) == 0)
        text += name + " = " + scene::number_text(value) + "; ";
    for (const auto &[name, value] : model.mesh.resolutions)
      text += name + " = " + scene::number_text(factor * value) + "; ";
    return text;
  }



  std::string Simulation::why_no_coarser_mesh() const
  {
    if (!model.scene.mesh.polygons_file.empty())
      return "the blocks are given as polygons, which cannot be made coarser";
    return coarser_mesh(2.).empty() ? "the mesh has no numbers Resolution/... to make it coarser by"
                                    : "";
  }



  std::vector<std::string> Simulation::watched_points() const
  {
    if (!model.scene.monitors.monitors.empty())
      return {};
    const output::WatchedPoints watched =
      output::watched_points(model.mesh,
                             model.blocks.get(),
                             model.continuum != nullptr || model.scene.has_bedrock_blocks());
    std::string points;
    for (const scene::Monitor &point : watched.points)
      points += point.name + ": " + scene::number_text(point.position.x()) + ", " +
                scene::number_text(point.position.y()) + "; ";
    std::vector<std::string> result = {"Monitors/Points=" + points};
    if (watched.base > 0)
      result.push_back("Monitors/Base=" + watched.points.back().name);
    return result;
  }



  std::vector<scene::ReentrantCorner> Simulation::corners_of_bedrock() const
  {
    return model.continuum != nullptr ? scene::corners_of_bedrock(model.mesh)
                                      : std::vector<scene::ReentrantCorner>();
  }



  std::map<int, double> Simulation::cell_thickness() const
  {
    return model.continuum != nullptr ? scene::cell_thickness(model.mesh) : std::map<int, double>();
  }



  double Simulation::mesh_count() const
  {
    return n_blocks() > 0               ? n_blocks()
           : model.continuum != nullptr ? static_cast<double>(model.continuum->n_unknowns())
                                        : 0.;
  }



  output::MeshOrders Simulation::mesh_orders() const
  {
    return output::mesh_orders(model.scene, model.mesh, n_blocks() > 0);
  }
} // namespace hybrid
