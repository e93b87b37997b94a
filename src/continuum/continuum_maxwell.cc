// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/continuum_implementation.h>

namespace hybrid::continuum
{
  MaxwellBody Continuum::Implementation::make_maxwell(const scene::MaxwellParameters &parameters)
  {
    const MaxwellBody body = parameters.bedrock_ratio > 0.
                               ? maxwell_body(parameters.bedrock_ratio,
                                              {parameters.lowest, parameters.highest},
                                              parameters.branches)
                               : MaxwellBody();
    maxwell                = MaxwellMemory(body, n_dofs(), boundary->n_column_unknowns());
    return body;
  }


  void Continuum::Implementation::prepare_maxwell(const scene::MaxwellParameters &parameters)
  {
    if (!(parameters.bedrock_ratio > 0.))
      return;
    make_maxwell(parameters);
    maxwell1 = maxwell.at_rest();
    column_stressed.assign(boundary->n_column_unknowns(), 0.);
  }


  void Continuum::Implementation::take_maxwell(const ContinuumState &state, const double dt)
  {
    for (std::size_t i = 0; i < n_dofs(); ++i)
      du[i] = u1[i] - state.displacement[i];
    matrices.multiply_stiffness(u1.data(), product.data());
    if (slip != nullptr) // joints that may slip have no such damping
      add_joint_force(-1., u1.data(), product);
    maxwell.advance(state.maxwell, dt, product, du, maxwell1);
  }


  Vec2 Continuum::Implementation::base_maxwell(const MaxwellState &state) const
  {
    Vec2 sum(0., 0.);
    for (const int node : boundary->moving_nodes())
      sum += Vec2(maxwell.excess_force(state, 2 * node), maxwell.excess_force(state, 2 * node + 1));
    return sum;
  }


  const double *Continuum::Implementation::columns_stressed(const MaxwellState &state,
                                                            const double       *u)
  {
    if (!maxwell.is_on())
      return nullptr;
    maxwell.stressed(state, u, n_dofs(), column_stressed);
    return column_stressed.data();
  }
} // namespace hybrid::continuum
