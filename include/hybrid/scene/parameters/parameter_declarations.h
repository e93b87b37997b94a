// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/parameter_section.h>
#include <hybrid/scene/parameters/scene_parameters.h>

/**
 * @file
 * One pair of functions per parameter struct, in src/scene/parameters/SECTION_parameters.cc:
 * declare() states name, member, unit, range and help of every parameter of the section;
 * check() finds what contradicts what, after all values are known, and throws InputError.
 */
namespace hybrid::scene
{
  void declare(ParameterTable &table, TimeParameters &time);

  void declare(ParameterTable &table, MeshParameters &mesh);

  /// Names in the last Mesh/Numbers of the files that are not in the last one of the command line,
  /// if there is one.
  std::vector<std::string> left_out_numbers(const std::vector<ParameterLine> &lines);

  /// Section "Materials", subsection of the material's name.
  void declare(ParameterTable &table, Material &material);

  /// Section "Continuum".
  void declare(ParameterTable &table, ContinuumParameters &continuum);

  /// Section "Maxwell damping".
  void declare(ParameterTable &table, MaxwellParameters &maxwell);

  void declare(ParameterTable &table, BeddingParameters &bedding);

  void declare(ParameterTable &table, BlockParameters &blocks);

  /// Sections "Gravity" and "Water".
  void declare(ParameterTable &table, EnvironmentParameters &environment);

  void declare(ParameterTable &table, HeterogeneityParameters &heterogeneity);

  void declare(ParameterTable &table, MotionParameters &motion);

  void declare(ParameterTable &table, PointLoadParameters &point_loads);

  void declare(ParameterTable &table, EdgeLoadParameters &edge_loads);

  void declare(ParameterTable &table, InitialWaveParameters &wave);

  /// Sections "Monitors" and "Boreholes".
  void declare(ParameterTable &table, MonitorParameters &monitors);

  void declare(ParameterTable &table, OutputParameters &output);

  void declare(ParameterTable &table, CheckpointParameters &checkpoint);

  /// Every section of a scene whose material table has its names.
  void declare(ParameterTable &table, SceneParameters &scene);


  /// Sets the time integration, once the bedrock is resolved. @throws InputError where the scheme
  /// does not fit the scene.
  void resolve_scheme(SceneParameters &scene, const ParameterTable &table);

  /// Continuum/Sides = automatic decided: free field where a motion comes in, else viscous.
  void resolve_sides(SceneParameters &scene);

  /// Sets Material::initial_ratio of all materials from Gravity/Initial stress, with friction
  /// angles that no factor has divided yet. @throws InputError for nonsense.
  void resolve_initial_stress(SceneParameters &scene, const ParameterTable &table);

  /// Time step against end time.
  void check(const TimeParameters &time, const ParameterTable &table);

  void check(const Material &material, const ParameterTable &table);

  void check(const MotionParameters &motion, const ParameterTable &table);

  void check(const MonitorParameters &monitors, const ParameterTable &table);

  /// Mesh files against the model.
  void check_mesh(const SceneParameters &scene, const ParameterTable &table);

  /// Materials of the bedrock.
  void check_continuum(const SceneParameters &scene, const ParameterTable &table);

  /// The band of Maxwell damping, and what it cannot go with.
  void check_maxwell(const SceneParameters &scene, const ParameterTable &table);

  /// Point loads against the model.
  void check_point_loads(const SceneParameters &scene, const ParameterTable &table);

  /// Boxes of edge loads, and edge loads against the model.
  void check_edge_loads(const SceneParameters &scene, const ParameterTable &table);

  /// The initial wave against the model.
  void check_initial_wave(const SceneParameters &scene, const ParameterTable &table);

  /// Materials of blocks and belt, initial velocities.
  void check_blocks(const SceneParameters &scene, const ParameterTable &table);

  /// Reads the tables of section "Water", which the level at the start may come from.
  /// @throws InputError where Level is given twice.
  void read_water(SceneParameters &scene, const ParameterTable &table);

  /// Water method against level, line and materials.
  void check_water(const SceneParameters &scene, const ParameterTable &table);

  /// What a bedrock of blocks cannot do.
  void check_bedrock(const SceneParameters &scene, const ParameterTable &table);

  /// @throws InputError at parameter @p path if the table of materials lacks @p name.
  void check_material_name(const SceneParameters &scene,
                           const std::string     &name,
                           const std::string     &path,
                           const ParameterTable  &table);

  /// All of the above.
  void check(const SceneParameters &scene, const ParameterTable &table);
} // namespace hybrid::scene
