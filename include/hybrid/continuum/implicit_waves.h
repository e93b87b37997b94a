// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/elastic_joints.h>
#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/point_loads.h>
#include <hybrid/continuum/rock_damping.h>
#include <hybrid/continuum/shared_waves.h>
#include <hybrid/continuum/surface_force.h>
#include <hybrid/continuum/surface_stiffness.h>

#include <functional>
#include <list>
#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Newmark's implicit steps of the bedrock without a matrix, shared out among the ranks: the
   * motion of the factored system. The unknown is the acceleration at the end of a step,
   *   [M + N + gamma dt C + beta dt^2 K] a1 = f1 - C v_p - K u_p,
   * u_p and v_p what Newmark's pair gives for a1 = 0, N the correction of the inertia
   * (inertia_correction.h), C = alpha_M M + beta_K K + dashpots, K with joints, springs of the
   * boundary and Maxwell branches. Conjugate gradients with the diagonal as preconditioner solve
   * it, to 1e-13 of the right-hand side, from the acceleration of before.
   *
   * Below blocks a step solves for the interior I alone, with the surface G held: once with the
   * surface's acceleration a0 of before, which leaves the residual r on it, once with that which
   * the blocks have found. With S = (A_GG - A_GI A_II^-1 A_IG) / (beta dt^2), A the matrix above,
   *   S u_G = g + lambda,   g = r + S (u_p + beta dt^2 a0)_G.
   * The band of S comes from products with it, each a solution for the interior (surface_band()).
   * All ranks know the surface alike, to the bit.
   *
   * All integrals are by Gauss quadrature as in assemble_elastic(). Energy is added up as in
   * continuum_energy.cc, by each rank for its unknowns; for boundaries and loads by all alike.
   */
  class ImplicitWaves final : public SharedWaves
  {
  public:
    struct Model
    {
      const RockMesh         &rock;
      ElementSpace           &space;    ///< as of SharedRock
      const CellMaterials    &material; ///< per cell
      const JointStiffness   &joints;   ///< of bedding planes
      const PointLoads       &loads;
      BoundaryForces         &boundary; ///< must outlive this object
      RockDamping             damping;
      Newmark                 newmark;
      const std::vector<int> &surface; ///< nodes below blocks, left to right; empty: none
    };

    ImplicitWaves(const Model &model, MPI_Comm communicator);

    int parts(double) const override
    {
      return 1;
    }

    void   start(ContinuumState &state) override;
    bool   step(ContinuumState &state, double dt) override;
    void   take_energy(ContinuumState &state) override;
    double memory() const override;

    /// Asked after each solution while S is found, on all ranks alike; see Continuum.
    void watch_search(std::function<bool()> goes_on)
    {
      search_goes_on = std::move(goes_on);
    }

    /// S of the surface for steps of @p dt [N/m per m], a band; the last three sizes are kept. All
    /// ranks call this and what follows.
    /// @throws Stopped if who watches ends the search
    const SurfaceStiffness &surface_stiffness(double dt);

    /// Begin a step below blocks. @param load receives g [N/m].
    void predict(const ContinuumState &state, double dt, Eigen::VectorXd &load);

    /// The interior for a surface that comes there; correct() follows with the same displacement.
    /// @return whether it, and that of predict(), were found.
    bool follow_surface(double dt, const Eigen::VectorXd &surface_displacement);

    /// End the step that predict() has begun; see Continuum::correct().
    /// @throws std::runtime_error if follow_surface() was not called and fails
    void correct(ContinuumState        &state,
                 double                 dt,
                 const Eigen::VectorXd &surface_displacement,
                 const SurfaceForce    &force);

  private:
    using Vector  = ElasticProduct::Vector;
    using Weights = ElasticProduct::Weights;

    /// cells + joints K_joints + dashpots Z + springs k: a symmetric sum. Supported unknowns have
    /// no rows.
    struct System
    {
      ImplicitWaves &waves;
      Weights        cells;
      double         joints = 0., dashpots = 0., springs = 0.;
      bool           holds_surface = false; ///< the surface has no rows, too

      void vmult(Vector &to, const Vector &from) const;
    };

    /// Motion of this rank's unknowns, or of the places.
    struct Motion
    {
      std::vector<double> u, v, a;
    };

    std::array<const double *, 3> motion() const override
    {
      return {now.u.data(), now.v.data(), now.a.data()};
    }

    using Branches = std::vector<std::vector<double>>; ///< s_l of this rank's unknowns [m]

    static constexpr double step_residual = 1e-13; ///< over the right-hand side

    /// The same for the inertia alone, which a correction makes small for what the step does not
    /// resolve, and for entries of S.
    static constexpr double fine_residual = 1e-15;

    int  place_of(int node);
    void find_places(const Model &model);
    void allocate();

    System step_system(double dt);

    /// M + N
    System inertia()
    {
      return {*this, {0., 1., 1.}};
    }

    Vector inverse_diagonal(const System &system);

    /// Solve system a = load for free unknowns; supported and held ones are as @p a has them, the
    /// others a guess. @param residual_left over the right-hand side @return whether it was found.
    bool solve(const System &system,
               const Vector &inverse_diagonal,
               double        residual_left,
               Vector       &load,
               Vector       &a);

    void          load_motion(const ContinuumState &state);
    void          store(ContinuumState &state, double dt);
    void          begin(const ContinuumState &state, double dt); ///< a step, up to its force f
    void          predict(double dt);
    void          keep_change(double dt, double last_step); ///< of the filter
    const Vector &step_diagonal(const System &system, double dt);
    void          step_columns(const ContinuumState &state, double dt);
    void          find_incoming(double                     time,
                                const Motion              &of_columns,
                                const std::vector<double> &branches,
                                BoundaryForces::Incoming  &in);

    /// Force less that of the unknown acceleration, on this rank's unknowns [N/m].
    /// @param of, branches motion that strains @param in, at of the places @param time of loads
    void find_force(const Motion                   &of,
                    const Branches                 &branches,
                    const BoundaryForces::Incoming &in,
                    const Motion                   &at,
                    double                          time);

    void set_supported(Vector &a, const Vec2 &of_base) const; ///< zero, or that of the base
    void finish(double dt);
    void advance_branches(double dt); ///< next_branch from now

    /// K of joints times shared_x, into shared_y.
    void add_joints(double factor);

    /// to = weights of K and M, K with joints, on this rank's unknowns.
    void multiply(const Weights &weights, const std::vector<double> &from, Vector &to);

    /// y . (weights of K and M) x of this rank
    double
    product(const Weights &weights, const std::vector<double> &x, const std::vector<double> &y);

    void gather(const Motion &of, Motion &at); ///< of the places

    /// relaxed u + sum weight_l s_l + beta_K v: what strains the rock.
    void strain(const Motion &of, const Branches &branches, std::vector<double> &result) const;

    /// Forces of the boundary on its nodes [N/m].
    void boundary_forces(const BoundaryForces::Incoming &in,
                         const Motion                   &at,
                         std::vector<double>            &force) const;

    /// The contact surface, known alike on all ranks (implicit_waves_surface.cc).
    struct Surface
    {
      /// S of one step size.
      struct Kept
      {
        double           dt = 0.;
        SurfaceStiffness stiffness;
      };

      SharedNodes               nodes;
      std::vector<int>          slots;     ///< of the nodes, in a state
      std::vector<unsigned int> mine;      ///< of this rank's unknowns
      std::vector<char>         supported; ///< per unknown
      std::list<Kept>           kept;      ///< most recently used first, at most 3
      std::vector<double>       u, v, a;   ///< at the end of the step; a as predicted before
      std::vector<double>       work;
      Eigen::VectorXd           known; ///< displacement for the acceleration of before
      bool                      is_predicted = false, is_followed = false; ///< in this step
    };

    void find_surface(const std::vector<int> &surface_nodes);
    void hold_surface(Vector &a) const; ///< zero
    void put_surface(const std::vector<double> &values, std::vector<double> &of_state) const;

    /// For the acceleration of the surface that @p a holds, find that of the interior.
    /// @return whether it was found.
    bool solve_interior(double dt, double residual_left, Vector &load, Vector &a);

    Eigen::MatrixXd  surface_product(double dt, const Eigen::MatrixXd &x);
    SurfaceStiffness find_surface_stiffness(double dt);

    /// M^-1 of forces on the surface, of this rank's unknowns. @return false without forces
    bool accelerate_by(const Eigen::VectorXd &surface_force, std::vector<double> &acceleration);
    void take_contacts(const SurfaceForce &force); ///< off the acceleration of now
    void add_contacts(ContinuumState &state, const SurfaceForce &force);

    // energy (implicit_waves_energy.cc)
    void   add_energy(ContinuumState &state, double dt, const SurfaceForce &force);
    double add_surface_energy(ContinuumState &state, const SurfaceForce &force);
    Vec2   contact_reaction(); ///< of the moving base
    double add_boundary_energy(ContinuumState &state);
    double add_base_energy(ContinuumState &state, double dt);
    Vec2   base_reaction(const Motion              &of,
                         const Branches            &branches,
                         const std::vector<double> &edge_force);
    double damping_work(double dt, double &of_change);

    BoundaryForces   &boundary;
    const RockDamping damping;
    const Newmark     newmark;
    ElasticProduct    cells;
    ElasticJoints     planes;
    std::vector<int>  list;          ///< nodes with a place; first those of the boundary
    std::vector<int>  slots;         ///< of these, in a state
    std::vector<int>  place;         ///< per node, -1: none; in the constructor only
    std::vector<int>  joint_places;  ///< of the planes' nodes
    std::vector<int>  moving_places; ///< of the moving base's
    PointLoads        point_loads;   ///< on places
    SharedNodes       places;

    std::vector<unsigned int>                fixed;              ///< of this rank, that do not move
    std::array<std::vector<unsigned int>, 2> moving;             ///< with the base, along x and y
    double                                   diagonal_step = 0.; ///< whose diagonal is kept [s]
    Vector                                   diagonal;           ///< of its matrix, inverted
    Vector                                   inertia_diagonal;   ///< inverted; below blocks
    Vector                                   f, a1, work, work2, from_work, step_load;
    Surface                                  surface;
    std::function<bool()>                    search_goes_on;        ///< empty: it does
    std::vector<double>                      c1;                    ///< by contacts [m/s2]
    bool                                     contacts_push = false; ///< in this step

    Motion                   before, now, edges0, edges1, columns, next_columns;
    std::vector<double>      column_change, next_column_change; ///< remembered by a filter
    std::vector<double>      column_branch, next_column_branch; ///< branch after branch
    std::vector<double>      column_strained, change;
    Branches                 branch, next_branch;
    BoundaryForces::Incoming incoming0, incoming1, nothing;
    std::vector<double>      strained, sum, force0, force1, du, du_free, v_free, mean;
    std::vector<double>      shared_x, shared_y, of_joints, joint_force, edge_work;
    double                   filter = 0.; ///< Newmark::filter_in() of this step
  };
} // namespace hybrid::continuum
