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



    /// The next number that 2, 3 and 5 divide to 1, and 2 at least once: transforms are quick.
    std::size_t quick_length(const std::size_t least)
    {
      for (std::size_t length = least + least % 2;; length += 2)
        {
          std::size_t left = length;
          for (const std::size_t factor : {2, 3, 5})
            while (left % factor == 0)
              left /= factor;
          if (left == 1)
            return length;
        }
    }



    /// Transforms of one length, of real values that zeros follow.
    class Transform
    {
    public:
      explicit Transform(const std::size_t least)
        : length(quick_length(least))
      {
        fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
      }

      void forward(const Values &x, MotionAnswer::Spectrum &result)
      {
        padded = x;
        padded.resize(length, 0.);
        fft.fwd(result, padded);
      }

      /// The first values, so many.
      void backward(const MotionAnswer::Spectrum &spectrum, const std::size_t size, Values &result)
      {
        fft.inv(padded, spectrum, length);
        result.assign(padded.begin(), padded.begin() + size);
      }

    private:
      std::size_t        length;
      Eigen::FFT<double> fft; // keeps its plan
      Values             padded;
    };



    /**
     * A^T A of the convolution A with a source within a record, for so many lags.
     *
     * Continued beyond the record, to where the source has ended, the convolution has a Toeplitz
     * matrix, of the source's autocorrelation. What the continuation added is taken off again: B^T
     * B, of the convolution with the source's last values. Both are as long as the lags, whatever
     * the record.
     */
    class NormalMatrix
    {
    public:
      /// @param autocorrelation of the source, by lags
      NormalMatrix(const Values &source, const Values &autocorrelation, const std::size_t n_lags)
        : lags(n_lags)
        , transform(2 * n_lags)
      {
        Values even(autocorrelation.begin(), autocorrelation.begin() + lags), last(lags, 0.);
        even[0] *= 0.5; // with its mirror image twice
        transform.forward(even, toeplitz);
        for (std::complex<double> &value : toeplitz)
          value = 2. * value.real();
        for (std::size_t k = 1; k < lags; ++k)
          last[k] = source[source.size() - k];
        transform.forward(last, beyond);
      }

      Values operator*(const Values &x)
      {
        transform.forward(x, of_x);
        product.resize(of_x.size());
        for (std::size_t k = 0; k < of_x.size(); ++k)
          product[k] = std::conj(beyond[k]) * of_x[k];
        transform.backward(product, lags, result);
        transform.forward(result, product);
        for (std::size_t k = 0; k < of_x.size(); ++k)
          product[k] = toeplitz[k] * of_x[k] - beyond[k] * product[k];
        transform.backward(product, lags, result);
        return result;
      }

    private:
      std::size_t            lags;
      Transform              transform;
      MotionAnswer::Spectrum toeplitz, beyond, of_x, product;
      Values                 result;
    };



    /// h of so many lags. @param gradient A^T U, as many
    Values best_pulse(NormalMatrix &matrix, Values gradient, const double weight)
    {
      Values       pulse(gradient.size(), 0.), direction = gradient;
      double       size   = product(gradient, gradient);
      const double enough = settled * settled * size;
      for (int i = 0; i < most_iterations && size > enough; ++i)
        {
          Values normal = matrix * direction;
          add(normal, weight, direction);
          const double step = size / product(direction, normal);
          add(pulse, step, direction);
          add(gradient, -step, normal);
          const double last = size;
          size              = product(gradient, gradient);
          for (std::size_t k = 0; k < direction.size(); ++k)
            direction[k] = gradient[k] + size / last * direction[k];
        }
      return pulse;
    }
  } // namespace



  MotionAnswer::MotionAnswer(const std::vector<double> &given_source)
    : source(given_source)
  {
    Transform transform(2 * source.size());
    transform.forward(source, spectrum);
    Spectrum power;
    for (const std::complex<double> &f : spectrum)
      {
        power.push_back(std::norm(f));
        weight = std::max(weight, water_level * std::norm(f));
      }
    transform.backward(power, source.size(), autocorrelation);
  }



  MotionAnswer::Answer MotionAnswer::find(const std::vector<double> &velocity) const
  {
    assert(velocity.size() == source.size());
    const std::size_t rows  = source.size();
    const double      whole = product(velocity, velocity);
    Answer            result{Values(rows, 0.), velocity};
    if (!(whole > 0.) || !(weight > 0.))
      return result;
    Transform transform(2 * rows);
    Spectrum  spectrum_of;
    Values    gradient, answer;
    transform.forward(velocity, spectrum_of);
    for (std::size_t k = 0; k < spectrum.size(); ++k)
      spectrum_of[k] *= std::conj(spectrum[k]);
    transform.backward(spectrum_of, rows, gradient);
    for (const std::size_t part : parts_of_record)
      {
        const std::size_t lags = std::max<std::size_t>(1, rows / part);
        NormalMatrix      matrix(source, autocorrelation, lags);
        result.pulse =
          best_pulse(matrix, Values(gradient.begin(), gradient.begin() + lags), weight);
        transform.forward(result.pulse, spectrum_of);
        for (std::size_t k = 0; k < spectrum.size(); ++k)
          spectrum_of[k] *= spectrum[k];
        transform.backward(spectrum_of, rows, answer);
        result.rest = velocity;
        add(result.rest, -1., answer);
        if (product(result.rest, result.rest) < most_left * most_left * whole)
          break;
      }
    result.pulse.resize(rows, 0.);
    return result;
  }
} // namespace hybrid::output
