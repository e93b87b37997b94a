// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>
#include <hybrid/scene/types.h>

#include <string>
#include <vector>

namespace hybrid::continuum
{
  /// What a point of a bedding plane does.
  enum class PlaneCondition : unsigned char
  {
    elastic,  ///< within the strength
    slipping, ///< shear traction at the strength
    open      ///< no traction
  };


  /// How the slip of a step stands.
  enum class SlipStatus
  {
    settled, ///< the tractions are within the strength
    changed, ///< the planes slipped: the step has to be solved with their new load
    failed   ///< no slip was found that the strength allows
  };


  /// What gravity alone does to the bedding planes.
  struct StaticSlip
  {
    bool   equilibrium = true;
    int    slipping    = 0;  ///< points at their shear strength
    int    open        = 0;  ///< points without traction
    double largest     = 0.; ///< largest slip [m]
    Vec2   where{0., 0.};    ///< its place; without equilibrium where shear in elastic planes is
                             ///< farthest beyond the strength [m]
    int    plane  = -1;      ///< there, among the scene's names; -1: none
    bool   solved = true;    ///< the static displacement of the rock is known
    double pull   = 0.;      ///< with which the rollers of a side hold rock back that would slide
                             ///< away from them, above or between planes [N/m]; 0: they press
    Vec2 pulled{0., 0.};     ///< the middle of that part of the side [m]
  };


  /// Mutable state of the bedding planes at their points (BeddingPlanes); empty where they do not
  /// slip.
  struct SlipState
  {
    std::vector<double>         jump;      ///< opening and slip of each point since rest [m]
    std::vector<double>         path;      ///< sum of |slip| per point [m]
    std::vector<char>           failed;    ///< per point: cohesion and tensile strength are lost
    std::vector<PlaneCondition> condition; ///< per point, of the last step
  };

  /// All members, for the checkpoint.
  void serialize(restart::Archive &archive, SlipState &state);


  /// A plane that may slip, for output.
  struct BeddingPlane
  {
    std::string       name;
    std::vector<Vec2> points;  ///< [m]
    std::vector<int>  numbers; ///< of the points among those of all planes
  };


  /// What the points of one plane do.
  struct BeddingValues
  {
    std::vector<double> slip;          ///< of the side to the left of the tangent, along it [m]
    std::vector<double> opening;       ///< plastic part [m]
    std::vector<double> normal_stress; ///< compression positive [Pa]
    std::vector<double> shear_stress;  ///< [Pa]
    std::vector<double> condition;     ///< PlaneCondition as a number
  };
} // namespace hybrid::continuum
