// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/base/quadrature_lib.h>

#include <hybrid/continuum/lagrange_line.h>

namespace hybrid::continuum
{
  LagrangeLine::LagrangeLine(const int degree)
  {
    const dealii::QGaussLobatto<1> lobatto(degree + 1);
    for (const auto &point : lobatto.get_points())
      points.push_back(point[0]);

    const int n = degree + 1;
    m = k = b = Eigen::MatrixXd::Zero(n, n);
    const dealii::QGauss<1> rule(n);
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double x = rule.point(q)[0], w = rule.weight(q);
        gauss.points.push_back(x);
        gauss.weights.push_back(w);
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            {
              m(i, j) += w * value(i, x) * value(j, x);
              k(i, j) += w * derivative(i, x) * derivative(j, x);
              b(i, j) += w * value(i, x) * derivative(j, x);
            }
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


  double LagrangeLine::value(const int i, const double x) const
  {
    double product = 1.;
    for (int j = 0; j <= degree(); ++j)
      if (j != i)
        product *= (x - points[j]) / (points[i] - points[j]);
    return product;
  }


  double LagrangeLine::derivative(const int i, const double x) const
  {
    double sum = 0.;
    for (int l = 0; l <= degree(); ++l)
      {
        if (l == i)
          continue;
        double product = 1. / (points[i] - points[l]);
        for (int j = 0; j <= degree(); ++j)
          if (j != i && j != l)
            product *= (x - points[j]) / (points[i] - points[j]);
        sum += product;
      }
    return sum;
  }
} // namespace hybrid::continuum
