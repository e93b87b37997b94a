// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum_state.h>
#include <hybrid/continuum/ownership.h>
#include <hybrid/continuum/shared_nodes.h>
#include <hybrid/continuum/shared_rock.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <vector>

namespace hybrid::continuum
{
  /**
   * The bedrock without a matrix, shared out among the ranks: waves alone, or below blocks
   * (ImplicitWaves). After a step each rank knows the motion of its own unknowns, of boundaries,
   * joints and the surface below blocks, and of the free-field columns.
   */
  class SharedWaves
  {
  public:
    virtual ~SharedWaves() = default;

    /// Equal parts into which a step of @p dt [s] is divided.
    virtual int parts(double dt) const = 0;

    /// Acceleration and energy of a state whose displacement and velocity are given.
    virtual void start(ContinuumState &state) = 0;

    /// One step of the run. @return false if the motion is not finite, or was not found.
    virtual bool step(ContinuumState &state, double dt) = 0;

    /// Energies of now, which a step does not add up; all ranks call it.
    virtual void take_energy(ContinuumState &state) = 0;

    /// What this rank holds besides the state [B].
    virtual double memory() const = 0;

    /// ContinuumEnergy::rock_work counts, for strain and damping together.
    virtual bool keeps_rock_work() const
    {
      return false;
    }

    /// What RestrainedRock takes besides, as long as it is there [B].
    double static_memory() const;

    /// Nodes whose motion collect_watched() brings to all ranks. States made before do not hold
    /// them.
    void watch(const std::vector<int> &nodes);

    void collect_watched(ContinuumState &state);

    const Ownership &ownership() const
    {
      return owned;
    }

    const SharedRock &rock() const
    {
      return shared;
    }

  protected:
    SharedWaves(ElementSpace &space, MPI_Comm communicator);

    /// Displacement, velocity, acceleration of this rank's unknowns after a step.
    virtual std::array<const double *, 3> motion() const = 0;

    /// On a single rank its unknowns are all.
    bool is_alone() const
    {
      return owned.is_alone();
    }

    const std::vector<int> &unknowns() const
    {
      return shared.unknowns();
    }

    /// Of the rock, in a state of this rank: its own, then others.
    std::size_t n_held() const
    {
      return 2 * owned.held().size();
    }

    /// Nodes that act on the rock, which all ranks know. @return where a state has them, in their
    /// order
    std::vector<int> hold(const std::vector<int> &nodes);

    /// Sums over the ranks.
    void add_up(double *values, int count) const;

    /// For products in which all unknowns move.
    static const dealii::AffineConstraints<double> &nothing_supported();

  private:
    SharedRock          shared;
    Ownership           owned;
    std::vector<int>    slots_of_watched;
    SharedNodes         watched;
    std::vector<double> collected; ///< work
  };
} // namespace hybrid::continuum
