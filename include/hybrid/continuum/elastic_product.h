// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/matrix_free.h>

#include <hybrid/continuum/cell_corrections.h>
#include <hybrid/continuum/cell_materials.h>

#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Products with stiffness and mass of the rock as sums over the cells of this rank: no matrix
   * (Kronbichler and Kormann 2012). Bedding planes and boundaries are not part of it.
   */
  class ElasticProduct
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    /// @param dofs vector-valued, of Lagrange polynomials; must outlive this object.
    /// @param material per cell of the whole mesh
    /// @param supported unknowns that do not move: their rows and columns are left out
    /// @param points of the integrals, along an edge; as many as an edge has nodes
    ElasticProduct(const dealii::DoFHandler<2>             &dofs,
                   const CellMaterials                     &material,
                   const dealii::AffineConstraints<double> &supported,
                   const dealii::Quadrature<1>             &points);

    /// Zero, with room for what the neighbours own.
    Vector make_vector() const;

    /// f = factor K u [N/m].
    void multiply(double factor, const Vector &u, Vector &f) const;

    /// Of a sum of matrices.
    struct Weights
    {
      double stiffness  = 0.; ///< of K
      double mass       = 0.; ///< of M
      double correction = 0.; ///< of what correct_inertia() adds to M
    };

    /// Find what inertia_correction() adds to the mass for this step [s].
    void correct_inertia(double step);

    /// f = (stiffness K + mass M + correction N) u.
    void multiply(const Weights &weights, const Vector &u, Vector &f) const;

    /// Diagonal of such a sum; 1 of supported unknowns.
    Vector diagonal(const Weights &weights) const;

    double memory() const; ///< of this rank [B]

    /// int rho N_i dA [kg/m]: the mass matrix where the points are the nodes.
    Vector masses() const;

  private:
    using MatrixFree = dealii::MatrixFree<2, double>;
    using Lanes      = dealii::VectorizedArray<double>;
    using Range      = std::pair<unsigned int, unsigned int>;

    struct CellModuli
    {
      Lanes lambda, shear, density; ///< [Pa], [Pa], [kg/m3]
    };

    /// From values of a batch's unknowns to those of their product.
    template <typename Evaluation>
    void apply(const Weights &weights, Evaluation &cell) const;

    /// Shape and material of a cell: the same numbers for the same matrices.
    CellCorrections::Key key(unsigned int batch, unsigned int lane) const;

    void take_materials(const CellMaterials &material);
    void add_masses(const MatrixFree &, Vector &mass, const Vector &, const Range &) const;

    MatrixFree                        loop;
    dealii::AlignedVector<CellModuli> moduli; ///< per batch of cells
    CellCorrections                   corrections;
  };
} // namespace hybrid::continuum
