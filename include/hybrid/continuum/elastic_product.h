// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/quadrature.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <deal.II/matrix_free/matrix_free.h>

#include <hybrid/scene/material.h>

#include <utility>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Products with the stiffness of the rock as sums over the cells of this rank: no matrix
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
                   const std::vector<Material>             &material,
                   const dealii::AffineConstraints<double> &supported,
                   const dealii::Quadrature<1>             &points);

    /// Zero, with room for what the neighbours own.
    Vector make_vector() const;

    /// f = factor K u [N/m].
    void multiply(double factor, const Vector &u, Vector &f) const;

    /// Diagonal of K [N/m per m]; 1 of supported unknowns.
    Vector diagonal() const;

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

    void take_materials(const std::vector<Material> &material);
    void add_masses(const MatrixFree &, Vector &mass, const Vector &, const Range &) const;

    MatrixFree                        loop;
    dealii::AlignedVector<CellModuli> moduli; ///< per batch of cells
  };
} // namespace hybrid::continuum
