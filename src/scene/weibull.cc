// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/weibull.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <tuple>

namespace hybrid::scene
{
  namespace
  {
    std::uint64_t mixed(std::uint64_t z)
    {
      z += 0x9e3779b97f4a7c15ull;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
      return z ^ (z >> 31);
    }


    std::uint64_t bits_of(const double value)
    {
      const double  no_negative_zero = value + 0.;
      std::uint64_t bits;
      std::memcpy(&bits, &no_negative_zero, sizeof(bits));
      return bits;
    }
  } // namespace


  Weibull::Weibull(const double shape)
    : m(shape)
    , s(1. / std::tgamma(1. + 1. / shape))
  {
    assert(shape > 0.);
  }


  double Weibull::quantile(const double u) const
  {
    return s * std::pow(-std::log1p(-u), 1. / m);
  }


  double number_of_place(const std::uint64_t seed, std::vector<Vec2> places)
  {
    std::sort(places.begin(), places.end(), [](const Vec2 &a, const Vec2 &b) {
      return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
    });
    std::uint64_t state = mixed(seed);
    for (const Vec2 &place : places)
      state = mixed(mixed(state ^ bits_of(place.x())) ^ bits_of(place.y()));
    return std::ldexp(static_cast<double>(state >> 11), -53);
  }
} // namespace hybrid::scene
