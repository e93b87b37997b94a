// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/shared_waves.h>
#include <hybrid/continuum/wave_edges.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Waves alone by central differences, the pair beta = 0, gamma = 1/2 of Newmark:
   *   v_h = v0 + dt/2 a0,  u1 = u0 + dt v_h,
   *   (M + dt/2 C) a1 = f(t1) - K u1 - C v_h,  v1 = v_h + dt/2 a1.
   * M is diagonal, as all integrals are by Gauss-Lobatto quadrature on the nodes themselves
   * (spectral elements, Komatitsch and Vilotte 1998), C too but for the 2 x 2 blocks of dashpots on
   * slanting edges, so no system is solved. It is stable for dt <= 2 / w_max; a longer step of the
   * run is divided into equal parts.
   *
   * Energy: with D the change over a part, each force does the work Du . (F_0 + F_1) / 2, and
   *   D[1/2 v M v] = Du . (F_0 + F_1) / 2 + dt^2/8 D[a M a],  F = M a the sum of all forces,
   * so what the scheme itself takes is a function of the state: ContinuumEnergy::integration_loss
   * is - dt^2/8 a M a, and zero again when the rock is at rest.
   *
   * Rock that damps is strained by
   *   w = relaxed u + sum_l weight_l s_l + beta_K v_h
   * in place of u (MaxwellBody, Rayleigh): one product with K, as without damping. The velocity is
   * that of half a part before, which makes the stable part shorter:
   * dt^2 w_max^2 m + 2 beta_K w_max^2 dt <= 4, m the modulus of the body at once over the
   * material's. What damping takes is the work on w less what is stored.
   */
  class ExplicitWaves final : public SharedWaves
  {
  public:
    /// @param space as of SharedRock @param boundary on an edge basis by Lobatto's quadrature; must
    /// outlive this object.
    ExplicitWaves(const RockMesh       &rock,
                  ElementSpace         &space,
                  const CellMaterials  &material,
                  const JointStiffness &joint_stiffness,
                  const PointLoads     &loads,
                  BoundaryForces       &boundary,
                  const RockDamping    &damping,
                  MPI_Comm              communicator);

    int    parts(double dt) const override;
    void   start(ContinuumState &state) override;
    bool   step(ContinuumState &state, double dt) override;
    void   take_energy(ContinuumState &state) override;
    double memory() const override;

    /// By stresses.
    bool keeps_rock_work() const override
    {
      return damping.stiffness > 0. || damping.body.n_branches() > 0;
    }

  private:
    using Vector = ElasticProduct::Vector;

    std::array<const double *, 3> motion() const override
    {
      return {u.begin(), v.data(), a.data()};
    }

    void find_stable_step();

    /// @return whether f is still the force of this state's strains; false where no part needs it.
    bool load(const ContinuumState &state);
    void store(ContinuumState &state) const;

    /// Force of rock and joints strained by @p by, on this rank's unknowns and on the places.
    void find_rock_force(Vector &by);

    /// The same for the motion of now, whose velocity is the one @p later [s] after w's.
    void find_rock_force_now(double later);

    void   advance(ContinuumState &state, double time, double dt);
    void   accelerate(double dt);
    double inertia() const; ///< a M a of this rank
    double stored_energy(); ///< of this rank [J/m]; leaves f of another displacement

    const RockDamping   damping;
    ElasticProduct      stiffness;
    std::vector<double> mass; ///< of this rank's unknowns [kg/m]
    WaveEdges           edges;
    std::vector<int>    slots; ///< of the edges' nodes, in a state
    SharedNodes         places;
    double              stable_step = 0.; ///< [s]

    Vector                           u, f;
    Vector                           strained; ///< w, of rock that damps
    std::vector<double>              force0;   ///< f at the start of a part, likewise
    std::vector<std::vector<double>> branch;   ///< s_l [m]
    std::vector<double>              v, a;
    std::vector<double>              inverse_mass;             ///< [m/kg]
    std::vector<double>              rock_force0, rock_force1; ///< on the places [N/m]
    std::vector<double>              work;                     ///< of places
    double                           damped = 0.; ///< by mass, of this rank, in the step [J/m]
    double rock_work = 0.; ///< on rock that damps, of this rank, in the step [J/m]
  };
} // namespace hybrid::continuum
