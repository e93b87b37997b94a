// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/boundary/free_field_side.h>
#include <hybrid/scene/boundary/viscous_side.h>
#include <hybrid/scene/parameters/parameter_declarations.h>

namespace hybrid::scene
{
  namespace
  {
    const char *const automatic_sides = "automatic";

    std::vector<std::string> words_of_sides()
    {
      std::vector<std::string> words{automatic_sides};
      for (const SideBoundary &sides : side_boundaries())
        words.push_back(sides.name);
      return words;
    }

    void pick_sides(ContinuumParameters &continuum, const std::string &word)
    {
      continuum.chooses_sides = word == automatic_sides;
      for (const SideBoundary &sides : side_boundaries())
        if (sides.name == word)
          continuum.sides = sides;
    }
  } // namespace

  void resolve_sides(SceneParameters &scene)
  {
    if (!scene.continuum.chooses_sides)
      return;
    const bool         comes_in = scene.motion.type != "none" && scene.continuum.base.takes_motion;
    const SideBoundary free_field = free_field_side();
    scene.continuum.sides =
      comes_in && scene.bedrock.can_have(free_field) ? free_field : viscous_side();
  }

  void declare(ParameterTable &table, ContinuumParameters &continuum)
  {
    ParameterSection section(table, {"Continuum"});
    section.integer(
      "Degree",
      continuum.degree,
      {1, 8},
      "Polynomial degree of the finite elements; 2 for waves, 4 for point sources (doc/accuracy-vs-time.md).");
    section.choice<TimeIntegrator>(
      "Time integrator",
      continuum.integrator,
      {{"implicit", TimeIntegrator::implicit_steps},
       {"explicit", TimeIntegrator::explicit_steps},
       {"automatic", TimeIntegrator::automatic}},
      "implicit: Newmark's steps (Time/Scheme). explicit: central differences on a diagonal mass, "
      "for waves alone, with no matrix and in as many parts of Time/Time step as are stable; "
      "mpirun shares the cells out. automatic: explicit where that is possible and takes less time.");
    section.choice<LinearSolver>(
      "Linear solver",
      continuum.linear_solver,
      {{"automatic", LinearSolver::automatic},
       {"factor", LinearSolver::factor},
       {"conjugate gradients", LinearSolver::conjugate_gradients}},
      "Of implicit steps, which a named one asks for. factor: sparse Cholesky, on one process. conjugate gradients: with no "
      "matrix; mpirun shares the cells out. Planes that may slip need a factor. Both give the same motion. automatic: "
      "conjugate gradients where they are possible and the factor does not fit the memory, or where "
      "15 processes or more take less time for waves alone; else factor.");
    section.choice<SurfaceForm>(
      "Surface stiffness",
      continuum.surface_form,
      {{"automatic", SurfaceForm::automatic},
       {"dense", SurfaceForm::dense},
       {"banded", SurfaceForm::banded}},
      "Entries of the dynamic stiffness of the bedrock's surface below blocks. dense: all, 24 B "
      "times the square of its unknowns. banded: those as far as waves go in a step, the others "
      "are round-off; a step solves twice as often for the interior. Both give the same motion. "
      "automatic: banded from 6,000 unknowns on, where the band is expected to reach over a quarter of them or less.");
    section.value(
      "Materials",
      "a material's name, or 'region: material; region: material; ...'",
      [&continuum](const std::string &text) {
        continuum.region_material = RegionMaterials::parse(text);
      },
      "Material of the bedrock: one name for all regions, or one per region of the mesh (bedrock, "
      "bedrock_<suffix>).");
    section.option("Base",
                   continuum.base,
                   base_boundaries(),
                   "Base of the bedrock: compliant absorbs what leaves and lets the motion in, "
                   "rigid moves as the outcrop, fixed does not move.");
    section.choice(
      "Sides",
      words_of_sides(),
      automatic_sides,
      [&continuum](const std::string &word) { pick_sides(continuum, word); },
      "Left and right side: viscous dashpots; dashpots relative to the free field of a column beside "
      "the model; rollers; or fixed. automatic: free field where a motion comes in through the base "
      "of a bedrock that carries waves, else viscous.");
    section.text("Half space material",
                 continuum.half_space_material,
                 "a material's name, or empty",
                 "Rock below a compliant base; empty: that of the cells along the base.");
    section.number("Rayleigh mass",
                   continuum.rayleigh_mass,
                   "1/s",
                   ParameterRange::closed(0., 1e6),
                   "alpha_M of the damping C = alpha_M M + beta_K K.");
    section.number("Rayleigh stiffness",
                   continuum.rayleigh_stiffness,
                   "s",
                   ParameterRange::closed(0., 1e3),
                   "beta_K of the damping C = alpha_M M + beta_K K.");
    section.toggle("Boundary springs",
                   continuum.boundary_springs,
                   "Visco-elastic boundaries: springs beside the dashpots of a compliant base and "
                   "of viscous or free-field sides, so that nothing drifts under a lasting load.");
    section.number("Normal spring coefficient",
                   continuum.normal_spring,
                   "-",
                   ParameterRange::at_least(0.),
                   "alpha_n of the boundary springs, k_n = alpha_n G / r (Liu et al. 2006: 0.8 to "
                   "1.2).");
    section.number("Tangential spring coefficient",
                   continuum.tangential_spring,
                   "-",
                   ParameterRange::at_least(0.),
                   "alpha_t of the boundary springs, k_t = alpha_t G / r (Liu et al. 2006: 0.35 to "
                   "0.65).");
    section.number("Spring distance",
                   continuum.spring_distance,
                   "m",
                   ParameterRange::at_least(0.),
                   "r of the boundary springs: distance from the load to the boundary; 0: that of "
                   "each face from the middle of the model's top.");
  }

