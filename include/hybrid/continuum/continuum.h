// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum_state.h>
#include <hybrid/continuum/ownership.h>
#include <hybrid/continuum/surface_force.h>
#include <hybrid/continuum/surface_stiffness.h>
#include <hybrid/restart/shared_checkpoint.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <mpi.h>
#include <string>
#include <vector>

namespace hybrid::continuum
{
  /**
   * The bedrock: linear elastodynamics in plane strain on deal.II finite elements. Without slip the
   * scene can ask for implicit steps without a matrix, without blocks also for explicit ones, both
   * shared out among MPI ranks (ImplicitWaves, ExplicitWaves). Else
   *   M u'' + C u' + K u = f(t) + B^T lambda,
   * integrated by Newmark's family; the unknowns of the surface that blocks
   * can touch are condensed:
   *   S u_G = g + lambda,  S = A_GG - A_GI A_II^-1 A_IG,
   * so that blocks see the whole bedrock as one more block. A step is
   *   1. predict(state, dt): forward substitution; returns g;
   *   2. the caller solves for u_G (with blocks: S u_G = g + lambda);
   *      contacts' part of lambda counts 1/(2 beta) there, see SurfaceForce;
   *   3. correct(state, dt, u_G, lambda): backward substitution; the state is that of t + dt.
   * Without blocks step(state, dt) does all three with lambda = 0.
   *
   * A rigid base takes the outcrop's acceleration; its velocity and displacement are those of the
   * Newmark scheme (the discrete integral of the record), so that no step excites high frequencies.
   * In the energy balance
   *   kinetic + strain + boundary_springs = input_work + surface_work - boundary_loss -
   * damping_loss - integration_loss the free-field columns stand outside; they send in input work.
   */
  class Continuum
  {
  public:
    /// @throws InputError for a mesh or parameters that cannot be used.
    Continuum(const scene::SectionMesh     &mesh,
              const scene::SceneParameters &scene,
              const scene::GroundMotion    &motion,
              MPI_Comm                      communicator);
    ~Continuum();

    /// State of rest at t = 0.
    ContinuumState initial_state() const;

    /// Put the scene's initial wave, if any, into @p state, with the acceleration of its
    /// equilibrium; only its tail may be at the contact surface, which stays at rest.
    void start_wave(ContinuumState &state);

    /// Where the initial wave is largest on the boundary at t = 0; on sides only if it is no plane.
    struct WaveReach
    {
      double fraction = 0.; ///< of the amplitude [-]; 0 without a wave
      Vec2   where    = Vec2::Zero();
    };

    WaveReach wave_at_boundary() const;

    /// Number of unknowns of the finite-element space (free-field columns not counted).
    std::size_t n_unknowns() const;

    /// Nodes of the contact surface [m], left to right; where a bedding plane with joints crops out
    /// two nodes follow each other at one place. Empty if the scene has no blocks.
    const std::vector<Vec2> &surface_nodes() const;

    /// Of a uniform load between two nodes of the surface, the part that the first one bears [-],
    /// by the shape functions of the elements; one fewer than the nodes.
    const std::vector<double> &surface_shares() const;

    /// Condensed dynamic stiffness S for the step dt [N/m per m], symmetric, 2 |nodes| square,
    /// unknowns (x0, y0, x1, y1, ...). Factored on first use; the last three step sizes are kept,
    /// and so long stays the reference valid. A supported unknown has a diagonal that is a million
    /// times as stiff.
    const SurfaceStiffness &surface_stiffness(double dt);

    /// By conjugate gradients S takes as long as some hundred steps: @p goes_on is asked after each
    /// solution, by all ranks together, and must answer all alike. Where it says no,
    /// surface_stiffness() throws Stopped.
    void watch_search(std::function<bool()> goes_on);

    /// Wall time that factors for the step sizes so far took [s].
    double factor_time() const;

    /// Forward substitution of the step from @p state to state.time + dt. @return g [N/m].
    const Eigen::VectorXd &predict(const ContinuumState &state, double dt);

