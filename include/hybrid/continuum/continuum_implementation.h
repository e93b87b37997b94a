// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/bedding_slip.h>
#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/condensation.h>
#include <hybrid/continuum/continuum.h>
#include <hybrid/continuum/element_nodes.h>
#include <hybrid/continuum/initial_rock_stress.h>
#include <hybrid/continuum/maxwell_memory.h>
#include <hybrid/continuum/node_matrices.h>
#include <hybrid/continuum/picture_share.h>
#include <hybrid/continuum/point_loads.h>
#include <hybrid/continuum/rock_mesh.h>
#include <hybrid/continuum/shared_waves.h>
#include <hybrid/continuum/system_pattern.h>
#include <hybrid/continuum/wave_packet.h>

#include <list>
#include <memory>
#include <vector>

namespace hybrid::continuum
{
  class ImplicitWaves;

  /// Nodes of a side that hang together, and where rock is not: -1 left of them, 1 right.
  struct SidePart
  {
    std::vector<int> nodes;
    double           outward;
  };


  /// Inside of Continuum. Unknowns: "dof" is 2 node + component; "system" is the numbering of the
  /// factored matrix, without supported unknowns, the surface last.
  struct Continuum::Implementation
  {
    RockMesh                           rock;
    std::vector<int>                   cell_region;
    CellMaterials                      cell_material;
    std::shared_ptr<ElementNodes>      nodes;
    NodeMatrices                       matrices;
    JointStiffness                     joint_stiffness; ///< of bedding planes
    std::unique_ptr<BoundaryForces>    boundary;
    std::unique_ptr<BeddingSlip>       slip; ///< null unless bedding planes may slip
    std::vector<BeddingPlane>          slipping_planes;
    std::unique_ptr<InitialRockStress> initial_stress; ///< null: Gravity/Initial stress = elastic
    PointLoads                         point_loads;
    std::unique_ptr<WavePacket>        wave; ///< at t = 0; null: none
    WaveReach                          wave_reach;
    Newmark                            newmark;
    std::unique_ptr<SharedWaves>       waves;    ///< null: there is a factored system
    ImplicitWaves *below_blocks = nullptr;       ///< waves on which blocks stand; null: none do
    std::unique_ptr<PictureShare> picture_share; ///< null before the first picture
    double                        rayleigh_mass = 0., rayleigh_stiffness = 0.;
    MaxwellMemory                 maxwell; ///< Maxwell damping

    std::vector<Vec2> surface_positions;
    std::vector<int>  surface;       ///< nodes of the contact surface from left to right
    std::vector<int>  surface_slots; ///< where a state has them (HeldNodes)
    std::vector<double>
      surface_shares; ///< per two of them: what the first bears of a uniform load between them [-]
    std::vector<Facing>   facing;
    std::vector<int>      left_nodes, right_nodes, base_nodes;
    std::vector<SidePart> side_parts;
    std::vector<double>
      static_displacement; ///< of the restrained model [m], empty before solve_static_state(); of
                           ///< this rank's unknowns where ranks share them

    // the static model (continuum_static.cc)
    bool              has_weight = false;      ///< the scene has a static stage
    std::vector<char> static_supports() const; ///< per unknown: held at rest
    /// Fills pull and pulled. @param forces all that act on nodes at rest [N/m]
    void find_pull(const std::vector<double> &forces, StaticSlip &result) const;
    /// Without a matrix. All ranks call it.
    StaticSlip solve_static_waves(const std::vector<double> &forces);
    bool       knows_rest() const; ///< static_displacement; all ranks call it

    // the factored system
    std::vector<int>              dof_of_system, system_of_dof; ///< -1: not in the system
    std::vector<int>              fixed_dofs;                   ///< displacement zero
    SystemPattern                 pattern;
    std::unique_ptr<Condensation> factorisation;
    bool                          is_banded     = false; ///< of S a band is kept
    bool                          may_find_band = true;  ///< finds_band()
    double                        band_memory   = 0.;    ///< without a matrix [B]

    /// Forces that a moving base of unit displacement in x or y exerts on an unknown of the system.
    struct BaseCoupling
    {
      int    system;
      double x, y;
    };

