// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/boundary/compliant_base.h>
#include <hybrid/scene/boundary/viscous_side.h>
#include <hybrid/scene/material.h>
#include <hybrid/scene/newmark.h>
#include <hybrid/scene/parameters/bedrock_model.h>
#include <hybrid/scene/parameters/block_parameters.h>
#include <hybrid/scene/parameters/checkpoint_parameters.h>
#include <hybrid/scene/parameters/environment_parameters.h>
#include <hybrid/scene/parameters/load_parameters.h>
#include <hybrid/scene/parameters/motion_parameters.h>
#include <hybrid/scene/parameters/region_materials.h>
#include <hybrid/scene/parameters/start_parameters.h>
#include <hybrid/scene/types.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

/**
 * @file
 * The parameters of a scene as plain structs, one per section of the parameter file.
 * Defaults stand here; names, units, ranges and help are declared next to each other in
 * src/scene/parameters/SECTION_parameters.cc. SI units inside; other units only at the parameter
 * boundary.
 */
namespace hybrid::scene
{
  /// The step of a second run, which tells the error of the first one's.
  enum class SecondRun
  {
    half_step,
    twice_the_step,
    none
  };


  /// Section "Time".
  struct TimeParameters
  {
    double      end_time         = 1.;          ///< duration of the dynamic stage [s], >= 0
    double      time_step        = 1e-3;        ///< dt [s], > 0
    int         maximum_halvings = 16;          ///< smallest step is dt / 2^this [-], 0..20
    std::string scheme           = "automatic"; ///< automatic, or one of Newmark::preset()
    Newmark     newmark;                        ///< what the scheme stands for in this scene
    double      maximum_displacement_ratio =
      0.05;                      ///< largest block displacement per step over block size [-]
    double    error_target = 0.; ///< of the time step: largest error over a peak [%]; 0: none
    bool      error_target_has_unit = false;                ///< the user wrote the unit
    SecondRun second_run            = SecondRun::half_step; ///< for the error of the step
    double    rest_speed = 0.; ///< the run ends when no block is faster [m/s]; 0: it does not
    double    dynamic_coefficient =
      1.; ///< k01 of the paper: factor on the velocity at the start of each step, (0, 1]
  };

  /// Section "Mesh".
  struct MeshParameters
  {
    std::string file; ///< .geo or .msh; resolved path
    std::vector<std::pair<std::string, double>>
      numbers; ///< ONELAB numbers set before meshing, "Resolution/h" -> 4
    std::vector<std::string>
      left_out; ///< numbers of the file that those of the command line replace, and do not name
    std::string
      polygons_file; ///< CSV block,x,y: blocks as polygons instead of the mesh's; resolved path
    std::string
         surface_file; ///< CSV x,y: polyline of a rigid base instead of the mesh's; resolved path
    bool coarser_runs  = true; ///< for the error of the mesh
    int  corner_levels = 0;    ///< halvings of the cells at inward corners of the bedrock
  };

  /// How the bedrock is integrated in time.
  enum class TimeIntegrator
  {
    implicit_steps, ///< Newmark's
    explicit_steps, ///< central differences on a diagonal mass, for waves alone
    automatic       ///< explicit where that is possible and takes less time
  };

  /// What solves the equations of an implicit step of the bedrock.
  enum class LinearSolver
  {
    automatic,          ///< what the scene, the machine and the number of processes allow
    factor,             ///< a sparse Cholesky factor, of each process alone
    conjugate_gradients ///< without a matrix, on all processes
  };

  /// How the dynamic stiffness of the bedrock's surface below blocks is held.
  enum class SurfaceForm
  {
    automatic, ///< banded where the surface is long and the band narrow
    dense,     ///< all entries
    banded     ///< entries that are more than round-off
  };

  /// Section "Continuum".
  struct ContinuumParameters
  {
    TimeIntegrator  integrator    = TimeIntegrator::implicit_steps;
    bool            is_explicit   = false; ///< what the integrator stands for in this scene
    LinearSolver    linear_solver = LinearSolver::automatic;
    SurfaceForm     surface_form  = SurfaceForm::automatic;
    int             degree        = 2; ///< polynomial degree of FE_Q, 1..8
    RegionMaterials region_material;   ///< of the regions of the bedrock
    BaseBoundary    base          = compliant_base();
    SideBoundary    sides         = viscous_side();
    bool            chooses_sides = true; ///< Sides = automatic, decided by resolve_sides()
    std::string
           half_space_material; ///< rock below the base; empty: that of the cells along the base
    double rayleigh_mass      = 0.;    ///< alpha_M [1/s], C = alpha_M M + beta_K K
    double rayleigh_stiffness = 0.;    ///< beta_K [s]
    bool   boundary_springs   = false; ///< springs beside the dashpots of base and sides
    double normal_spring      = 1.;    ///< alpha_n of k_n = alpha_n G / r [-]
    double tangential_spring  = 0.5;   ///< alpha_t of k_t = alpha_t G / r [-]
    double spring_distance    = 0.;    ///< r [m]; 0: of each face from the middle of the top
  };

  /// Section "Maxwell damping": a damping ratio that does not depend on frequency, see
  /// MaxwellBody.
  struct MaxwellParameters
  {
    double bedrock_ratio = 0.;  ///< of critical [-], [0, 0.25]; 0: off
    double block_ratio   = 0.;  ///< of critical, of the sliding mass [-], [0, 0.25]; 0: off
    double lowest        = 0.5; ///< frequency from which it holds [Hz], > 0
    double highest       = 10.; ///< frequency up to which it holds [Hz], > lowest
    int    branches      = 3;   ///< [-], 1..8

    bool is_on() const
    {
      return bedrock_ratio > 0. || block_ratio > 0.;
    }
  };

