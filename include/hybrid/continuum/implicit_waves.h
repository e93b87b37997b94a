// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/elastic_joints.h>
#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/point_loads.h>
#include <hybrid/continuum/rock_damping.h>
#include <hybrid/continuum/shared_waves.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Waves alone by Newmark's implicit steps without a matrix, shared out among the ranks: the
   * motion of the factored system. The unknown is the acceleration at the end of a step,
   *   [M + N + gamma dt C + beta dt^2 K] a1 = f1 - C v_p - K u_p,
   * u_p and v_p what Newmark's pair gives for a1 = 0, N the correction of the inertia
   * (inertia_correction.h), C = alpha_M M + beta_K K + dashpots, K with joints, springs of the
   * boundary and Maxwell branches. Conjugate gradients with the diagonal as preconditioner solve
   * it, to 1e-13 of the right-hand side, from the acceleration of before.
   *
   * All integrals are by Gauss quadrature as in assemble_elastic(). Energy is added up as in
   * continuum_energy.cc, by each rank for its unknowns; for boundaries and loads by all alike.
   */
  class ImplicitWaves final : public SharedWaves
  {
  public:
    struct Model
    {
      const RockMesh       &rock;
      ElementSpace         &space;    ///< as of SharedRock
      const CellMaterials  &material; ///< per cell
      const JointStiffness &joints;   ///< of bedding planes
      const PointLoads     &loads;
      BoundaryForces       &boundary; ///< must outlive this object
      RockDamping           damping;
      Newmark               newmark;
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

    /// Solve system a = load for free unknowns; supported ones are as @p a has them, the others a
    /// guess. @param residual_left over the right-hand side @return whether it was found.
    bool solve(const System &system,
               const Vector &inverse_diagonal,
               double        residual_left,
               Vector       &load,
               Vector       &a);

    void load_motion(const ContinuumState &state);
    void store(ContinuumState &state, double dt);
    void predict(double dt);
    void step_columns(const ContinuumState &state, double dt);
    void find_incoming(double                     time,
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

    // energy (implicit_waves_energy.cc)
    void   add_energy(ContinuumState &state, double time, double dt);
    double add_boundary_energy(ContinuumState &state);
    double add_base_energy(ContinuumState &state);
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
    std::vector<int>  place;         ///< per node, -1: none; in the constructor only
    std::vector<int>  joint_places;  ///< of the planes' nodes
    std::vector<int>  moving_places; ///< of the moving base's
    PointLoads        point_loads;   ///< on places
    SharedNodes       places;

    std::vector<unsigned int>                held;               ///< of this rank, that do not move
    std::array<std::vector<unsigned int>, 2> moving;             ///< with the base, along x and y
    double                                   diagonal_step = 0.; ///< whose diagonal is kept [s]
    Vector                                   diagonal;           ///< of its matrix, inverted
    Vector                                   f, a1, work, work2, from_work;

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
