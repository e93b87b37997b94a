// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/thin_layers.h>

#include <algorithm>
#include <cmath>

namespace hybrid::scene
{
  std::map<int, double> cell_thickness(const SectionMesh &mesh)
  {
    std::map<int, double> sum;
    std::map<int, int>    count;
    if (mesh.bedrock_surface.size() != mesh.bedrock_cells.size())
      return sum;
    for (std::size_t c = 0; c < mesh.bedrock_cells.size(); ++c)
      {
        const auto  &cell = mesh.bedrock_cells[c];
        const auto   x    = std::minmax({mesh.nodes[cell[0]].x(),
                                         mesh.nodes[cell[1]].x(),
                                         mesh.nodes[cell[2]].x(),
                                         mesh.nodes[cell[3]].x()});
        const double area = 0.5 * std::abs(cross(mesh.nodes[cell[2]] - mesh.nodes[cell[0]],
                                                 mesh.nodes[cell[3]] - mesh.nodes[cell[1]]));
        sum[mesh.bedrock_surface[c]] += area / (x.second - x.first);
        ++count[mesh.bedrock_surface[c]];
      }
    for (auto &[surface, thickness] : sum)
      thickness /= count[surface];
    return sum;
  }



  bool keeps_thin_layers(const std::map<int, double> &thickness,
                         const std::map<int, double> &coarser)
  {
    return thickness.size() > 1 &&
           std::any_of(thickness.begin(), thickness.end(), [&](const auto &layer) {
             const auto other = coarser.find(layer.first);
             return other != coarser.end() && other->second < std::sqrt(2.) * layer.second;
           });
  }
} // namespace hybrid::scene
