// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/motion_answer.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace hybrid::output
{
  namespace
  {
    using Values = std::vector<double>;

    constexpr double      water_level     = 1e-4; ///< of the source's largest power [-]
    constexpr double      most_left       = 0.05; ///< of a motion's size, by lags that will do [-]
    constexpr double      settled         = 1e-3; ///< gradient over the first one [-]
    constexpr int         most_iterations = 200;
    constexpr std::size_t parts_of_record[] = {64, 16, 4, 1}; ///< lags are as long as one of them



    double product(const Values &x, const Values &y)
    {
      return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
    }



    void add(Values &x, const double factor, const Values &y)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += factor * y[i];
    }



    /// Convolution with a source within a record, and its transpose.
    class Source
    {
    public:
      Source(const MotionAnswer::Spectrum &given_spectrum,
             const std::size_t             record_rows,
             const std::size_t             transform_length)
        : spectrum(given_spectrum)
        , rows(record_rows)
        , length(transform_length)
      {
        transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
      }

      /// h * F, one per row.
      Values answer(const Values &pulse)
      {
        return multiplied(pulse, rows, [](const auto &f) { return f; });
      }

      /// Of so many lags.
      Values transposed(const Values &motion, const std::size_t lags)
      {
        return multiplied(motion, lags, [](const auto &f) { return std::conj(f); });
      }

    private:
      const MotionAnswer::Spectrum &spectrum;
      std::size_t                   rows, length;
      Eigen::FFT<double>            transform; // keeps its plan
      MotionAnswer::Spectrum        product;
      Values                        padded;

      template <typename Factor>
      Values multiplied(const Values &x, const std::size_t size, const Factor &factor)
      {
        padded = x;
        padded.resize(length, 0.);
        transform.fwd(product, padded);
        for (std::size_t k = 0; k < product.size(); ++k)
          product[k] *= factor(spectrum[k]);
        transform.inv(padded, product, length);
        return Values(padded.begin(), padded.begin() + size);
      }
    };



    /// h of so many lags.
    Values
    best_pulse(Source &source, const Values &motion, const std::size_t lags, const double weight)
    {
      Values       pulse(lags, 0.), gradient = source.transposed(motion, lags);
      Values       direction = gradient;
      double       size      = product(gradient, gradient);
      const double enough    = settled * settled * size;
      for (int i = 0; i < most_iterations && size > enough; ++i)
        {
          const Values answer = source.answer(direction);
          Values       normal = source.transposed(answer, lags);
          add(normal, weight, direction);
          const double step = size / product(direction, normal);
          add(pulse, step, direction);
          add(gradient, -step, normal);
          const double last = size;
          size              = product(gradient, gradient);
          for (std::size_t k = 0; k < lags; ++k)
            direction[k] = gradient[k] + size / last * direction[k];
        }
      return pulse;
    }
  } // namespace



  MotionAnswer::MotionAnswer(const std::vector<double> &source, const std::size_t transform_length)
    : rows(source.size())
    , length(transform_length)
  {
    assert(length >= 2 * rows);
    Values padded = source;
    padded.resize(length, 0.);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    transform.fwd(source_spectrum, padded);
    for (const std::complex<double> &f : source_spectrum)
      weight = std::max(weight, water_level * std::norm(f));
  }



  MotionAnswer::Answer MotionAnswer::find(const std::vector<double> &velocity) const
  {
    assert(velocity.size() == rows);
    Source       source(source_spectrum, rows, length);
    const double whole = product(velocity, velocity);
    Answer       result{Values(rows, 0.), velocity};
    if (!(whole > 0.) || !(weight > 0.))
      return result;
    for (const std::size_t part : parts_of_record)
      {
        result.pulse = best_pulse(source, velocity, std::max<std::size_t>(1, rows / part), weight);
        result.rest  = velocity;
        add(result.rest, -1., source.answer(result.pulse));
        if (product(result.rest, result.rest) < most_left * most_left * whole)
          break;
      }
    result.pulse.resize(rows, 0.);
    return result;
  }
} // namespace hybrid::output
