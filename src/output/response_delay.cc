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
    constexpr double      water_level   = 1e-4; ///< of the source's largest power [-]
    constexpr double      given_back    = 2.;   ///< at most, of what the window takes [-]
    constexpr double      tapered_end   = 0.05; ///< of a record, in it or beyond it [-]
    constexpr std::size_t least_taper   = 8;    ///< [rows]
    constexpr double      least_window  = 0.25; ///< of the record [-]
    constexpr double      duration_tail = 0.05; ///< of the energy at both ends of the duration [-]
    constexpr double      shared_lags   = 0.1;  ///< of L, to both sides: one mean square of h [-]



    /// From 5 to 95 % of the sum of squares [rows].
    std::size_t strong_rows(const std::vector<double> &x)
    {
      double total = 0., sum = 0.;
      for (const double value : x)
        total += value * value;
      std::size_t first = 0, last = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          sum += x[i] * x[i];
          if (sum < duration_tail * total)
            first = i + 1;
          if (sum < (1. - duration_tail) * total)
            last = i + 1;
        }
      return last - first;
    }



    /// To nothing at the end of a record.
    void fade_out(std::vector<double> &x, const std::size_t rows)
    {
      const std::size_t taper = std::max<std::size_t>(1, tapered_end * rows);
      for (std::size_t i = 0; i < std::min(taper, rows); ++i)
        x[rows - 1 - i] *= std::pow(std::sin(0.5 * M_PI * (i + 0.5) / taper), 2);
    }



    /// What goes on beyond the end of a record: it turned about its last row, and to nothing.
    std::size_t rows_beyond(const std::size_t rows)
    {
      return std::min(std::max<std::size_t>(least_taper, tapered_end * rows), rows - 1);
    }



    /// A record and rows_beyond() it: value and slope do not jump at its end.
    std::vector<double> continued(std::vector<double> x)
    {
      assert(!x.empty());
      const std::size_t rows = x.size(), beyond = rows_beyond(rows);
      for (std::size_t i = 1; i <= beyond; ++i)
        x.push_back((2. * x[rows - 1] - x[rows - 1 - i]) *
                    std::pow(std::cos(0.5 * M_PI * i / (beyond + 1.)), 2));
      return x;
    }
  } // namespace



  ResponseDelay::ResponseDelay(const double given_spacing, const std::vector<double> &source)
    : spacing(given_spacing)
    , rows(source.size())
    , length(2)
    , is_set_off(std::all_of(source.begin(), source.end(), [](double f) { return f == 0.; }))
  {
    while (length < 2 * (rows + rows_beyond(rows)))
      length *= 2;
    for (std::size_t k = 0; k <= length / 2; ++k)
      s.emplace_back(0., 2. * M_PI * k / (length * spacing));
    for (std::size_t i = 0; i < length; ++i)
      lag.push_back(i <= length / 2 ? i * spacing : -spacing * (length - i));
    if (is_set_off)
      source_spectrum.assign(s.size(), 1.);
    else
      make_window(source);
  }



  void ResponseDelay::make_window(const std::vector<double> &source)
  {
    const double duration = rows * spacing;
    reach = std::max(duration - strong_rows(source) * spacing, least_window * duration);
    for (const double t : lag)
      window.push_back(std::exp(-2. * t * t / (reach * reach)));
    source_spectrum = forward(continued(source));
    Spectrum power(s.size());
    double   largest = 0., sum = 0., moment = 0.;
    for (std::size_t k = 0; k < s.size(); ++k)
      {
        power[k] = std::norm(source_spectrum[k]);
        largest  = std::max(largest, power[k].real());
        sum += power[k].real();
        moment += power[k].real() * s[k].imag();
      }
    period = 2. * M_PI * sum / moment;
    for (const std::complex<double> &p : windowed(power))
      denominator.push_back(std::max(p.real(), 0.) + water_level * largest);
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



  ResponseDelay::Spectrum ResponseDelay::windowed(const Spectrum &correlation) const
  {
    std::vector<double> lags = backward(correlation);
    for (std::size_t i = 0; i < length; ++i)
      lags[i] *= window[i];
    return forward(lags);
  }



  std::vector<double> ResponseDelay::answer(const std::vector<double> &velocity) const
  {
    std::vector<double> pulse = velocity;
    if (is_set_off)
      {
        fade_out(pulse, rows);
        pulse.resize(length, 0.);
        return pulse;
      }
    Spectrum correlation = forward(continued(velocity));
    for (std::size_t k = 0; k < s.size(); ++k)
      correlation[k] *= std::conj(source_spectrum[k]);
    correlation = windowed(correlation);
    for (std::size_t k = 0; k < s.size(); ++k)
      correlation[k] /= denominator[k];
    pulse = backward(correlation);
    for (std::size_t i = 0; i < length; ++i)
      pulse[i] *= std::min(1. / window[i], given_back);
    return pulse;
  }



  std::vector<double> ResponseDelay::without_noise(const std::vector<double> &pulse) const
  {
    std::vector<double> after{0.}, before{0.}; // sums of squares, from lag 0 to both sides
    for (std::size_t i = 0; i < length / 2; ++i)
      {
        const double late = pulse[i], early = i == 0 ? 0. : pulse[length - i];
        after.push_back(after.back() + late * late);
        before.push_back(before.back() + early * early);
      }
    const auto shared =
      std::max<std::size_t>(1, static_cast<std::size_t>(shared_lags * reach / spacing));
    std::vector<double> result(length, 0.);
    for (std::size_t i = 0; i < length / 2; ++i)
      {
        const std::size_t first = i - std::min(i, shared), last = std::min(i + shared, length / 2);
        const double      noise = before[last] - before[first], all = after[last] - after[first];
        if (all > noise)
          result[i] = (1. - noise / all) * pulse[i];
      }
    return result;
  }



  ResponseDelay::Spectrum ResponseDelay::no_answer(const std::vector<double> &velocity,
                                                   const std::vector<double> &pulse,
                                                   std::vector<double>        clear) const
  {
    for (std::size_t i = 0; i < length; ++i)
      if (std::abs(lag[i]) < period)
        clear[i] = pulse[i];
    Spectrum answered = forward(clear);
    for (std::size_t k = 0; k < s.size(); ++k)
      answered[k] *= source_spectrum[k];
    std::vector<double> rest = backward(answered);
    rest.resize(rows);
    for (std::size_t i = 0; i < rows; ++i)
      rest[i] = velocity[i] - rest[i];
    fade_out(rest, rows);
    return forward(rest);
  }



  ResponseDelay::Spectrum ResponseDelay::delay(const std::vector<double> &velocity) const
  {
    assert(velocity.size() == rows);
    std::vector<double> pulse = answer(velocity);
    Spectrum            rest(s.size(), 0.);
    if (!is_set_off)
      {
        std::vector<double> clear = without_noise(pulse);
        rest                      = no_answer(velocity, pulse, clear);
        pulse.swap(clear);
      }
    for (std::size_t i = 0; i < length; ++i)
      pulse[i] *= -lag[i];
    Spectrum result = forward(pulse);
    for (std::size_t k = 0; k < s.size(); ++k)
      result[k] = result[k] * source_spectrum[k] + (k > 0 ? rest[k] / s[k] : 0.);
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
        const std::size_t cut = std::min<std::size_t>(rows, std::max(10., tapered_end * rows));
        std::fill(result.end() - cut, result.end(), 0.);
        std::fill(result.begin(), result.begin() + std::min<std::size_t>(rows, 10), 0.);
      }
    return result;
  }
} // namespace hybrid::output