    /// What is kept for one step size.
    struct StepMatrix
    {
      double                                dt = 0.;
      std::shared_ptr<Condensation::Factor> factor;
      SurfaceStiffness                      surface_stiffness;
      Eigen::MatrixXd                       slip_relaxation; ///< G of BeddingPlanes
      std::vector<BaseCoupling>             base;
    };
    std::list<StepMatrix> step_matrices;    ///< most recently used first, at most 3
    double                factor_time = 0.; ///< wall time that making them took [s]
    std::shared_ptr<Condensation::Factor>
      inertia_factor; ///< of M without supported unknowns; null before it is asked for

    // work vectors of a step, allocated once
    std::vector<double>      predicted, rate, load, product, product2, mean, rhs, solution;
    std::vector<double>      column_u, column_v, column_a, column_change;
    BoundaryForces::Incoming incoming0, incoming1;
    std::vector<double>      edge0, edge1, edge_force0, edge_force1, edge_du, edge_du_ff, edge_v_ff;
    std::vector<double>      edge_u0, edge_u1, edge_u_ff; ///< with boundary springs only
    std::vector<double>      du, da, u1, v1, a0, a1, c1;  ///< da: what makes the scheme's loss
    double                   filter = 0.;                 ///< Newmark::filter_in() of this step [-]
    std::vector<double>      slip_work, excess0, excess1; ///< with slipping planes only
    bool                     columns_settled = true; ///< the slip of the columns' joints was found
    MaxwellState             maxwell1;        ///< at the end of the step, with Maxwell damping only
    std::vector<double>      column_stressed; ///< the columns' MaxwellMemory::stressed(), likewise
    Eigen::VectorXd          surface_load, surface_motion;

    std::size_t n_dofs() const
    {
      return 2 * static_cast<std::size_t>(nodes->size());
    }

    /// Null: each rank has all.
    const Ownership *ownership() const
    {
      const bool is_shared = waves != nullptr && !waves->ownership().is_alone();
      return is_shared ? &waves->ownership() : nullptr;
    }

    /// Of the rock, in a state of this rank.
    std::size_t n_held() const
    {
      return waves != nullptr ? 2 * waves->ownership().held().size() : n_dofs();
    }

    /// Where a state has a node; -1: it does not.
    int slot(const int node) const
    {
      return waves != nullptr ? waves->ownership().held().slot(node) : node;
    }

    // construction (continuum.cc)
    void take_rock(const scene::SectionMesh &mesh, const scene::SceneParameters &scene);
    void take_static_model(const scene::SectionMesh &mesh, const scene::SceneParameters &scene);
    void take_surface(const scene::SectionMesh &mesh, const scene::SceneParameters &scene);
    /// Steps without a matrix: explicit ones, or conjugate gradients.
    void make_waves(const scene::SectionMesh     &mesh,
                    const scene::SceneParameters &scene,
                    const scene::GroundMotion    &motion,
                    MPI_Comm                      communicator);
    /// Implicit steps with a factored matrix, on which blocks may stand.
    void make_system(const scene::SectionMesh     &mesh,
                     const scene::SceneParameters &scene,
                     const scene::GroundMotion    &motion,
                     MPI_Comm                      communicator);
    void number_system();
    void make_condensation(const scene::SceneParameters &scene);
    /// Unknowns as far from one of the surface as S reaches in a step, by the speed of waves.
    int expected_reach(const scene::SceneParameters &scene) const;
    /// Of steps without a matrix. @throws InputError if there is no band.
    void make_band(const scene::SceneParameters &scene);
    /// Whether steps without a matrix find S: of a short surface, or as a narrow band.
    bool finds_band(const scene::SceneParameters &scene) const;
    void allocate_work();
    void add_point_loads(const scene::PointLoadParameters &loads);

    /// A cell and a place in it, and how far from the position that is over the cell's radius.
    struct NearestCell
    {
      int    cell = -1; ///< -1: all are farther than half their radius and the reach
      Vec2   local;
      double distance = 1e300;
    };

    /// Of cells that share the position the upper one: on a bedding plane the rock above it.
    NearestCell nearest_cell(const Vec2 &position, double reach) const;

    /// Cell and shape function values at a position. @throws InputError naming @p what if outside.
    Point cell_point(const Vec2 &position, const std::string &what) const;

    /// Of the static model, xx, yy, xy [Pa]. @param displacement of the cell's nodes [m]
    std::array<double, 3>
    static_stress(int cell, const Vec2 &local, const std::vector<double> &displacement) const;

    std::vector<Facing> find_facing_nodes() const;

    /// Of nodes and cells that ranks share only what this one draws, or samples at @p points, is
    /// left, once the rest has been set up with all.
    void forget_others(const std::vector<Point> &points);

