// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>
#include <hybrid/scene/maxwell_body.h>

#include <vector>

namespace hybrid::continuum
{
  /// What the branches of a MaxwellBody remember; all empty without one, the forces of explicit
  /// steps too.
  struct MaxwellState
  {
    std::vector<double> strain;  ///< displacement s_l that strains the spring of branch l [m], all
                                 ///< unknowns, free-field columns last; branch after branch
    std::vector<double> force;   ///< K s_l of the model's unknowns [N/m]; branch after branch
    std::vector<double> elastic; ///< K u of the model's unknowns [N/m]
  };

  void serialize(restart::Archive &archive, MaxwellState &state);


  /**
   * Maxwell damping of the finite elements. One body serves all materials, so the branches need no
   * stress at the points of integration: their memory is a displacement of the nodes,
   *
   *     f = K u + K [(relaxed - 1) u + sum_l weight_l s_l],   s_l' = u' - s_l / t_l.
   *
   * K s_l follows s_l by the same rule, linear in K u, so a step takes one product with K. The part
   * in brackets is called the excess.
   */
  class MaxwellMemory
  {
  public:
    MaxwellMemory() = default;

    /// @param model, columns numbers of unknowns
    MaxwellMemory(MaxwellBody maxwell, std::size_t model, std::size_t columns);

    bool is_on() const
    {
      return body.n_branches() > 0;
    }

    /// Nothing is strained.
    MaxwellState at_rest() const;

    /// The same for steps without a matrix, which keep no forces. @param unknowns of a state
    MaxwellState strains_at_rest(std::size_t unknowns) const;

    /// Of the excess's force, per K u at the end of a step [-].
    double step_modulus(const double dt) const
    {
      return body.step_modulus(dt);
    }

    /// Less the excess's force at the end of a step in which u goes to zero: what stands on the
    /// right-hand side [N/m].
    void add_past(const MaxwellState &state, double dt, std::vector<double> &load) const;

    /// The model's unknowns at the end of a step. @param elastic K u1 [N/m]
    /// @param change u1 - u0 [m] @param next takes them
    void advance(const MaxwellState        &state,
                 double                     dt,
                 const std::vector<double> &elastic,
                 const std::vector<double> &change,
                 MaxwellState              &next) const;

    /// What the dashpots take over a step [J/m].
    double loss(const MaxwellState &state, const MaxwellState &next, double dt) const;

    /// Energy of the springs beyond u K u / 2 [J/m]. @param u of the model's unknowns [m]
    double stored_energy(const MaxwellState &state, const double *u) const;

    /// Force of the excess on one of the model's unknowns [N/m].
    double excess_force(const MaxwellState &state, std::size_t unknown) const;

    /// u with the excess, for stresses [m], of a state's unknowns from @p first on. @pre is_on()
    /// @param u of these unknowns
    void stressed(const MaxwellState  &state,
                  const double        *u,
                  std::size_t          first,
                  std::vector<double> &result) const;

  private:
    MaxwellBody body;
    std::size_t n   = 0; ///< unknowns of the model
    std::size_t all = 0; ///< with those of the columns
  };
} // namespace hybrid::continuum
