// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/region_materials.h>
#include <hybrid/scene/parameters/start_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /// Section "Blocks".
  struct BlockParameters
  {
    bool            enabled = true;     ///< section "Model", parameter "Blocks" (bonded | none)
    RegionMaterials material;           ///< blocks and body joints above the water level, by region
    RegionMaterials saturated_material; ///< same below; where empty: same as material
    std::string     belt_material; ///< joints on the sliding surface; empty: unbonded frictional
                                   ///< contact of the block material
    std::string
      saturated_belt_material;       ///< same below the water level; empty: same as belt_material
    RegionMaterials joint_materials; ///< of joints and contacts on lines joint_<suffix> of the
                                     ///< mass, by line; where empty: those of the blocks
    RegionMaterials saturated_joint_materials; ///< same below; where empty: same as joint_materials
    bool            yielding      = false; ///< blocks yield inside at the strength of their joints
    bool            bonded        = true;  ///< edges shared by blocks are artificial joints
    double          penalty_ratio = 40.;   ///< alpha: joint stiffness k_n = alpha E / h [-], > 1
    double          shear_ratio   = 1.;    ///< k_s / k_n [-], (0, 1]
    double          fracture_energy = 10.; ///< G_f [N/m] (J/m2), >= 0; 0 is brittle
    double softening_slip = 0.1; ///< slip over which shear strength falls to its residual [m], >= 0
    double damping_ratio  = 0.;  ///< stiffness-proportional damping of blocks and joints [-]
    double damping_frequency = 2.; ///< frequency at which it holds [Hz], > 0
    double loose_damping =
      1.; ///< of the shape of a block that no joint holds, of critical [-], >= 0
    bool stiffness_correction =
      true; ///< take the joints' compliance off the blocks' (design: bonds cost stiffness)
    int    maximum_iterations = 80;   ///< of the open-close iteration before the step is cut [-]
    double tolerance          = 1e-8; ///< relative force residual of the open-close iteration [-]
    std::vector<InitialVelocity> initial_velocities; ///< of blocks that do not start from rest
  };

  /// Section "Heterogeneity": factors of mean 1 with Weibull's distribution.
  struct HeterogeneityParameters
  {
    double modulus_shape = 0.; ///< m of the blocks' Young modulus [-], > 0; 0: uniform
    double strength_shape =
      0.; ///< m of the joints' cohesion and tensile strength [-], > 0; 0: uniform
    int seed = 1;
  };
} // namespace hybrid::scene
