// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/maxwell_body.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace hybrid
{
  namespace
  {
    constexpr int n_samples  = 101; ///< of the band, on a logarithmic scale
    constexpr int n_spacings = 150; ///< of relaxation times, by a hundredth of a decade

    /// Circular frequencies over the band [rad/s].
    std::vector<double> samples_of(const FrequencyBand &band)
    {
      std::vector<double> omega;
      for (int k = 0; k < n_samples; ++k)
        omega.push_back(2. * M_PI * band.lowest *
                        std::pow(band.highest / band.lowest, k / (n_samples - 1.)));
      return omega;
    }



    double middle_of(const FrequencyBand &band)
    {
      return 2. * M_PI * std::sqrt(band.lowest * band.highest);
    }



    /// Weights of least squares for Im m = 2 ratio Re m with relaxed = 1:
    /// sum_l weight_l (x - 2 ratio x^2) / (1 + x^2) = 2 ratio, x = w t_l, over 2 ratio. A branch
    /// whose weight would be negative is left out.
    void fit_weights(MaxwellBody &body, const double ratio, const std::vector<double> &omega)
    {
      const double    loss = 2. * ratio;
      const auto      n    = static_cast<Eigen::Index>(omega.size());
      Eigen::MatrixXd by_weight(n, static_cast<Eigen::Index>(body.n_branches()));
      for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index l = 0; l < by_weight.cols(); ++l)
          {
            const double x  = omega[k] * body.time[l];
            by_weight(k, l) = (x - loss * x * x) / (1. + x * x) / loss;
          }
      std::vector<Eigen::Index> used(body.n_branches());
      for (std::size_t l = 0; l < used.size(); ++l)
        used[l] = static_cast<Eigen::Index>(l);
      body.weight.assign(body.n_branches(), 0.);
      while (!used.empty())
        {
          Eigen::MatrixXd columns(n, static_cast<Eigen::Index>(used.size()));
          for (std::size_t l = 0; l < used.size(); ++l)
            columns.col(static_cast<Eigen::Index>(l)) = by_weight.col(used[l]);
          const Eigen::VectorXd found =
            columns.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(n));
          Eigen::Index lowest = 0;
          if (found.minCoeff(&lowest) < 0.)
            {
              used.erase(used.begin() + lowest);
              continue;
            }
          for (std::size_t l = 0; l < used.size(); ++l)
            body.weight[used[l]] = found[static_cast<Eigen::Index>(l)];
          break;
        }
    }



    /// All moduli by one factor, so that a plane wave of @p omega has the phase velocity
    /// 1/Re(1/sqrt(m)) = 1 (Moczo and Kristek 2005, eq. 21).
    void normalise(MaxwellBody &body, const double omega)
    {
      const double slowness = (1. / std::sqrt(body.modulus(omega))).real();
      body.relaxed *= slowness * slowness;
      for (double &weight : body.weight)
        weight *= slowness * slowness;
    }
  } // namespace



  double MaxwellBody::step_modulus(const double dt) const
  {
    double sum = relaxed - 1.;
    for (std::size_t l = 0; l < n_branches(); ++l)
      sum += weight[l] * gained(dt, l);
    return sum;
  }



  std::complex<double> MaxwellBody::modulus(const double omega) const
  {
    std::complex<double> sum(relaxed, 0.);
    for (std::size_t l = 0; l < n_branches(); ++l)
      {
        const std::complex<double> x(0., omega * time[l]);
        sum += weight[l] * x / (1. + x);
      }
    return sum;
  }



  double MaxwellBody::damping_ratio(const double omega) const
  {
    const std::complex<double> m = modulus(omega);
    return 0.5 * m.imag() / m.real();
  }



  double ratio_error(const MaxwellBody &body, const double ratio, const FrequencyBand &band)
  {
    double error = 0.;
    for (const double omega : samples_of(band))
      error = std::max(error, std::abs(body.damping_ratio(omega) / ratio - 1.));
    return error;
  }



  MaxwellBody maxwell_body(const double ratio, const FrequencyBand &band, const int branches)
  {
    MaxwellBody best;
    if (!(ratio > 0.))
      return best;
    const std::vector<double> omega = samples_of(band);
    double                    least = 1e300;
    for (int spacing = 1; spacing <= (branches > 1 ? n_spacings : 1); ++spacing)
      {
        MaxwellBody body;
        for (int l = 0; l < branches; ++l)
          body.time.push_back(std::pow(10., -0.01 * spacing * (l - 0.5 * (branches - 1))) /
                              middle_of(band));
        fit_weights(body, ratio, omega);
        if (const double error = ratio_error(body, ratio, band); error < least)
          {
            least = error;
            best  = std::move(body);
          }
      }
    normalise(best, middle_of(band));
    return best;
  }
} // namespace hybrid
