// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::dda
{
  /// What the bedding planes of a bedrock of blocks do at rest.
  struct BeddingRest
  {
    bool   equilibrium = true;
    int    slipping    = 0;  ///< ends of joints at their shear strength
    int    open        = 0;  ///< ends of joints without traction
    double largest     = 0.; ///< largest slip [m]
    Vec2   where{0., 0.};    ///< its place; without equilibrium where shear in elastic planes is
                             ///< farthest beyond the strength [m]
    int plane = -1;          ///< there, among the scene's names; -1: none
  };


  /**
   * Tractions at rest of bedding planes with strength (Bedding planes/Strength = Mohr-Coulomb).
   *
   * They are those of a model of its own: the bedrock of the mesh cut into triangles (a layer in
   * one piece could only have tractions that are linear along a plane), with its weight and what
   * the settled mass and the water put on its surface, base fixed, sides on rollers, planes with
   * their strength, which may slip until the rest carries the load; besides, the uniform
   * compression `Initial normal stress`. Below water the pore pressure takes over a part of them,
   * once the dry planes rest, and they come to rest again: tractions are effective. It is solved
   * with a thousandth of loads and strengths: displacements are then so small that the tractions
   * are those of the undeformed section, as in the finite-element bedrock.
   *
   * The joints of @p state get the elastic stretch that belongs to these tractions, without slip;
   * ends that opened stay broken. The blocks bear these tractions from the start, as they do the
   * mass's forces: nothing moves until something changes.
   *
   * @param under_gravity false: only the uniform compression
   */
  BeddingRest stress_bedding_planes(const scene::SectionMesh     &mesh,
                                    const scene::SceneParameters &scene,
                                    const Model                  &model,
                                    bool                          under_gravity,
                                    DdaState                     &state);
} // namespace hybrid::dda
