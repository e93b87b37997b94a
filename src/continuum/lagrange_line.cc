// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/lagrange_line.h>

namespace hybrid::continuum
{
  LagrangeLine::LagrangeLine(const int degree, const MassQuadrature of_mass)
    : gauss(degree + 1)
  {
    const int                      n = degree + 1;
    const dealii::QGaussLobatto<1> lobatto(n);
    basis = dealii::Polynomials::generate_complete_Lagrange_basis(lobatto.get_points());
    for (const auto &point : lobatto.get_points())
      points.push_back(point[0]);

    m = k = b = Eigen::MatrixXd::Zero(n, n);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        const double x = gauss.point(q)[0], w = gauss.weight(q);
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            {
              m(i, j) += w * value(i, x) * value(j, x);
              k(i, j) += w * derivative(i, x) * derivative(j, x);
              b(i, j) += w * value(i, x) * derivative(j, x);
            }
      }
    if (of_mass == MassQuadrature::lobatto)
      {
        m.setZero();
        for (int i = 0; i < n; ++i)
          m(i, i) = lobatto.weight(i);
      }
  }


  std::vector<double> LagrangeLine::load_shares() const
  {
    std::vector<double> shares;
    double              borne = 0.; // by node i, of what lies before it
    for (int i = 0; i < degree(); ++i)
      {
        const double length = points[i + 1] - points[i];
        const double after  = m.row(i).sum() - borne;
        shares.push_back(after / length);
        borne = length - after;
      }
    return shares;
  }
} // namespace hybrid::continuum