  void declare(ParameterTable &table, BeddingParameters &bedding)
  {
    ParameterSection section(table, {"Bedding planes"});
    section.names(
      "Names",
      bedding.names,
      "Lines of the mesh (bedding_<n>) that are elastic joints; the others are welded.");
    section.number("Normal stiffness",
                   bedding.normal_stiffness,
                   "Pa/m",
                   {0., 1e16, false, true},
                   "Normal stress per opening.");
    section.number("Shear stiffness",
                   bedding.shear_stiffness,
                   "Pa/m",
                   {0., 1e16, false, true},
                   "Shear stress per slip.");
    section.choice<bool>("Strength",
                         bedding.slips,
                         {{"elastic", false}, {"Mohr-Coulomb", true}},
                         "elastic: the planes neither slip nor open; Mohr-Coulomb: they slip at "
                         "c + sigma tan phi and open at the tensile strength, after which a point "
                         "keeps only its friction.");
    section.number("Friction angle",
                   bedding.friction_angle,
                   "deg",
                   {0., 90., true, false},
                   "phi of Strength = Mohr-Coulomb.");
    section.number("Cohesion",
                   bedding.cohesion,
                   "Pa",
                   ParameterRange::at_least(0.),
                   "c of Strength = Mohr-Coulomb.");
    section.number("Tensile strength",
                   bedding.tensile_strength,
                   "Pa",
                   ParameterRange::at_least(0.),
                   "Tension cut-off of Strength = Mohr-Coulomb; at most c / tan phi counts.");
    section.number("Initial normal stress",
                   bedding.initial_normal_stress,
                   "Pa",
                   ParameterRange::at_least(0.),
                   "Uniform compression on the planes at rest, besides that of gravity.");
  }

  void check_continuum(const SceneParameters &scene, const ParameterTable &table)
  {
    const auto has_cells = [](const BedrockModel &bedrock) { return bedrock.has_cells(); };
    if (scene.bedding.slips && !scene.bedrock.has_cells())
      throw table.error("Bedding planes/Strength",
                        "Mohr-Coulomb needs a bedrock that deforms (Model/Bedrock = " +
                          names_in_words(bedrock_models(), has_cells) + ")");
    if (!scene.bedrock.has_cells())
      return;
    if (scene.continuum.region_material.empty())
      throw table.error("Continuum/Materials",
                        scene.has_bedrock_blocks()
                          ? "a bedrock of blocks needs a material"
                          : "Model/Bedrock = " + scene.bedrock.name + " needs a material");
    const bool dashpots = scene.continuum.base.is_compliant || scene.continuum.sides.has_dashpots();
    if (scene.continuum.boundary_springs && (!dashpots || !scene.has_continuum()))
      throw table.error("Continuum/Boundary springs",
                        "true needs a bedrock of finite elements with a compliant base, viscous or "
                        "free-field sides");
    for (const std::string &name : scene.continuum.region_material.names())
      check_material_name(scene, name, "Continuum/Materials", table);
    if (!scene.continuum.half_space_material.empty())
      check_material_name(scene,
                          scene.continuum.half_space_material,
                          "Continuum/Half space material",
                          table);
  }
} // namespace hybrid::scene