    /// All ranks call it.
    const PictureShare &share_of_pictures();

    /// Between the nodes of these cells.
    std::vector<std::array<int, 4>> quadrilaterals(const Portion &portion) const;

    // the wave at t = 0 (continuum_start.cc)
    void add_wave(const scene::InitialWaveParameters &parameters, const scene::SectionMesh &mesh);
    void find_acceleration(ContinuumState &state);

    // one step (continuum_step.cc)
    StepMatrix               &step_matrix(double dt);
    std::vector<BaseCoupling> base_coupling(const std::vector<double> &blocks) const;
    void                      predict(const ContinuumState &state, double dt);
    // its parts; forces are in product
    void                  predict_columns(const ContinuumState &state, double dt);
    void                  add_predicted_inertia(const ContinuumState &state, double dt);
    void                  add_rock_forces(const ContinuumState &state, double dt);
    void                  add_boundary_forces();
    void                  set_right_hand_side(const StepMatrix &matrix, double time, double dt);
    void                  newmark_acceleration(const ContinuumState &state);
    void                  keep_change(ContinuumState &state, double dt) const;
    Condensation::Factor &factor_of_inertia();
    void                  solve_inertia(const std::vector<double> &force, std::vector<double> &a);
    void                  take_acceleration(std::vector<double> &a) const; ///< what solution holds
    void set_surface(const Eigen::VectorXd &values); ///< surface_motion, zero at supports
    void accelerate_by(const Eigen::VectorXd &surface_force, std::vector<double> &a);
    void add_contacts(ContinuumState &state, const SurfaceForce &force);
    void take_displacement(const ContinuumState &state, double dt);
    void expand(double dt, const Eigen::VectorXd &surface_displacement);
    void finish(ContinuumState &state, double dt, const SurfaceForce &force);

    // Maxwell damping (continuum_maxwell.cc); called only where there is some
    MaxwellBody make_maxwell(const scene::MaxwellParameters &parameters);
    void        prepare_maxwell(const scene::MaxwellParameters &parameters);
    void take_maxwell(const ContinuumState &state, double dt); ///< maxwell1, once u1 is known
    /// Force of the excess on the moving base [N/m].
    Vec2 base_maxwell(const MaxwellState &state) const;
    /// The columns' displacement with the excess, for BoundaryForces::incoming(); null without
    /// Maxwell damping. @param u their displacement
    const double *columns_stressed(const MaxwellState &state, const double *u);

    // slip of bedding planes (continuum_slip.cc); called only where planes slip
    void             prepare_slip(const scene::BeddingParameters &bedding);
    Eigen::MatrixXd  slip_relaxation(const std::vector<int>     &number,
                                     Condensation               &system,
                                     const Condensation::Factor &factor) const;
    std::vector<int> free_unknowns() const;
    SlipStatus       update_slip(const ContinuumState &state, double dt);
    void             add_joint_force(double factor, const double *x, std::vector<double> &y);
    void             add_slip_energy(ContinuumState &state);
    void             base_excess(const std::vector<double> &jump,
                                 const std::vector<double> &velocity,
                                 std::vector<double>       &force);

    /// Parts of add_energy(): work of boundary, moving base and interface forces over the step.
    /// @return the change of these forces times the displacement of the step [J/m].
    double add_boundary_energy(ContinuumState &state);
    void   add_spring_forces(const ContinuumState &state);
    void   add_spring_energy(ContinuumState &state);
    double add_base_energy(ContinuumState &state, double dt);
    double add_surface_energy(ContinuumState &state, const SurfaceForce &force);
    double add_point_load_energy(ContinuumState &state, double dt);

    // energy of a step (continuum_energy.cc)
    void gather_boundary(const std::vector<double> &x, std::vector<double> &on_boundary) const;
    void add_boundary(const std::vector<double> &on_boundary, std::vector<double> &x) const;
    void add_energy(ContinuumState &state, double dt, const SurfaceForce &force);
    Vec2 base_reaction(const double              *u,
                       const double              *v,
                       const double              *a,
                       const std::vector<double> &edge_force) const;

    /// Force that the moving base takes for the acceleration @p a of the rock's nodes; empty: none.
    Vec2 base_inertia(const std::vector<double> &a) const;
    /// y = C x without dashpots, C = alpha_M M + beta_K K (K without joints that may slip); @p work
    /// is overwritten.
    void multiply_rayleigh(const double *x, std::vector<double> &y, std::vector<double> &work);
  };
} // namespace hybrid::continuum