  /// Section "Bedding planes".
  struct BeddingParameters
  {
    std::vector<std::string>
           names; ///< lines of the mesh that are elastic joints; empty: all planes are welded
    double normal_stiffness      = 8e9;   ///< k_n [Pa/m]
    double shear_stiffness       = 3e9;   ///< k_s [Pa/m]
    bool   slips                 = false; ///< Mohr-Coulomb strength; else the joints are elastic
    double friction_angle        = 0.;    ///< [deg]
    double cohesion              = 0.;    ///< [Pa]
    double tensile_strength      = 0.;    ///< [Pa]
    double initial_normal_stress = 0.;    ///< compression besides that of gravity [Pa]
  };

  /// A named point whose motion is recorded.
  struct Monitor
  {
    std::string name;
    Vec2        position; ///< initial position [m]
  };

  /// A named vertical line along which displacement is recorded.
  struct Borehole
  {
    std::string         name;
    Vec2                top;    ///< [m]
    Vec2                bottom; ///< [m]
    int                 samples = 21;
    std::vector<double> measured_depth; ///< depths of measured values below the top [m]
    std::vector<double> measured_mm;    ///< measured downhill displacements there [mm]; only drawn
    std::vector<double> measured_error_mm; ///< either way, 0 if not known [mm]; only drawn
  };

  /// A named line along which motion is recorded.
  struct MonitorLine
  {
    std::string       name;
    std::vector<Vec2> points; ///< of the polyline [m]; empty: the mesh's line of this name
  };

  /// Section "Monitors" and section "Boreholes".
  struct MonitorParameters
  {
    std::vector<Monitor> monitors;
    std::string          file; ///< CSV name,x,z that some of them come from; resolved path
    std::string base_monitor;  ///< displacement is reported relative to this one; empty: absolute
    std::vector<Borehole> boreholes;
    int                   borehole_samples = 21; ///< points of each borehole
    double filter_frequency = 25.; ///< zero-phase low-pass for peaks and amplification [Hz]; 0: off
    bool   has_peak_fields  = true; ///< peaks at every node and block
    std::vector<MonitorLine> lines;
    std::string lines_file;      ///< CSV name,x,z that some of them come from; resolved path
    int         line_points = 0; ///< equally far apart on each line; 0: the line's own points
    double line_interval = 5e-3; ///< between their rows [s], rounded to whole steps, at least one
  };

  /// Section "Output".
  struct OutputParameters
  {
    std::string directory   = "output"; ///< resolved against the working directory
    double picture_interval = 0.1; ///< simulated time between VTU files [s]; 0: only first and last
    double flush_interval   = 2.;  ///< wall time between flushes of run.h5 [s]
    double audit_interval   = 0.01; ///< simulated time between energy audits [s]
    double slip_threshold   = 1e-3; ///< beyond it a part of the sliding surface has slipped [m]
    double energy_warning   = 0.01; ///< residual of the audit from which it is said; 0: never [-]
    double energy_limit     = 0.05; ///< residual at which the run stops; 0: never [-]
  };

  /// Everything a scene says.
  struct SceneParameters
  {
    std::string                     title;
    TimeParameters                  time;
    MeshParameters                  mesh;
    BedrockModel                    bedrock = continuum_bedrock();
    ContinuumParameters             continuum;
    MaxwellParameters               maxwell;
    BeddingParameters               bedding;
    BlockParameters                 blocks;
    HeterogeneityParameters         heterogeneity;
    EnvironmentParameters           environment;
    MotionParameters                motion;
    PointLoadParameters             point_loads;
    EdgeLoadParameters              edge_loads;
    InitialWaveParameters           initial_wave;
    MonitorParameters               monitors;
    OutputParameters                output;
    CheckpointParameters            checkpoint;
    std::map<std::string, Material> materials;
    double                          strength_reduction = 1.; ///< strengths are divided by it, > 0
    int                             threads            = 1;
    int                             shared_blocks      = 2000; ///< among processes, from here on
    std::string used_prm; ///< the scene with every parameter, as a valid parameter file

    /// The bedrock is finite elements.
    bool has_continuum() const
    {
      return bedrock.is_elements;
    }

    /// The bedrock is blocks.
    bool has_bedrock_blocks() const
    {
      return bedrock.cut != nullptr;
    }

    /// Waves leave through the base.
    bool has_compliant_base() const
    {
      return bedrock.carries_waves && continuum.base.is_compliant;
    }

    /// Any block at all: the sliding mass or the bedrock.
    bool has_blocks() const
    {
      return blocks.enabled || has_bedrock_blocks();
    }

    /// Bedding planes that slip have pore pressure at rest, and so has the rock between them: its
    /// stress at rest is effective.
    bool has_wet_planes() const;

    /// Material of the bedrock's region @p name. @throws InputError if it has none.
    const Material &bedrock_material(const std::string &region) const;

    /// Of blocks of a region of the mass, and of joints between them. @throws InputError if it has
    /// none.
    const Material &mass_material(const std::string &region, bool saturated) const;

    /// Names of those of the mass, each once: above the water, and below it where there is water.
    std::vector<std::string> mass_materials() const;

    /// Of the belt. @throws InputError if it has none.
    const Material &belt_material(bool saturated) const;

    /// Of joints and contacts along a line joint_<suffix> of the mass; nullptr: those of the
    /// blocks.
    const Material *joint_material(const std::string &line, bool saturated) const;

    /// Names of those of joints and belts, each once.
    std::vector<std::string> bond_materials() const;

    /// @throws InputError naming section and parameter @p where if @p name is not in the table.
    const Material &material(const std::string &name, const std::string &where) const;
  };
} // namespace hybrid::scene
