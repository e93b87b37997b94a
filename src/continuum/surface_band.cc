// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/surface_band.h>
#include <hybrid/scene/lapack_band.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace hybrid::continuum
{
  namespace
  {
    /// What S and its band may differ by in a product with signs, over the diagonal.
    constexpr double largest_error = 1e-11;

    /// How far the entries of a few columns reach: those beyond are round-off together.
    int reach_of_samples(const SurfaceProduct  &product,
                         const Eigen::VectorXd &scale,
                         const double           noise)
    {
      const int        n = static_cast<int>(scale.size()), count = std::min(n, columns_of_product);
      std::vector<int> sample;
      for (int k = 0; k < count; ++k) // in x and y by turns
        sample.push_back(std::min(n - 1, static_cast<int>((k + 0.5) * n / count) / 2 * 2 + k % 2));
      Eigen::MatrixXd x = Eigen::MatrixXd::Zero(n, count);
      for (int k = 0; k < count; ++k)
        x(sample[k], k) = 1.;
      const Eigen::MatrixXd y     = product(x);
      int                   reach = 0;
      for (int k = 0; k < count; ++k)
        for (int i = 0; i < n; ++i)
          if (std::abs(y(i, k)) > noise * std::sqrt(scale[i] * scale[sample[k]]))
            reach = std::max(reach, std::abs(i - sample[k]));
      return reach;
    }



    /// Entries at most @p reach from the diagonal, if there are none beyond.
    Eigen::MatrixXd
    entries_within(const int reach, const SurfaceProduct &product, const Eigen::Index n)
    {
      const Eigen::Index period = std::min<Eigen::Index>(n, 2 * reach + 1);
      Eigen::MatrixXd    band   = Eigen::MatrixXd::Zero(reach + 1, n);
      for (Eigen::Index first = 0; first < period; first += columns_of_product)
        {
          const Eigen::Index count = std::min<Eigen::Index>(columns_of_product, period - first);
          Eigen::MatrixXd    x     = Eigen::MatrixXd::Zero(n, count);
          for (Eigen::Index k = 0; k < count; ++k)
            for (Eigen::Index j = first + k; j < n; j += period)
              x(j, k) = 1.;
          const Eigen::MatrixXd y = product(x);
          for (Eigen::Index k = 0; k < count; ++k)
            for (Eigen::Index j = first + k; j < n; j += period)
              for (Eigen::Index r = 0; r <= reach; ++r) // half of each, above and below
                {
                  if (j + r < n)
                    band(r, j) += 0.5 * y(j + r, k);
                  if (j - r >= 0)
                    band(r, j - r) += 0.5 * y(j - r, k);
                }
        }
      return band;
    }



    /// Whether S and the band do the same to a vector of signs.
    bool
    agrees(const Eigen::MatrixXd &band, const SurfaceProduct &product, const Eigen::VectorXd &scale)
    {
      const Eigen::Index n = band.cols();
      std::mt19937       generator(1);
      Eigen::MatrixXd    x(n, 1);
      for (Eigen::Index i = 0; i < n; ++i)
        x(i, 0) = generator() % 2 == 0 ? 1. : -1.;
      Eigen::VectorXd left = product(x).col(0);
      for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index r = 0; r < band.rows() && j + r < n; ++r)
          {
            left[j + r] -= band(r, j) * x(j, 0);
            if (r > 0)
              left[j] -= band(r, j) * x(j + r, 0);
          }
      return (left.cwiseAbs().array() <= largest_error * scale.array()).all();
    }
  } // namespace



  Eigen::MatrixXd
  surface_band(const SurfaceProduct &product, const Eigen::VectorXd &scale, const double noise)
  {
    const int n = static_cast<int>(scale.size());
    int       reach =
      reach_of_samples(product, scale, std::max(noise, std::numeric_limits<double>::epsilon() / n));
    for (reach += reach / 4 + 2;; reach *= 2)
      {
        reach                = std::min(reach, n - 1);
        Eigen::MatrixXd band = entries_within(reach, product, n);
        if (reach == n - 1 || agrees(band, product, scale))
          return band;
      }
  }



  void factorise_band(Eigen::MatrixXd &band)
  {
    const int n = static_cast<int>(band.cols()), leading = static_cast<int>(band.rows());
    const int reach = leading - 1;
    int       info  = 0;
    dpbtrf_("L", &n, &reach, band.data(), &leading, &info);
    if (info != 0)
      throw std::runtime_error("LAPACK: the dynamic stiffness of the surface is not positive "
                               "definite");
  }



  void solve_band(const Eigen::MatrixXd &factor, double *b)
  {
    const int n = static_cast<int>(factor.cols()), leading = static_cast<int>(factor.rows());
    const int reach = leading - 1, one = 1;
    int       info = 0;
    dpbtrs_("L", &n, &reach, &one, factor.data(), &leading, b, &n, &info);
  }
} // namespace hybrid::continuum
