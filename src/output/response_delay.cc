// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/response_delay.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::output
{
  namespace
  {
    constexpr double tapered_end = 0.05; ///< of a record [-]
    constexpr double least_cut   = 10.;  ///< at the ends of what is set off at t = 0 [rows]
    constexpr double end_part    = 0.1;  ///< of a record: where a last wave is looked for [-]



    /// To nothing over the last so many rows.
    void fade_out(std::vector<double> &x, const std::size_t over)
    {
      for (std::size_t i = 0; i < std::min(over, x.size()); ++i)
        x[x.size() - 1 - i] *= std::pow(std::sin(0.5 * M_PI * (i + 0.5) / over), 2);
    }



    std::size_t taper(const std::size_t rows)
    {
      return std::max<std::size_t>(1, tapered_end * rows);
    }



    double largest_at_end(const std::vector<double> &x)
    {
      double result = 0.;
      for (std::size_t i = x.size() - static_cast<std::size_t>(end_part * x.size()); i < x.size();
           ++i)
        result = std::max(result, std::abs(x[i]));
      return result;
    }



    /// Rows of a record whose @p source is known for twice as many.
    std::vector<double> within_record(const std::vector<double> &source)
    {
      return std::vector<double>(source.begin(), source.begin() + source.size() / 2);
    }



    /// A record, what follows it and room for what wraps around, a power of two.
    std::size_t transform_length(const std::size_t rows)
    {
      std::size_t result = 2;
      while (result < 3 * rows)
        result *= 2;
      return result;
    }
  } // namespace



  ResponseDelay::ResponseDelay(const double given_spacing, const std::vector<double> &source)
    : spacing(given_spacing)
    , rows(source.size() / 2)
    , length(transform_length(rows))
    , is_set_off(
        std::all_of(source.begin(), source.begin() + rows, [](double f) { return f == 0.; }))
    , answer(within_record(source))
  {
    assert(source.size() == 2 * rows);
    for (std::size_t k = 0; k <= length / 2; ++k)
      s.emplace_back(0., 2. * M_PI * k / (length * spacing));
    std::vector<double> faded = source;
    fade_out(faded, rows / 2); // half a record beyond the end
    source_spectrum = is_set_off ? Spectrum(s.size(), 1.) : forward(faded);
  }



  ResponseDelay::Spectrum ResponseDelay::forward(const std::vector<double> &history) const
  {
    std::vector<double> padded = history;
    padded.resize(length, 0.);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    Spectrum result;
    transform.fwd(result, padded);
    return result;
  }



  std::vector<double> ResponseDelay::backward(const Spectrum &spectrum) const
  {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> result;
    transform.inv(result, spectrum, length);
    return result;
  }



  ResponseDelay::Delay ResponseDelay::delay(const std::vector<double> &velocity) const
  {
    assert(velocity.size() == rows);
    Delay               result;
    std::vector<double> pulse = velocity, rest(rows, 0.);
    if (is_set_off)
      fade_out(pulse, taper(rows));
    else
      {
        MotionAnswer::Answer found = answer.find(velocity);
        pulse.swap(found.pulse);
        rest.swap(found.rest);
        result.left_at_end = largest_at_end(rest);
        fade_out(rest, taper(rows));
      }
    for (std::size_t i = 0; i < rows; ++i)
      pulse[i] *= -spacing * i;
    result.spectrum        = forward(pulse);
    const Spectrum of_rest = forward(rest);
    for (std::size_t k = 0; k < s.size(); ++k)
      result.spectrum[k] =
        result.spectrum[k] * source_spectrum[k] + (k > 0 ? of_rest[k] / s[k] : 0.);
    return result;
  }



  std::vector<double> ResponseDelay::change(const Spectrum &delay,
                                            const Spectrum &frequency_change) const
  {
    assert(delay.size() == s.size() && frequency_change.size() == s.size());
    Spectrum product(s.size());
    for (std::size_t k = 0; k < s.size(); ++k)
      product[k] = frequency_change[k] * delay[k];
    std::vector<double> result = backward(product);
    result.resize(rows);
    if (is_set_off) // the ends, where a taper and the first instant are
      {
        const auto cut =
          std::min(rows, static_cast<std::size_t>(std::max(least_cut, tapered_end * rows)));
        std::fill(result.end() - cut, result.end(), 0.);
        std::fill(result.begin(),
                  result.begin() + std::min(rows, static_cast<std::size_t>(least_cut)),
                  0.);
      }
    return result;
  }
} // namespace hybrid::output
