// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/subscriptor.h>

#include <hybrid/continuum/elastic_joints.h>
#include <hybrid/continuum/elastic_product.h>
#include <hybrid/continuum/restrained_model.h>
#include <hybrid/continuum/shared_nodes.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Stiffness of the restrained bedrock with its elastic planes as deal.II's solvers take a matrix,
   * shared out among the ranks as SharedRock; no rank holds it. All integrals are by Gauss
   * quadrature as in assemble_elastic(). Supported unknowns have a row with 1 on the diagonal.
   */
  class RestrainedStiffness : public dealii::Subscriptor
  {
  public:
    using Vector = ElasticProduct::Vector;

    /// @param model its cells have to outlive this object.
    explicit RestrainedStiffness(const RestrainedModel &model);

    Vector make_vector() const
    {
      return cells.make_vector();
    }

    /// f = K u [N/m].
    void vmult(Vector &f, const Vector &u) const;

    /// [N/m per m]
    Vector diagonal() const;

    /// Set supported unknowns to zero.
    void support(Vector &x) const;

    /// Number of all unknowns.
    dealii::types::global_dof_index m() const;

    /// deal.II asks for an entry where no diagonal is given: never.
    double el(unsigned int row, unsigned int column) const;

  private:
    const SharedRock                 &shared_rock;
    dealii::AffineConstraints<double> constraints;
    ElasticProduct                    cells;
    ElasticJoints                     planes;
    mutable SharedNodes               places;
    std::vector<unsigned int>         held;               ///< unknowns of this rank, in its order
    std::vector<char>                 held_places;        ///< per unknown of the places
    mutable std::vector<double>       shared_u, shared_f; ///< on the places
  };
} // namespace hybrid::continuum
