// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/cell_corrections.h>

#include <utility>

namespace hybrid::continuum
{
  int CellCorrections::find(const Key &key) const
  {
    const auto found = numbers.find(key);
    return found == numbers.end() ? -1 : found->second;
  }



  int CellCorrections::add(const Key &key, Eigen::MatrixXd matrix)
  {
    const int number = static_cast<int>(matrices.size());
    matrices.push_back(std::move(matrix));
    numbers.insert({key, number});
    return number;
  }



  void CellCorrections::add_product(const unsigned int batch,
                                    const double       factor,
                                    const Lanes       *x,
                                    Lanes             *y) const
  {
    constexpr int n_lanes = Lanes::size();
    using Values          = Eigen::Matrix<double, n_lanes, Eigen::Dynamic>; // a column per unknown
    const auto                    &number = of_batch[batch];
    const Eigen::Index             n      = matrices[number[0]].rows();
    const Eigen::Map<const Values> from(&x[0][0], n_lanes, n);
    Eigen::Map<Values>             to(&y[0][0], n_lanes, n);
    bool                           is_one = true;
    for (const int other : number)
      is_one = is_one && other == number[0];
    if (is_one)
      {
        to.noalias() += factor * (from * matrices[number[0]]);
        return;
      }
    for (int lane = 0; lane < n_lanes; ++lane)
      to.row(lane).noalias() += factor * (from.row(lane) * matrices[number[lane]]);
  }



  double CellCorrections::memory() const
  {
    double numbers_held = 0.;
    for (const Eigen::MatrixXd &matrix : matrices)
      numbers_held += static_cast<double>(matrix.size());
    return sizeof(double) * numbers_held;
  }
} // namespace hybrid::continuum
