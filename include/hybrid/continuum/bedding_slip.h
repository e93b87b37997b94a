// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/bedding_planes.h>
#include <hybrid/continuum/slip_solver.h>

#include <functional>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Mohr-Coulomb slip on bedding planes within one step. The elastic joints stay in A; the plastic
   * jump p acts as a load B^T W D p, found by SlipSolver with the compliance of the bedrock as
   * everything above it holds it: exact without blocks (one correction of the step); with blocks
   * the surface force answers the slip, and both are solved in turn until the tractions found with
   * the final surface motion are within the strength.
   */
  class BeddingSlip
  {
  public:
    BeddingSlip(const RockMesh       &rock,
                const ElementNodes   &nodes,
                const JointStiffness &stiffness,
                const PlaneStrength  &strength);

    const BeddingPlanes &planes() const
    {
      return bedding;
    }

    SlipState initial_state() const;

    /// Tractions at rest are a uniform compression [Pa].
    void set_rest(double compression);

    /// Besides, these on the points [Pa].
    void add_rest(const std::vector<double> &tractions_at_rest);

    /// Pore pressure [Pa] in the planes pushes their sides apart: add that to the load [N/m].
    void add_pore_forces(const std::function<double(const Vec2 &)> &pressure,
                         std::vector<double>                       &load) const;

    /// Static stage: begin_rest(), solve_rest() with add_load_change() until settled, keep_rest():
    /// the tractions at rest are then those of the static model after its slip; without
    /// solve_rest() those of the elastic one.
    void       begin_rest();
    SlipStatus solve_rest(const Eigen::MatrixXd &relaxation, const std::vector<double> &u);
    StaticSlip slip_at_rest() const;
    void       keep_rest(const std::vector<double> &u);

    /// The point whose shear traction at rest is farthest beyond its strength.
    const BeddingPlanes::Point &most_loaded_at_rest() const;

    /// Tractions at rest on the points [Pa].
    const std::vector<double> &rest_tractions() const
    {
      return rest;
    }

    /// Points that failed at rest.
    const std::vector<char> &rest_failures() const
    {
      return rest_failed;
    }

    /// What keep_rest() kept, for the checkpoint.
    void serialize_rest(restart::Archive &archive);

    /// Begin a step.
    void begin(const SlipState &state);

    /// Tractions [Pa] of the displacement u with the plastic jump p, those at rest included.
    void tractions(const std::vector<double> &u,
                   const std::vector<double> &p,
                   std::vector<double>       &t) const;

    /// Bring the slip up to date with the displacement @p u that was found with the present one.
    SlipStatus
    solve(const Eigen::MatrixXd &relaxation, const SlipState &state, const std::vector<double> &u);

    /// Plastic jump of the step so far.
    const std::vector<double> &jump() const
    {
      return now;
    }

    /// f += factor B^T W D p.
    void add_load(const std::vector<double> &p, double factor, std::vector<double> &force);

    /// f += factor B^T W D B x.
    void add_elastic_force(const std::vector<double> &x, double factor, std::vector<double> &force);

    /// What solve() changed last: f += B^T W D (p - p before).
    void add_load_change(std::vector<double> &force);

    /// What the planes take in an accepted step [J/m].
    struct Energy
    {
      double loss        = 0.; ///< slip and breaking
      double integration = 0.; ///< the scheme's own
    };

    /// Write the step into the state. @param u0, u1 displacements at its ends [m].
    Energy finish(SlipState &state, const std::vector<double> &u0, const std::vector<double> &u1);

    /// 1/2 (p D W p) - (B u) D W p: what the strain energy 1/2 u K u has too much [J/m].
    double strain_correction(const SlipState &state, const std::vector<double> &u) const;

    /// -p W (tractions at rest): static stress that slip has released counts as negative [J/m].
    double static_energy(const SlipState &state) const;

  private:
    BeddingPlanes       bedding;
    SlipSolver          solver;
    std::vector<double> rest;               ///< tractions at rest [Pa]
    std::vector<double> now, before, t, t1; ///< plastic jump and work, on the points
    std::vector<char>   failed, rest_failed;
    SlipState           rest_state; ///< start of the static stage
    Eigen::VectorXd     start;      ///< tractions with the plastic jump of the step's start [Pa]
    Eigen::VectorXd     change;     ///< of the tractions [Pa]
  };
} // namespace hybrid::continuum
