// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::scene
{
  struct SceneParameters;
  struct SectionMesh;
} // namespace hybrid::scene

namespace hybrid::output
{
  /// Orders p that the error of a mesh of the size h can have: it falls with h^p.
  struct MeshOrders
  {
    double lowest;  ///< of waves that the mesh resolves
    double highest; ///< of smooth waves, not below the lowest
    double assumed; ///< where three meshes show none; between these
    double left;    ///< part of the unknowns or blocks that cells twice as large have, at most
  };


  /**
   * Of blocks, which have constant strain, 1 (their joints) to 2.
   *
   * Of elements of degree q 2 to 2 q, that of the waves' dispersion (Ainsworth & Wajid 2009), which
   * is the only error of waves in level layers; where corners, planes or point loads are, the
   * lowest is assumed. More than 4 is assumed nowhere: meshes that show no order do not resolve the
   * waves, and high orders need that most.
   *
   * A quarter of the unknowns is left if all cells are twice as large, up to half where bars and
   * slopes have one column or row of them. Lines of bedding planes keep more: there the quarter
   * counts.
   */
  MeshOrders
  mesh_orders(const scene::SceneParameters &scene, const scene::SectionMesh &mesh, bool has_blocks);
} // namespace hybrid::output