    /// Where the surface would be after @p dt with constant acceleration: a first guess of u_G [m].
    void extrapolate_surface(const ContinuumState &state,
                             double                dt,
                             Eigen::VectorXd      &displacement) const;

    /// Backward substitution of the step that predict() began.
    /// @param surface_displacement u_G at the end of the step [m].
    /// @param surface_force lambda at the end of the step.
    void correct(ContinuumState        &state,
                 double                 dt,
                 const Eigen::VectorXd &surface_displacement,
                 const SurfaceForce    &surface_force);

    /// Slip of the bedding planes for u_G found with the load of predict(), or of this function
    /// before; nothing to do where planes do not slip. If it changed, surface_load() is new and u_G
    /// has to be found again; correct() follows when it is settled. Without a matrix: the rock
    /// below that surface; failed if its conjugate gradients do not converge.
    SlipStatus
    solve_slip(const ContinuumState &state, double dt, const Eigen::VectorXd &surface_displacement);

    /// g of the step that has begun [N/m].
    const Eigen::VectorXd &surface_load() const;

    /// A whole step without blocks (lambda = 0). @return false if the slip of bedding planes was
    /// not found; the state is that of before then.
    bool step(ContinuumState &state, double dt);

    /// Conjugate gradients solve the equations of implicit steps.
    bool is_iterated() const;

    /// Equal parts into which a step of @p dt [s] is divided; 1 unless it is explicit.
    int parts_of_step(double dt) const;

    /// Bedding planes that may slip; empty if the scene has none.
    const std::vector<BeddingPlane> &slipping_planes() const;

    /// What the points of @p plane do now.
    BeddingValues bedding_values(const ContinuumState &state, const BeddingPlane &plane) const;

    /// The sums of @p state with its energies of now (kinetic, strain); after explicit steps
    /// collect() comes before.
    [[nodiscard]] ContinuumEnergy audit_energy(const ContinuumState &state) const;

    /// What a point of the bedrock does: displacement, velocity, acceleration.
    struct Sample
    {
      Vec2 displacement, velocity, acceleration;
    };

    /// All nodes before the first step [m]; once ranks that share them have called watch(), those
    /// that this one draws.
    const std::vector<Vec2> &node_positions() const;
    const Vec2              &node_position(int node) const;

    /// Corners of the cells [m].
    const std::vector<Vec2> &corners() const;

    /// Linear quadrilaterals between the nodes, their number, and those that this rank writes.
    std::vector<std::array<int, 4>> cells() const;
    std::size_t                     n_cells() const;
    std::vector<std::array<int, 4>> cells_to_write() const;

    /// Two nodes at one place on the two sides of a bedding plane, and its tangent.
    struct Facing
    {
      int  left, right;
      Vec2 tangent;
    };

    /// Every such pair of nodes once; of planes that end on each other once for each.
    const std::vector<Facing> &facing_nodes() const;

    /// A material point: nodes of its cell with weights.
    struct Point
    {
      int                 cell = -1;
      std::vector<double> weights;
      double              outside = 0.; ///< that the position was outside [m]; infinite: far
    };

    /// The point of the bedrock nearest to an initial position. Positions that are outside by more
    /// than a part of a cell and @p reach [m] count as far from everything.
    Point point(const Vec2 &position, double reach = 0.) const;

    /**
     * The point at an initial position in a cell that has a face through it, with the rock to the
     * left of @p direction: the side of a bedding plane that runs along this unit vector.
     * @param reach that the position may be beside the face [m]
     * @param alignment cosine of the angle between face and direction; 0 and no cell if there is no
     * face within 25 degrees.
     */
    Point point_beside(const Vec2 &position,
                       const Vec2 &direction,
                       double      reach,
                       double     &alignment) const;

    Sample sample(const ContinuumState &state, const Point &point) const;

    /// Whose the unknowns are; null: each rank has all.
    const Ownership *ownership() const;

    /// Points whose motion collect() brings; all ranks name the same.
    void watch(const std::vector<Point> &points) const;

