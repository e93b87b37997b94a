// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/mesh_orders.h>
#include <hybrid/scene/mesh/level_layers.h>
#include <hybrid/scene/mesh/reentrant_corner.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <algorithm>

namespace hybrid::output
{
  MeshOrders mesh_orders(const scene::SceneParameters &scene,
                         const scene::SectionMesh     &mesh,
                         const bool                    has_blocks)
  {
    if (has_blocks)
      return {1., 2., 1., 0.5};
    constexpr double of_elements   = 2.;
    constexpr double most_assumed  = 4.;
    const double     of_dispersion = 2. * scene.continuum.degree;
    const bool       is_smooth = scene.bedding.names.empty() && scene.point_loads.loads.empty() &&
                           scene::has_level_layers(mesh) && !scene::has_reentrant_corner(mesh);
    return {of_elements,
            of_dispersion,
            is_smooth ? std::min(of_dispersion, most_assumed) : of_elements,
            scene.bedding.names.empty() ? 0.5 : 0.25};
  }
} // namespace hybrid::output