    /// After steps that leave each rank with its own part: the motion of the watched points, and
    /// what audit_energy() needs if @p energy. All ranks call it.
    void collect(ContinuumState &state, bool energy) const;

    /// What ranks share of a checkpoint of @p state, written or read, and of serialize_rest().
    std::vector<restart::SharedVector> shared_vectors(ContinuumState &state) const;
    restart::SharedVector              shared_rest() const;

    /// Plain arrays for pictures: one linear quadrilateral per sub-cell of each cell. Where ranks
    /// share the bedrock, each has as many nodes and cells, by number; cells name nodes by their
    /// numbers in all.
    struct Picture
    {
      std::vector<Vec2>                  points;
      std::vector<std::array<int, 4>>    cells;
      std::vector<int>                   region;        ///< per cell
      std::vector<Vec2>                  displacement;  ///< per point [m]
      std::vector<Vec2>                  velocity;      ///< per point [m/s]
      std::vector<std::array<double, 3>> stress;        ///< per cell xx, yy, xy [Pa], increment
      std::vector<std::array<double, 3>> static_stress; ///< per cell xx, yy, xy [Pa]
    };

    /// All ranks call it.
    Picture picture(const ContinuumState &state) const;

    /// Static stresses of the restrained model (base fixed, sides on rollers) under gravity and
    /// @p surface_force [N/m]; they change no displacement (the section is the deformed state in
    /// place).
    /// Bedding planes slip if gravity alone asks for it; what they carry then is their traction at
    /// rest. Where no slip is enough they keep the tractions of elastic joints, beyond their
    /// strength: what they hold slides from the first step on.
    /// @param horizontal lasting acceleration of the rock's mass along +x [m/s2].
    /// @param pore_pressure at a place of rock or plane [Pa]; it stays as it is. Stresses at rest
    /// are effective then (Terzaghi 1943): int B^T (p, p, 0) dA and the pressure in the planes act
    /// beside @p surface_force, which has the water above the rock. Only planes that slip feel it.
    /// None: all is dry.
    StaticSlip solve_static_state(const Eigen::VectorXd                     &surface_force,
                                  double                                     gravity,
                                  double                                     horizontal    = 0.,
                                  const std::function<double(const Vec2 &)> &pore_pressure = {});

    /// What solve_static_state() found, for the checkpoint.
    void serialize_rest(restart::Archive &archive);

    /// Smallest edge length of cells per wave speed etc. for the scene card.
    struct Resolution
    {
      int         cells             = 0;
      double      slowest_s_wave    = 0.; ///< [m/s]
      double      fastest_p_wave    = 0.; ///< [m/s]
      double      highest_frequency = 0.; ///< resolved with ten nodes per shortest wave length [Hz]
      std::size_t surface_unknowns  = 0;
      bool        surface_is_banded = false; ///< of S a band is kept, else all entries
      bool        finds_band        = true;  ///< steps without a matrix find S, too
      double      s_time = 0.; ///< an S wave's way up, mean over the width of the section [s]
      double      p_time = 0.; ///< the same of a P wave [s]
      double cell_time   = 0.; ///< an S wave's way through a cell [s]: on average over the way up,
                               ///< with the power 2 degree with which dispersion counts it
    };

    Resolution resolution() const;

    /**
     * What the corrected inertia of the fourth order leaves of the trapezoidal rule's error, on
     * average over a wave's way up: q / (1 + q) in a cell with q = (dt / t)^4 / 2 and t a wave's
     * way from node to node [-]. It is the term tau^3 M X^3 of inertia_correction.h with the
     * tractions on the cell's ends. The factor 1/2 is that of one element in one dimension, degrees
     * 1 to 4 (0.25 to 0.6).
     *
     * @param pressure P waves, else S waves
     */
    double uncorrected_part(double dt, bool pressure) const;

    /// What steps take beside the model itself [B]: the factor of one step size and the condensed
    /// matrices; each further step size (cut steps, at most two) takes about as much.
    double estimated_memory() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> impl;
  };
} // namespace hybrid::continuum
